"""What a window looks at goes on where the window is made anew: a robot, a run, and the cursor."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


def move(before: MainWindow, window: MainWindow) -> None:
    """``window``, which has the session and the link of ``before`` already, looks at what that one
    does, at the same moment; what is under way there goes on here."""
    old, new = before.robot, window.robot
    viewing, bookmarks = old.follower.viewing, old.timeline.bookmarks
    t = None if viewing.follows else viewing.t
    before.rehearsing.move_to(window.rehearsing)
    if old.recording is not None:
        new.show_recording(old.recording)
    old.chosen.move_to(new.chosen)
    new.timeline.bookmarks.take(bookmarks)
    old.comparing.move_to(new.comparing)
    if t is not None:
        new.follower.viewing.seek(t)
    before.deploying.move_to(window.deploying)
    before.field.move_to(window.field)
