"""Still values: what no step of ε or β changes, kept by one drawing of A and read by those that follow.

A value is still if all that it is made of is. Two functions are traced from the same operations: the first one stores a
still value where a moving one needs it, the second loads it there. The bits are the same; what led to it is left out.
"""

from collections.abc import Hashable, Sequence
from typing import NamedTuple

MOVING = ("eps", "beta")  # of the scene's numbers
DEAR = 60  # operations: what is made of fewer is made again, which takes less than to read it
SLOW = ("fdiv", "sqrt")  # always kept
OF_PICTURE, OF_WAY, OF_LIGHT = 2, 3, 2  # vectors that a group of pixels keeps: of any picture, by a way, for each light


class Still(NamedTuple):
    """What a still value is: the same key for the same operations; how many they are; whether it is of one light."""

    key: int
    cost: int = 0
    of_light: bool = False


class Stills:
    """The slots of the still values, for all functions that share them.

    alternative: which one of those that are chosen from is traced, or None; they share slots, as a picture has one.
    """

    def __init__(self) -> None:
        self.alternative: Hashable = None
        self._keys: dict[Hashable, int] = {}
        self._slots: dict[Hashable, dict[int, int]] = {}

    def input(self, what: Hashable, of_light: bool = False) -> Still:
        """Return the Still of an input of the function or of a constant, by its name or number."""
        return Still(self._keys.setdefault(what, len(self._keys)), of_light=of_light)

    def made(self, instruction: str, operands: Sequence[Still | None]) -> Still | None:
        """Return the Still of what an instruction makes of others'; None if one of them is None and moves."""
        stills = [one for one in operands if one]
        if len(stills) < len(operands):
            return None
        made = self.input((instruction, *(one.key for one in stills)), any(one.of_light for one in stills))
        return made._replace(cost=1 + sum(one.cost for one in stills))

    def slot(self, still: Still, new: bool) -> int | None:
        """Return the number of the vector that holds a Still, counted from its group's first vector.

        For a Still of a light it is the number under the first light; each further light has OF_LIGHT vectors more.
        None if all vectors are taken, or if it has none yet and may not be `new`: then it is computed again.
        """
        slots = self._slots.setdefault((self.alternative, still.of_light), {})
        first, room = (0, OF_PICTURE) if self.alternative is None else (OF_PICTURE, OF_WAY)
        if still.of_light:
            first, room = OF_PICTURE + OF_WAY, OF_LIGHT
        if new and len(slots) < room:
            slots.setdefault(still.key, len(slots))
        return first + slots[still.key] if still.key in slots else None


def vectors(lights: int) -> int:
    """Return how many vectors a group of pixels keeps under so many lights."""
    return OF_PICTURE + OF_WAY + OF_LIGHT * lights
