"""Every command of the studio in one table, put together of one file a subject.

Menus, context menus, toolbar, shortcuts, the command palette and the list of shortcuts are made
from it (``commands.menus.Actions``), in its order. A command's handler is a method of
``commands.commands.Commands``, its ``when`` one of the same that says whether it can be done now.
"""

from __future__ import annotations

from situ_studio.actions.appearance import APPEARANCE
from situ_studio.actions.arrange import ARRANGE
from situ_studio.actions.command import Command
from situ_studio.actions.edit import EDIT
from situ_studio.actions.file import FILE
from situ_studio.actions.go import GO
from situ_studio.actions.help import HELP
from situ_studio.actions.insert import INSERT
from situ_studio.actions.recordings import RECORDINGS
from situ_studio.actions.rehearsal import REHEARSAL
from situ_studio.actions.robot import ROBOT
from situ_studio.actions.situations import SITUATIONS
from situ_studio.actions.transitions import TRANSITIONS
from situ_studio.actions.view import VIEW

__all__ = ["COMMANDS", "MENUS", "SUBMENU_ICONS", "Command", "command"]

COMMANDS: tuple[Command, ...] = (
    *FILE,
    *EDIT,
    *VIEW,
    *GO,
    *APPEARANCE,
    *INSERT,
    *SITUATIONS,
    *TRANSITIONS,
    *ARRANGE,
    *REHEARSAL,
    *ROBOT,
    *RECORDINGS,
    *HELP,
)

MENUS = ("File", "Edit", "View", "Go", "Insert", "Arrange", "Robot", "Help")
"""In this order; Alt and the first letter opens one."""

SUBMENU_ICONS = {
    "Edit/Select": "select_all",
    "Edit/Cells": "matrix",
    "View/Colours": "theme",
    "View/Language": "language",
    "View/Letters": "text",
    "Arrange/Align": "align_left",
    "Arrange/Order": "layers",
    "Arrange/Guides": "guide_upright",
    "Insert/Situation": "situation",
    "Insert/Tests": "condition",
    "Insert": "plus",
}
"""Of submenus, and of a menu that is one in a context menu."""


def command(id: str) -> Command:
    """The command of that id; KeyError where there is none."""
    for one in COMMANDS:
        if one.id == id:
            return one
    raise KeyError(id)
