"""Exact linear programming, as far as sums of squares need it: some x ≥ 0 with A x = b, by the simplex method."""

from collections.abc import Hashable, Mapping, Sequence
from fractions import Fraction

Column = Mapping[Hashable, Fraction]
MAX_STEPS = 2000
RIGHT = -1  # the number of the column that the others have to add up to


def feasible(columns: Sequence[Column], target: Column) -> dict[int, Fraction] | None:
    """Return {column number: positive Fraction} with Σ x_j column_j = target, or None.

    columns and target are {row: Fraction}. Phase one of the simplex method with Bland's rule: it cannot cycle.
    """
    keys = sorted({key for column in (*columns, target) for key in column}, key=repr)
    signs = {key: -1 if target.get(key, 0) < 0 else 1 for key in keys}
    equations = {key: {RIGHT: signs[key] * target.get(key, Fraction(0))} for key in keys}
    for j, column in enumerate(columns):
        for key, value in column.items():
            equations[key][j] = signs[key] * value
    table = list(equations.values())
    basis: list[int | None] = [None] * len(keys)  # None: the row's artificial variable
    for _ in range(MAX_STEPS):
        artificial = [row for row, b in zip(table, basis, strict=True) if b is None]
        if not any(row.get(RIGHT) for row in artificial):
            return {b: row[RIGHT] for row, b in zip(table, basis, strict=True) if b is not None and row.get(RIGHT)}
        cost: dict[int, Fraction] = {}
        for row in artificial:
            for j, value in row.items():
                cost[j] = cost.get(j, 0) + value
        entering = min((j for j, value in cost.items() if value > 0 and j not in (RIGHT, *basis)), default=None)
        if entering is None:
            return None
        ratios = [
            (row.get(RIGHT, 0) / row[entering], -1 if basis[i] is None else basis[i], i)
            for i, row in enumerate(table)
            if row.get(entering, 0) > 0
        ]
        _, _, leaving = min(ratios)
        _pivot(table, leaving, entering)
        basis[leaving] = entering
    return None


def _pivot(table, leaving, entering):
    scale = 1 / table[leaving][entering]
    table[leaving] = {j: scale * value for j, value in table[leaving].items()}
    for i, row in enumerate(table):
        factor = row.get(entering, 0)
        if i != leaving and factor:
            for j, value in table[leaving].items():
                row[j] = row.get(j, 0) - factor * value
                if not row[j]:
                    del row[j]
