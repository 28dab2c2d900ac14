"""The conditions that a person gives breakpoints, until they stand on the robot."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from msgspec import Struct

from situ.document.condition import Condition
from situ_studio.live.breaking import Point, condition_of, point_of

Exchange = Callable[[Point, Condition | None], set[int]]
"""Asks the robot for breakpoints with that condition in place of those that are meant by one that
stands; the numbers of these."""


class _Sought(Struct):
    """sent: on its way, in place of those with the numbers ``going``. wanted: by the person."""

    where: Point
    sent: Condition | None
    wanted: Condition | None
    going: set[int]


class SoughtConditions:
    """The robot knows no other condition for a breakpoint that stands: it gets another one in its
    place, and tells of it a while later. So of each place one is on its way; of what is wanted
    meanwhile the last goes next. Else each would leave one behind at which the robot still pauses.
    """

    def __init__(self) -> None:
        self._every: list[_Sought] = []

    def want(self, one: Point, condition: Condition | None, exchange: Exchange) -> None:
        """one: as it stands."""
        found = self._at(one)
        if found is None:
            going = exchange(one, condition)
            if going:
                self._every.append(_Sought(point_of(one), condition, condition, going))
        else:
            found.wanted = condition

    def of(self, one: Point) -> Condition | None:
        """The condition as it is wanted there, else as it stands."""
        found = self._at(one)
        return condition_of(one) if found is None else found.wanted

    def told(self, standing: Sequence[Point], exchange: Exchange) -> None:
        """To be told whenever the robot tells what stands on it."""
        numbers = {one["id"] for one in standing}
        for sought in [one for one in self._every if not one.going & numbers]:
            here = [one for one in standing if point_of(one) == sought.where]
            if sought.wanted == sought.sent or not here:
                self._every.remove(sought)
                continue
            newest = max(here, key=lambda one: int(one["id"]))
            sought.sent = sought.wanted
            sought.going = exchange(newest, sought.wanted)

    def forget(self) -> None:
        """The robot refused something, or is gone: what stands there is what is shown."""
        self._every.clear()

    def _at(self, one: Point) -> _Sought | None:
        where = point_of(one)
        return next((sought for sought in self._every if sought.where == where), None)
