"""The rows of a timeline: what each is about, in which order, and how high. No Qt."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from situ_studio.live.lanes import Lane, Lanes, Series

RowKind = Literal["state", "situation", "resource", "data"]

FIRST_DATA = 3
"""Data that are shown while nobody has chosen."""
HEIGHTS: dict[RowKind, int] = {"state": 28, "situation": 28, "resource": 26, "data": 46}


class TimelineRow(Struct, frozen=True):
    """name: of the application, resource or datum; "" for the situation. lane: what it shows.
    run: 0 of the run that is looked at, else of which one beside it.
    """

    kind: RowKind
    name: str
    lane: Lane | Series
    run: int = 0

    @property
    def height(self) -> int:
        return HEIGHTS[self.kind]


def rows_of(lanes: Lanes, chosen: frozenset[str] | None) -> list[TimelineRow]:
    """Each application, the situation, who holds each resource, data.

    chosen: the data that are shown; None: the first that came.
    """
    data = list(lanes.data)[:FIRST_DATA] if chosen is None else sorted(chosen & lanes.data.keys())
    return [
        *(TimelineRow("state", name, lane) for name, lane in lanes.states.items()),
        *([TimelineRow("situation", "", lanes.situation)] if lanes.situation.t else []),
        *(TimelineRow("resource", name, lane) for name, lane in lanes.holders.items()),
        *(TimelineRow("data", name, lanes.data[name]) for name in data),
    ]
