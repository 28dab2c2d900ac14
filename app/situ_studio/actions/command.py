"""One command of the studio, as a row of the table."""

from __future__ import annotations

from typing import Any, Literal

from msgspec import Struct


class Command(Struct, frozen=True, kw_only=True):
    """One command.

    menu: the menu's title, with the submenu's behind ``/``; "": in no menu.
    toolbar: at the left or right end of the toolbar; outlined buttons show their text.
    when: what must hold for the command to be enabled, divided by blanks; of what does not, the
        first is told as the reason. shown: must hold for it to be there at all.
    choice: commands of one choice are exclusive and checkable, ``checked`` says which one is.
    rule: a line stands before it in its menu.
    argument: given to the handler, if not None.
    contexts: where it is in the context menu, divided by blanks: ``ground``, ``state`` (one),
        ``states`` (several), ``exit`` (a transition), ``always``, ``component`` (one or several),
        ``screen`` (its ground), ``thing`` (anything else).
    also: another shortcut.
    """

    id: str
    text: str
    handler: str
    icon: str = ""
    shortcut: str = ""
    menu: str = ""
    toolbar: Literal["", "left", "right"] = ""
    outlined: bool = False
    when: str = ""
    shown: str = ""
    choice: str = ""
    checked: str = ""
    rule: bool = False
    argument: Any = None
    tip: str = ""
    contexts: str = ""
    also: str = ""


def row(id: str, text: str, handler: str, **rest: Any) -> Command:
    """A command whose first three are told by their places."""
    return Command(id=id, text=text, handler=handler, **rest)
