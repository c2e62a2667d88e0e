"""Printer of claims as propositions for Coq to prove.

    Definition ID__CLAIM : Prop := forall symbols, let lines in hypotheses -> needs and conclusions.

Coq divides by 0, takes the root of −1, and has some number for a derivative that does not exist. No claim is about such
a value: divisors are not 0, radicands not negative, and derivatives exist. The kernel asks it by name, and here each
such need stands before the conclusions (`StatementPrinter.needs`). Of a refuted theorem the negation is printed:
hypotheses and needs hold somewhere, and the conclusion does not. A cited lemma is no hypothesis: Coq has to prove it. A
Separation, about the names that a program reads and not about numbers, is the kernel's alone.
"""

from collections.abc import Iterable

from sympy import Abs, And, Basic, Derivative, Max, Min, Or, Piecewise, Pow, Symbol, false, floor, sign, sympify, true
from sympy.core.relational import Relational

from proofs.engine.claim import AnyClaim, Claim, Encloses, Induction, Rounded
from proofs.engine.names import symbols_of
from proofs.engine.theorem import Theorem
from proofs.printers.coq import CoqPrinter, wrapped

HEADER = """(* Printed from proofs/theorems by `python -m renderer.generate`. Do not edit: change the claim instead.
   Each definition is one claim: what is written by hand proves it, and is compiled afterwards. *)

From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Float Float64.
Open Scope R_scope.
"""
OPERATORS = {"==": "=", "!=": "<>"}  # where Coq has another sign
COQ_WORDS = """as at by cofix else end exists exists2 fix for forall fun if IF in let match mod Prop return Set then
    Type using where with"""
CORNERS = Abs, Max, Min, Piecewise, floor, sign
"""Functions that may lack a derivative at a point, where Coq's `Derive` is some number all the same."""
MEANT = """R Rbar nat S INR IZR Int_part Finite is_finite p_infty real sin cos PI sqrt Rabs Rmax Rmin sign power exp ln
    atan2 atan2pi both either differ Rle_dec Rlt_dec Req_EM_T Rbar_le_dec Rbar_lt_dec Rbar_le Rbar_lt
    Derive Derive_n ex_derive ex_derive_n"""
TAKEN = frozenset(f"{COQ_WORDS} {MEANT}".split())
"""Words of Coq's, and the names that a printed term means something by."""


class StatementPrinter(CoqPrinter):
    """A printer of terms, relations, and the conditions for an expression to have a value.

    spelled: {symbol: term} of those not printed by their own name. coq_names: {symbol: the name that binds it}.
    """

    def __init__(self, symbols: Iterable[Symbol], spelled: dict[Symbol, str] | None = None):
        super().__init__()
        names = {s: f"{s.name}_" if s.name in TAKEN else s.name for s in symbols}
        if len(set(names.values())) < len(names):
            raise ValueError(f"two of {', '.join(sorted(names.values()))} have one name in Coq")
        self.coq_names = names
        self.spelled = names | (spelled or {})

    def _print_Symbol(self, symbol):
        return self.spelled[symbol]

    def _print_Piecewise(self, expr):
        return f"({super()._print_Piecewise(expr)})"

    def _print_Derivative(self, expr):
        return f"({self._of_derivative('Derive', expr)})"

    def _of_derivative(self, function, expr):
        """Return `function`, Derive or ex_derive, of an expression as a function of a symbol, at that symbol."""
        (x, count), *others = expr.variable_count
        if others or (count > 1 and expr.expr.has(*CORNERS)):
            raise ValueError(f"no proposition for a derivative by several symbols, or a second one of corners: {expr}")
        name, times = self.spelled[x], "" if count == 1 else f" {count}"
        return f"{function}{'_n' if times else ''} (fun {name} : R => {self._print(expr.expr)}){times} {name}"

    def relation(self, relation: Basic) -> str:
        """Return a relation, or several, as a proposition."""
        if relation in (true, false):
            return "True" if relation else "False"
        if isinstance(relation, And | Or):
            joined = (" /\\ " if isinstance(relation, And) else " \\/ ").join(
                self.relation(part) for part in sorted(relation.args, key=str)
            )
            return f"({joined})"
        if not isinstance(relation, Relational):
            raise ValueError(f"no proposition for {relation}")
        sign = OPERATORS.get(relation.rel_op, relation.rel_op)
        return f"{self._print(relation.lhs)} {sign} {self._print(relation.rhs)}"

    def needs(self, expression: Basic) -> list[str]:
        """Return the conditions for an expression to have a value, from the inside out, as the kernel asks them.

        A derivative has to exist, and not at the edge of a root: beyond it Coq's root is 0.
        """
        if isinstance(expression, Piecewise):
            return self._needs_of_cases(expression)
        conditions = [need for argument in expression.args for need in self.needs(argument)]
        if isinstance(expression, Pow):
            conditions += self._needs_of_power(expression.base, expression.exp)
        elif isinstance(expression, Derivative):
            roots = sorted((p.base for p in expression.atoms(Pow) if not p.exp.is_Integer), key=str)
            conditions += [f"{self._print(base)} > 0" for base in roots]
            conditions.append(self._of_derivative("ex_derive", expression))
        return conditions

    def _needs_of_power(self, base, exponent):
        if exponent.is_Symbol:
            return [f"{self._print(base)} >= 0", f"{self._print(exponent)} > 0"]
        if not (exponent.is_Rational and (2 * exponent).is_Integer):
            raise ValueError(f"what {base} to the power {exponent} needs is not known")
        positive = base.is_number and base.is_positive
        radicand = [] if positive or exponent.is_Integer else [f"{self._print(base)} >= 0"]
        return radicand + ([] if positive or exponent > 0 else [f"{self._print(base)} <> 0"])

    def _needs_of_cases(self, cases):
        """Return the needs of a Piecewise's cases: those of a case hold where no earlier condition does."""
        conditions, before = [], []
        for value, condition in cases.args:
            asked = [] if condition == true else self.needs(condition)
            conditions += [_implied(before, need) for need in asked]
            here = before if condition == true else [*before, self.relation(condition)]
            conditions += [_implied(here, need) for need in self.needs(value)]
            before = [*before, f"~ ({self.relation(condition)})"] if condition != true else before
        return conditions


