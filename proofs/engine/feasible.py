"""Exact linear programming, as far as sums of squares need it: some x ≥ 0 with A x = b, by the simplex method."""

from collections.abc import Hashable, Mapping, Sequence
from fractions import Fraction

Column = Mapping[Hashable, Fraction]
MAX_STEPS = 2000


def feasible(columns: Sequence[Column], target: Column) -> dict[int, Fraction] | None:
    """Return {column number: positive Fraction} with Σ x_j column_j = target, or None.

    columns and target are {row: Fraction}. Phase one of the simplex method with Bland's rule: it cannot cycle.
    """
    rows = sorted({row for column in (*columns, target) for row in column}, key=repr)
    index = {row: i for i, row in enumerate(rows)}
    sign = [-1 if target.get(row, 0) < 0 else 1 for row in rows]
    table: list[dict[int, Fraction]] = [{} for _ in rows]
    for j, column in enumerate(columns):
        for row, value in column.items():
            table[index[row]][j] = sign[index[row]] * value
    right = [sign[i] * target.get(row, Fraction(0)) for i, row in enumerate(rows)]
    basis: list[int | None] = [None] * len(rows)  # None: the row's artificial variable
    for _ in range(MAX_STEPS):
        if not any(right[i] for i, b in enumerate(basis) if b is None):
            return {b: right[i] for i, b in enumerate(basis) if b is not None and right[i]}
        cost: dict[int, Fraction] = {}
        for i, b in enumerate(basis):
            if b is None:
                for j, value in table[i].items():
                    cost[j] = cost.get(j, 0) + value
        entering = min((j for j, value in cost.items() if value > 0 and j not in basis), default=None)
        if entering is None:
            return None
        ratios = [
            (right[i] / row[entering], -1 if basis[i] is None else basis[i], i)
            for i, row in enumerate(table)
            if row.get(entering, 0) > 0
        ]
        _pivot(table, right, min(ratios)[2], entering)
        basis[min(ratios)[2]] = entering
    return None


def _pivot(table, right, leaving, entering):
    scale = 1 / table[leaving][entering]
    table[leaving] = {j: scale * value for j, value in table[leaving].items()}
    right[leaving] *= scale
    for i, row in enumerate(table):
        factor = row.get(entering, 0)
        if i != leaving and factor:
            for j, value in table[leaving].items():
                row[j] = row.get(j, 0) - factor * value
                if not row[j]:
                    del row[j]
            right[i] -= factor * right[leaving]
