"""The tolerance that each number states: how far it may move between releases without being named."""

from fnmatch import fnmatchcase
from functools import cache
from pathlib import Path

from book.assembly.stamps import table_in

RULES = Path(__file__).with_name("tolerances.toml")
ANY = "any"  # of a label, which may be anything


@cache
def rules(path: Path = RULES) -> dict:
    """The file of rules; ValueError where a rule lacks its reason or its tolerance is not a number ≥ 0."""
    content = table_in(path)
    for rule in content["rule"]:
        if not rule.get("why", "").strip():
            raise ValueError(f"{path.name}: the rule for {rule['numbers']} needs a why")
        if not rule["within"] >= 0:
            raise ValueError(f"{path.name}: within = {rule['within']} is not allowed: a number ≥ 0, or inf")
    return content


def tolerance(name: str, value: int | float | str | bool) -> float | str:
    """The tolerance of a number: relative, 0 for exact, "any" for a label."""
    for rule in rules()["rule"]:
        if any(fnmatchcase(name, pattern) for pattern in rule["numbers"]):
            if rule["within"] == float("inf"):
                return ANY
            return 0 if isinstance(value, str | bool) else rule["within"]
    return rules()["floats"] if isinstance(value, float) else 0


def is_within(before: int | float | str | bool, after: int | float | str | bool, allowed: float | str) -> bool:
    """Whether a number is still what it was, as far as its tolerance says."""
    if allowed == ANY or (before == after and type(before) is type(after)):
        return True
    if isinstance(before, str | bool) or isinstance(after, str | bool):
        return False
    return abs(after - before) <= float(allowed) * max(abs(before), abs(after))
