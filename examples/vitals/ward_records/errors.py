"""What the records refuse, and why."""

from __future__ import annotations


class Unfit(Exception):
    """What was given can not be kept; says why, in one line: ``text`` with ``values`` at its
    ``{0}``, ``{1}``."""

    def __init__(self, text: str, *values: object) -> None:
        super().__init__(text.format(*values) if values else text)
        self.text, self.values = text, values


class Unknown(Exception):
    """There is no such resident."""


class MovedOut(Unknown):
    """Who had this number lives here no more; nobody else ever gets it."""


class WrongPin(Exception):
    """Nobody in this room has this PIN."""


class Locked(Exception):
    """Too many wrong PINs in this room, lately."""
