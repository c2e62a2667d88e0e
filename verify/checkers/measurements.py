"""Theorems without claims: their measurements, sampled or enclosed in balls, and the grade that these reach.

proved     Coq's record has every statement that is pinned, as it was read, and every claim of float64; what is
           measured beside holds
certified  everything is an enclosure, over whole ranges, of what the theorem's words state, and rejects false variants
measured   every measurement holds on its samples, and rejects its false variants

A measurement is a function in a module of the project's package of them:

    @measures("theorem_id", false={"half the bound": {"bound": 5}})
    def bound_holds(bound=10):
        ...
        return Measurement(errors, bound, "…", seed=7)

The function takes its claim as parameters, with the true one as their defaults; `false` names variants of the claim
that the same function has to reject, at least one. A run calls both. The function returns one of two kinds of
evidence: a `Measurement` of finitely many samples, which the run counts and of which it takes the worst, or an
`Enclosure`, which the run takes apart and tries; nobody declares either.
"""

import importlib
import math
import pkgutil
import re
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property, partial
from html.entities import html5
from types import FunctionType
from typing import Any

import numpy as np

from proofs.engine.project import PROJECT
from proofs.engine.theorem import Theorem
from verify.checkers.grades import Examination
from verify.optional import arb, lacking

DIGITS, SEED, TRIED, PLACES = 6, 5, 64, 6
WIDEST = 1e-9  # a ball that stands for one number
MEASURING = tuple(f"{package}." for package in PROJECT.measuring)
FALSE = "what is claimed does not hold, or a piece may exceed the bound"
FUNCTIONS = FunctionType, type(cache(len))  # a function, and one with a cache
SYMBOL = re.compile(r"(\\[a-zA-Z]+|[a-zA-Z])(_\{[^}]*\}|_\w)?")
REGISTERED: dict[str, list[tuple[Callable, dict]]] = {}
"""{theorem's id: [(function, {text: keyword arguments of a false variant})]}, once `measurements` has imported all"""


@dataclass(frozen=True)
class Measurement:
    """One measurement: values of each case, drawn with `seed` (None: nothing is random), and a bound.

    values: numbers, one or more a case, whose sizes may be `bound` at most. holds: whether all else that is claimed
    does.
    """

    values: Any
    bound: Any
    quantity: str
    seed: int | None = None
    holds: bool = True

    @property
    def samples(self) -> int:
        """The number of values."""
        return np.size(self.values)

    @property
    def worst(self) -> float:
        """The largest size of them."""
        return float(np.max(np.abs(self.values), initial=0.0))

    def why_refused(self) -> str:
        """Return why this is no evidence, "" where it is: there are values, all finite and within a finite bound."""
        values = np.asarray(self.values)
        if not self.quantity or len(np.unique(values)) < 2:
            return f"{values.size} cases of {self.quantity!r}, none unlike another"
        if not (math.isfinite(self.worst) and math.isfinite(self.bound)):
            return "the worst, or its bound, is no finite number"
        return "" if self.holds and self.worst <= self.bound else FALSE


