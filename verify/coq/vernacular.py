"""Commands that a file of `proofs/formal/` written by hand may give to Coq: definitions, lemmas, tactics and proofs.

Refused are all that could change how a statement is read: notations, coercions, arguments that are not shown,
canonical structures, instances, modules, flags; and a name that anything has which Coq loads beside the file.
"""

import re
from collections.abc import Mapping

LIBRARIES = {"Coq", "Coquelicot", "Flocq", "Interval", "Formal"}
FIRST_WORDS = re.compile(
    r"(?:Theorem|Lemma|Definition|Fixpoint|Inductive|Let|Ltac|Section|End|Variables?|Hypothes[ie]s|Proof|Qed)\b"
    rf"|From (?:{'|'.join(sorted(LIBRARIES))}) Require (?!Export\b)[\w. ]+$|Open Scope R_scope$|Import ListNotations$"
)
GLOBAL = re.compile(r"(?:Theorem|Lemma|Definition|Fixpoint|Inductive|Ltac) +([\w']+)")
DEFINITION = re.compile(r"(?:Definition|Fixpoint|Inductive) +([\w']+)")
LOCAL = re.compile(r"(?:Let|Section) +([\w']+)")
BINDING = re.compile(r"(?:Variables?|Hypothes[ie]s) ")
SAID = re.compile(r"(?:Theorem|Lemma|Definition|Fixpoint|Inductive|Let|Variables?|Hypothes[ie]s)\b")
HIDDEN = re.compile(r":>|`|@\{|\{\s*[\w' ]+[:}]|\[\s*[\w' ]+[:\]]")  # a coercion, a universe, what is not shown
UNSHOWN = re.compile(r":>|\b(?:fun|fix|cofix|forall)\b[^=]*[{[`]")  # of what is defined
OPENING = re.compile(r"\A(?:[{}+*\s-]|(?:\d+|\[[\w']+\]|!|all|par)\s*:\s*(?=\{))+")  # bullets, and braces of some goal
ODD = re.compile(r'"|\(\*\)')
NAMELESS = re.compile(r"\b(?:transparent_)?abstract\b")  # a tactic that gives a name


class Unreadable(ValueError):
    """The error that a file could change how a statement is read."""


def sentences(text: str) -> list[str]:
    """Return a file's sentences, without comments, bullets and braces.

    Raises Unreadable where a quotation mark or (*) stands in it, with which Coq's comments could end elsewhere, or, but
    for comments, a letter that is not ASCII: it could look like another.
    """
    if unlike := ODD.search(text):
        raise Unreadable(unlike[0])
    bare, depth = [], 0
    for part in re.split(r"(\(\*|\*\))", text):
        if part == "(*":
            depth += 1
            bare.append(" ")  # as Coq has it: a comment parts words
        elif part == "*)" and depth:
            depth -= 1
        elif not depth:
            bare.append(part)
    if depth:
        raise Unreadable("a comment without an end")
    if not (bare_text := "".join(bare)).isascii():
        raise Unreadable("".join(filter(lambda letter: not letter.isascii(), bare_text)))
    parts = (OPENING.sub("", sentence) for sentence in re.split(r"\.(?=\s|$)", bare_text))
    return [" ".join(sentence.split()) for sentence in parts if sentence]


def check(text: str) -> None:
    """Raise Unreadable unless every command of a file is one of those that may be said."""
    for sentence in sentences(text):
        tactic = sentence[0] in "[(!" or (sentence[0].isascii() and sentence[0].isalnum() and not sentence[0].isupper())
        words = re.findall(r"[\w']+", sentence)
        head, _, body = sentence.partition(":=")
        # The rules of what is inductive are said in its body, and there a record's fields have names.
        ruled = sentence.startswith("Inductive") and (HIDDEN.search(body) or "{" in body)
        hidden = HIDDEN.search(head) or UNSHOWN.search(body) or ruled
        hiding = SAID.match(sentence) and (hidden or words.count("with") > words.count("match"))
        if hiding or NAMELESS.search(sentence) or not (tactic or FIRST_WORDS.match(sentence)):
            raise Unreadable(sentence)


def named(text: str) -> list[str]:
    """Return the names that a file gives, those of a section's variables included."""
    names = []
    for sentence in sentences(text):
        if match := GLOBAL.match(sentence) or LOCAL.match(sentence):
            names += [match[1], *_of_inductive(sentence, match[1])]
        elif match := BINDING.match(sentence):
            bound = sentence[match.end() :]
            groups = re.findall(r"\(([\w' ]+):", bound) if bound.startswith("(") else [bound.partition(":")[0]]
            names += [name for group in groups for name in group.split()]
    return names


def defined(text: str) -> list[str]:
    """Return the names that a file defines, lemmas aside: statements may be made of these."""
    return [match[1] for sentence in sentences(text) if (match := DEFINITION.match(sentence))]


def _of_inductive(sentence, name):
    """Return the names of an inductive predicate's rules, and those that Coq gives for it."""
    if not sentence.startswith("Inductive "):
        return []
    rules = re.findall(r"(?:\||:=)\s*([A-Za-z_][\w']*)", sentence)
    return [*rules, *(f"{name}_{end}" for end in ("ind", "rec", "rect", "sind"))]


def given_twice(texts: Mapping[str, str]) -> list[str]:
    """Return the names that two files give, or one file twice outside of a section."""
    earlier: set[str] = set()
    twice = []
    for text in texts.values():
        names = {match[1] for sentence in sentences(text) if (match := GLOBAL.match(sentence))}
        twice += sorted(names & earlier)
        earlier |= names
    return twice
