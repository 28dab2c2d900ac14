"""A request for authority as both forms of the client have it."""

from __future__ import annotations

from situ.blackboard.calls import Call, which
from situ.blackboard.dialog import Dialog
from situ.errors import BlackboardError


class Asked:
    """What was asked for, from entering a ``with`` until leaving it. resources: all of them or
    none; optional: granted with them, one by one where they are free.

    Raises BlackboardError where nothing is asked for.
    """

    def __init__(
        self, dialog: Dialog, resources: tuple[str, ...], optional: tuple[str, ...]
    ) -> None:
        if not resources and not optional:
            raise BlackboardError("say which resources are asked for: board.authority('head')")
        self.resources = resources
        self.optional = optional
        self._dialog = dialog
        self._entered = False

    @property
    def held(self) -> bool:
        """Whether the module holds all of these resources (the optional ones aside) now."""
        return self._dialog.holds.issuperset(self.resources)

    def __repr__(self) -> str:
        held = "held" if self.held else "not held"
        return (
            f"<{type(self).__name__} over {', '.join((*self.resources, *self.optional))}, {held}>"
        )

    def _begin(self) -> Call[None]:
        self._entered = True
        return self._dialog.acquire(self, self.resources, self.optional)

    def _refused(self) -> None:
        self._entered = False
        self._dialog.withdraw(self)

    def _end(self) -> Call[None]:
        self._entered = False
        return self._dialog.abandon(self)

    def _check(self) -> None:
        if not self._entered:
            name = ", ".join((*self.resources, *self.optional))
            raise BlackboardError(f"{name} is asked for only within: with board.authority(…) as …")

    def _named(self, resource: str | None) -> str:
        """The resource that a command is for."""
        self._check()
        return which((*self.resources, *self.optional), resource)