def _implied(conditions, need):
    return f"({' -> '.join([*conditions, need])})" if conditions else need


def _symbols(expressions):
    """Return the symbols that stand in expressions; SymPy has none by which a constant is differentiated."""
    return sorted(symbols_of(expressions), key=str)


def _forall(names, sort):
    return f"forall {' '.join(names)} : {sort}," if names else ""


def _implication(opening, hypotheses, conjuncts):
    lines = [*opening, *(f"{part} ->" for part in hypotheses), " /\\\n  ".join(conjuncts)]
    return "\n  ".join(filter(None, lines))


def claim_proposition(claim: Claim, refuted: bool = False) -> str:
    """Return a Claim as a proposition, or its negation. Raises ValueError where it has no form in Coq."""
    _, program = claim.names()
    lines = list(program.definitions) if program else []
    expressions = [*claim.given, *claim.shows, *(e for line in lines for e in line)]
    symbols = _symbols(expressions)
    printer = StatementPrinter(symbols)
    defined = {symbol for symbol, _ in lines}
    inputs = [s for s in symbols if s not in defined]
    opening = [_forall([printer.coq_names[s] for s in inputs], "R")]
    opening += [f"let {printer.coq_names[s]} := {printer.doprint(e)} in" for s, e in lines]
    needs = [need for e in (*(e for _, e in lines), *claim.given, *claim.shows) for need in printer.needs(e)]
    needs = list(dict.fromkeys(needs))
    hypotheses, conclusions = (list(map(printer.relation, relations)) for relations in (claim.given, claim.shows))
    if refuted:
        return f"~ (\n  {_implication(opening, [*hypotheses, *needs], conclusions)})"
    return _implication(opening, hypotheses, [*needs, *conclusions])


def induction_proposition(claim: Induction) -> str:
    """Return an Induction as a proposition about all sequences that start and continue as its states do."""
    states = [(state, sympify(start), sympify(following)) for state, start, following in claim.states]
    expressions = (*claim.given, *claim.shows, *(e for state in states for e in state))
    symbols = _symbols([*expressions, claim.n])
    plain = StatementPrinter(symbols)
    n = plain.coq_names[claim.n]
    at = {claim.n: f"INR {n}"} | {state: f"{plain.coq_names[state]} {n}" for state, *_ in states}
    printer = StatementPrinter(symbols, at)
    opening = [_forall([plain.coq_names[s] for s in symbols if s not in at], "R")]
    opening += [_forall([plain.coq_names[state] for state, *_ in states], "nat -> R")]
    given = [plain.relation(relation) for relation in claim.given]
    for state, start, following in states:
        name = plain.coq_names[state]
        given.append(f"{name} 0%nat = {plain.doprint(start)}")
        given.append(f"(forall {n} : nat, {name} (S {n}) = {printer.doprint(following)})")
    if any(map(printer.needs, expressions)):
        raise ValueError(f"{claim.name}: a radical or a quotient in an induction")
    first, *others = map(printer.relation, claim.shows)
    return _implication(opening, given, [f"forall {n} : nat,\n  {first}", *others])