@dataclass(frozen=True)
class Enclosure:
    """The largest value of a quantity on each piece of the ranges of its argument: the statement that is enclosed.

    over: {variables, as the theorem's words write them: ranges (low, high) of floats}. pieces: a function that returns
    them, (low, high, most), arbs or exact numbers; together they are all of the first of `over`, and `most` holds
    whatever the others are. at: a function of arrays of arguments, one for each of `over`, that returns the quantity
    there, computed in another way. Both are of `verify`: nobody writes pieces down. bound: what all of it is at most,
    exactly, as the theorem says.
    """

    pieces: Callable[[], Sequence[tuple[Any, Any, Any]]]
    over: dict[str, tuple[tuple[float, float], ...]]
    at: Callable[..., np.ndarray]
    bound: Any
    quantity: str
    seed = None

    @cached_property
    def enclosed(self) -> Sequence[tuple[Any, Any, Any]]:
        """The pieces."""
        return self.pieces()

    @property
    def samples(self) -> int:
        """The number of pieces: nothing is sampled."""
        return len(self.enclosed)

    @property
    def worst(self) -> Any:
        """The largest value that a piece allows, as a ball."""
        return max((_ball(most) for *_, most in self.enclosed), key=lambda most: float(most.upper()))

    def why_refused(self) -> str:
        """Return why this encloses nothing, "" where it does."""
        functions = [f.func if isinstance(f, partial) else f for f in (self.at, self.pieces)]
        if not all(isinstance(f, FUNCTIONS) and f.__module__.startswith(MEASURING) and _is_there(f) for f in functions):
            return f"the quantity, or what encloses it, is no function of {' or '.join(MEASURING)}"
        numbers = [*(number for piece in self.enclosed for number in piece), self.bound]
        if not self.quantity or not self.enclosed or not self.over or not all(self.over.values()):
            return "nothing is enclosed"
        if not all(isinstance(n, arb | int | Fraction) and _ball(n).is_finite() for n in numbers):
            return "an end, a value or the bound is no finite ball and no exact number"
        if not all(_ball(end).rad() < WIDEST for *ends, _ in self.enclosed for end in ends):
            return "an end of a piece is a ball that is too wide for one number"
        first, *others = self.over.values()
        if not all(low < high and self._covers(low, high) for low, high in first):
            return f"the pieces are not all of {first}"
        if not all(_ball(most) <= _ball(self.bound) for *_, most in self.enclosed):
            return FALSE
        return "" if self._tried(others) else "a value of the quantity is outside of its piece's enclosure"

    def _covers(self, low, high):
        """Return whether one piece begins where another one ended, from `low` to `high`."""
        for first, last, _ in sorted(self.enclosed, key=lambda piece: float(piece[0])):
            low = float(last) if float(first) <= low < float(last) else low
        return low >= high

    def _tried(self, others):
        """Return whether the quantity, at random points in the pieces and of the other arguments, is within them."""
        low, high, most = np.array([[float(number) for number in piece] for piece in self.enclosed]).T
        random = np.random.default_rng(SEED)
        shares = random.uniform(0.01, 0.99, (max(2, TRIED // len(low)), len(low)))
        which = random.integers(PLACES, size=shares.shape)
        elsewhere = [random.uniform(*ranges[random.integers(len(ranges))], PLACES)[which] for ranges in others]
        sizes = self.at(low + (high - low) * shares, *elsewhere)
        return sizes.shape == shares.shape and bool((np.abs(sizes) <= most).all())


def _is_there(function):
    """Return whether a function is the one that its module has by its name: no local function, no partial."""
    return vars(sys.modules.get(function.__module__, object)).get(function.__name__) is function


def _ball(number):
    return arb(number.numerator) / number.denominator if isinstance(number, Fraction) else arb(number)


def record(evidence: Measurement | Enclosure) -> dict[str, Any]:
    """Return what the report keeps, with numbers rounded so that they do not depend on the machine's last bits.

    Errors are rounded to one digit: more would depend on the machine's libm.
    """
    certified = isinstance(evidence, Enclosure)
    entry = {"samples": evidence.samples, "seed": evidence.seed, "certified": certified, "what": evidence.quantity}
    return entry | {"worst": rounded(evidence.worst, DIGITS if certified else 1), "bound": rounded(evidence.bound)}


def variables(tex: str) -> set[str]:
    """Return the variables in TeX: letters, Greek ones too, with their subscripts; but π, and e with a power."""
    symbols = SYMBOL.findall(re.sub(r"\\operatorname\{.*?\}|e\^", "", tex))
    return {
        name + below
        for name, below in symbols
        if name != r"\pi" and (len(name) == 1 or "α" <= html5.get(f"{name[1:]};", "") <= "ϵ")
    }


def unnamed(words: str, over: Iterable[str]) -> set[str]:
    """Return the variables in a theorem's words that are none of `over`, nor equal to something ($x = …)."""
    formulas = " ".join(re.findall(r"\$(.*?)\$", words, re.DOTALL))
    defined = re.findall(r"\$(\S+) = ", words)
    return variables(formulas).difference(*map(variables, [*over, *defined]))


def says(words: str, bound: Any) -> bool:
    """Return whether a number stands in a theorem's words."""
    return float(bound) in map(float, re.findall(r"\d+(?:\.\d+)?", words))


def rounded(value: Any, digits: int = DIGITS) -> float:
    """Return a number to some significant digits; a ball is rounded from its upper end."""
    value = value.upper() if isinstance(value, arb) else value
    return float(f"{float(value):.{digits}g}")


def measures(theorem_id: str, false: dict[str, dict[str, Any]]) -> Callable[[Callable], Callable]:
    """Register a function as evidence of a theorem. false: {text: keyword arguments} of claims it has to reject."""
    if not false:
        raise ValueError(f"{theorem_id}: a measurement needs a false variant that it rejects")

    def register(function):
        REGISTERED.setdefault(theorem_id, []).append((function, dict(false)))
        return function

    return register


@cache
def library_needed() -> str | None:
    """Import every module of measurements; return the library whose lack prevents that, or None."""
    try:
        for module in pkgutil.iter_modules([str(PROJECT.folder(PROJECT.measurements))]):
            importlib.import_module(f"{PROJECT.measurements}.{module.name}")
    except ImportError as error:
        if library := lacking(error):
            return library
        raise
    return None


def measurements() -> dict[str, list[tuple[Callable, dict]]]:
    """Return {theorem's id: its measurements} of every module of measurements that can be imported here."""
    library_needed()
    return REGISTERED


def examine(theorem: Theorem) -> Examination:
    """Return the Examination of a theorem without claims."""
    examination = Examination(theorem.id, theorem.expected, theorem.uses)
    examination.check_sources(theorem)
    evidence = [(function(), function, false) for function, false in measurements().get(theorem.id, ())]
    examination.record["measurements"] = [_measured(examination, theorem, *entry) for entry in evidence]
    examination.reached = "proved"
    if not (theorem.pinned or theorem.rounded):
        enclosed = [one for one, *_ in evidence if isinstance(one, Enclosure)]
        examination.reached = "certified" if evidence and len(enclosed) == len(evidence) else "measured"
        missing = unnamed(theorem.words, [name for one in enclosed for name in one.over])
        if examination.reached == "certified" and missing:
            examination.problems.append(f"nothing is enclosed over {', '.join(sorted(missing))}")
        if not evidence:
            examination.problems.append(f"no measurement is registered for it in {PROJECT.measurements}")
    examination.record["grade"] = examination.grade
    return examination


def _measured(examination, theorem, evidence, function, false):
    """Judge the values of a measurement, and run its false variants, which it has to reject."""
    rejected: list[dict] = []
    why = evidence.why_refused()
    if isinstance(evidence, Enclosure) and not says(theorem.words, evidence.bound):
        why = why or "the theorem's words do not state this bound"
    if why:
        examination.problems.append(f"{evidence.quantity}: {why}: worst {evidence.worst}, bound {evidence.bound}")
    for text, changes in false.items():
        rejected.append({"variant": text, "rejected": function(**changes).why_refused() == FALSE})
        examination.mutants += 1
        examination.mutants_killed += rejected[-1]["rejected"]
        if not rejected[-1]["rejected"]:
            examination.problems.append(f"{evidence.quantity}: does not reject the false variant “{text}”")
    return record(evidence) | {"false_variants": rejected}
