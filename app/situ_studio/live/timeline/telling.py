"""What stands at the timeline's cursor, in words, for whoever does not see it."""

from __future__ import annotations

from collections.abc import Sequence

from situ_studio.live.lanes import Lane
from situ_studio.live.timeline.bookmarks import Bookmark
from situ_studio.live.timeline.painting import StateName
from situ_studio.live.timeline.rows import TimelineRow
from situ_studio.wording.language import tr


def told_moment(
    when: str, t: float, rows: Sequence[TimelineRow], marks: Sequence[Bookmark], state: StateName
) -> str:
    """The time, the bookmarks there, the state of each application and the situation.

    when: the time as it is written. rows: those of the run that is looked at. state: what a
    designer calls an application's state.
    """
    told = [when, *(tr("bookmark {0}").format(mark.name) for mark in marks if mark.t == t)]
    for row in rows:
        if not isinstance(row.lane, Lane) or row.kind not in ("state", "situation"):
            continue
        value = row.lane.at(t)
        if row.kind == "situation":
            told.append(tr("situation {0}").format(value or tr("none")))
        elif value is not None:
            told.append(tr("{0}: {1}").format(row.name, state(row.name, value)))
    return ", ".join(told)