def rounded_proposition(claim: Rounded) -> str:
    """Return a Rounded as a proposition: of float64 inputs, the program in float64 is near that in real numbers."""
    program = claim.program
    inputs = [s for s in program.inputs if s in program.reaches(*(output for output, _ in claim.bounds))]
    printer = StatementPrinter(inputs)
    names = [printer.coq_names[s] for s in inputs]
    given = [*(f"float64 {name}" for name in names), *map(printer.relation, claim.given)]
    shown = []
    for output, bound in claim.bounds:
        arguments = " ".join(printer.coq_names[s] for s in inputs if s in program.reaches(output))
        computed, exact = (f"{program.name}{kind}.{output.name} {arguments}" for kind in ("_float64", ""))
        shown.append(f"Rabs ({computed} - {exact}) <= {printer.doprint(bound)}")
    return _implication([_forall(names, "R")], given, shown)


SLACK = "(1 + 1 / 2 ^ 49)"
"""The share by which a count of roundings is too small after one more operation, as `renderer.machines` says."""


def enclosing_proposition(claim: Encloses) -> str:
    """Return an Encloses as a proposition: where inputs are within their counts of roundings, the result is, too."""
    program = claim.program
    names = [s.name for s in program.inputs]
    exact = {s: f"{s.name}_exact" for s in program.inputs}
    opening = [_forall(["slack", *(f"{name}{end}" for name in names for end in ("", "_error", "_exact"))], "R")]
    given = ["1 <= slack", "slack <= 1 + 3 / 2 ^ 22"]
    for name in names:
        given += [f"float64 {name}", f"float64 {name}_error", f"0 <= {name}_error"]
        given.append(f"Rabs ({name} - {name}_exact) <= slack * ({name}_error / 2 ^ 53)")
    plain, printer = StatementPrinter(_symbols(claim.given)), StatementPrinter(program.inputs, exact)
    given += map(plain.relation, claim.given)
    ((output, expression),) = program.definitions
    module = f"{program.name}_float64.{output.name}"
    value = " ".join([module, *names])
    error = " ".join([f"{module}_error", *(f"{name} {name}_error" for name in names)])
    near = f"Rabs ({value} - ({printer.doprint(expression)})) <= slack * {SLACK} * ({error} / 2 ^ 53)"
    return _implication(opening, given, [*printer.needs(expression), f"float64 ({error})", f"0 <= {error}", near])


def proposition(claim: AnyClaim, refuted: bool = False) -> str | None:
    """Return a claim, or its negation, as a proposition, None where it is the kernel's alone."""
    if isinstance(claim, Induction):
        text = induction_proposition(claim)
        return f"~ (\n  {text})" if refuted else text
    return claim_proposition(claim, refuted) if isinstance(claim, Claim) else None


def statements(theorem: Theorem) -> dict[str, str]:
    """Return {name: proposition} of the claims of a theorem that are printed."""
    refuted = theorem.expected == "refuted"
    texts = {f"{theorem.id}__{claim.name}": proposition(claim, refuted) for claim in theorem.claims}
    printed = {name: text for name, text in texts.items() if text is not None}
    for claim in theorem.rounded:
        text = rounded_proposition(claim) if isinstance(claim, Rounded) else enclosing_proposition(claim)
        printed[f"{theorem.id}__{claim.name}"] = text
    return {name: wrapped(text) for name, text in printed.items()}


def statements_of(theorems: Iterable[Theorem]) -> str:
    """Return the text of a file of Coq's with every printed claim of some theorems."""
    texts: dict[str, str] = {}
    for theorem in theorems:
        printed = statements(theorem)
        if "__" in theorem.id or not all(name.isidentifier() and name not in texts for name in printed):
            raise ValueError(f"{theorem.id}: one of {', '.join(printed)} is no name in Coq, or another theorem's")
        texts |= printed
    return HEADER + "".join(f"\nDefinition {name} : Prop :=\n  {text}.\n" for name, text in texts.items())
