"""Structurally broken certificates: one place of the JSON replaced, removed, doubled or added; and what kernels say.

    python -m verify.checkers.breakages --count 100000 --seed 5

Three kernels have to give the same verdict on each; the run ends at the first on which they differ.
"""

import argparse
import copy
import json
import random
from typing import Any

from proofs.check import FOLDER
from verify.checkers.kernels import accepted

BATCH = 2000  # pairs that the kernels are asked about at once
LARGEST = 20_000  # characters: of the stored pairs the shorter ones are broken
TEXTS = """x x^2 x^1 x^02 x^1000 x^-1 x^ ^2 ẋ pi root_1 cos(x) cos(x^2) cos() __proto__ constructor toString
    1 -1 0 -0 +1 01 1e0 0.5 1/2 2/4 1/-2 1/0 1/1 -1/2 --1 1_000 ١ = != > >= < assume show define root inverse ideal
    contradiction cases derivation refutation""".split()  # noqa: SIM905
TEXTS += ["", "x y", "x x", "x  y", " x", "x\n", "9" * 500, "9" * 501]
VALUES: list[Any] = [
    None,
    True,
    False,
    0,
    1,
    2,
    -1,
    7,
    0.5,
    10**5 + 1,
    2**53 + 1,
    10**400,
    [],
    {},
    [[]],
    [0],
    {"": "1"},
]
VALUES += [{"x": "1"}, {"x": 1}, {"": "0"}, [[0, {"": "1"}]], {"rule": "ideal", "cofactors": []}]
RAW = ["1.0", "1e0", "-0", "NaN", "1E400", '{"x":"1","x":"1"}', '"\\u0078"', "9007199254740993", "0.10"]


def places(tree: Any, path: tuple = ()) -> list[tuple]:
    """Return the paths of all places in a JSON tree."""
    children = tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ()
    return [path, *(p for key, child in children for p in places(child, (*path, key)))]


def broken(pair: list, rng: random.Random) -> str:
    """Return a text '[statement,certificate]' of the pair with one place broken."""
    tree = copy.deepcopy(pair)
    *way, last = rng.choice(places(tree)[1:])
    parent = tree
    for key in way:
        parent = parent[key]
    value, kind, raw = parent[last], rng.randrange(8) if way else 7, None
    if kind == 0:
        del parent[last]
    elif kind == 1 and isinstance(parent, dict):
        parent[rng.choice([*TEXTS, "of", "is", "new"])] = value
    elif kind == 1:
        parent.insert(last, copy.deepcopy(value))
    elif kind == 2 and isinstance(parent, dict):
        parent[rng.choice(TEXTS)] = parent.pop(last)
    elif kind == 3:
        parent[last], raw = "RAW", rng.choice(RAW)
    elif kind in (4, 5):
        parent[last] = rng.choice(TEXTS)
    elif kind == 6:
        other = pair
        for key in rng.choice(places(pair)):
            other = other[key]
        parent[last] = copy.deepcopy(other)
    else:
        parent[last] = rng.choice(VALUES)
    text = json.dumps(tree, separators=(",", ":"), ensure_ascii=False)
    return text if raw is None else text.replace('"RAW"', raw)


def stored() -> dict[str, dict]:
    """Return {theorem/claim/number: its stored statement, certificate and point} of everything that is stored."""
    return {
        f"{path.stem}/{claim['claim']}/{number}": entry
        for path in sorted(FOLDER.glob("*.json"))
        for claim in json.loads(path.read_text("utf-8"))["claims"]
        for number, entry in enumerate(claim["statements"])
    }


def campaign(count: int, seed: int) -> int:
    """Break `count` pairs; return how many all kernels accept. Raises AssertionError where two kernels differ."""
    rng, good = random.Random(seed), 0
    pairs = [[entry["statement"], entry["certificate"]] for entry in stored().values()]
    pairs = [pair for pair in pairs if len(json.dumps(pair)) <= LARGEST]
    for start in range(0, count, BATCH):
        texts = [broken(rng.choice(pairs), rng) for _ in range(min(BATCH, count - start))]
        for text, verdicts in zip(texts, accepted(texts), strict=True):
            assert len(set(verdicts.values())) == 1, f"{verdicts}: {text}"
            good += all(verdicts.values())
    return good


def main() -> None:
    """Parse the command line, run, print."""
    parser = argparse.ArgumentParser("python -m verify.checkers.breakages", description=__doc__)
    parser.add_argument("--count", type=int, default=100_000, help="broken pairs (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=5, help="of the draw (default: %(default)s)")
    options = parser.parse_args()
    good = campaign(options.count, options.seed)
    print(f"{options.count:,} pairs broken in one place: {good:,} still prove something, the kernels agree on each")


if __name__ == "__main__":
    main()
