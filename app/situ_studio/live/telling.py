"""What becomes of the robot, told to whoever does not see it: another situation."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject

from situ_studio.live.follower import Follower
from situ_studio.live.moment import Moment
from situ_studio.wording.language import tr


class SituationTelling(QObject):
    """Tells each that begins while all views follow the robot, or a rehearsal.

    Who goes back to an earlier moment goes there themselves, and the timeline tells what was then.
    """

    def __init__(self, follower: Follower, tell: Callable[[str], None]) -> None:
        super().__init__(follower)
        self._viewing, self._tell = follower.viewing, tell
        self._known: tuple[object, str | None] = (None, None)
        follower.refreshed.connect(self._on_refreshed)

    def _on_refreshed(self, moment: Moment, t: float) -> None:
        log, before = self._known
        if not self._viewing.follows:
            return
        self._known = self._viewing.log, moment.situation
        # Of one that is looked at from now on, what stands is no news.
        if log is self._viewing.log and before != moment.situation:
            self._tell(tr("Situation {0}").format(moment.situation or tr("none")))
