"""What an action says of itself: its own fields, with all references filled in.

formats.md, *Trace* (an action's own fields) and *Values, references, conditions*.
"""

from __future__ import annotations

from typing import Any

from situ.decide.texts import translator
from situ.decide.values import Template, template
from situ.decide.world import World
from situ.document.rbd import Action, Launch, Param, Robot, Service, Sound, Speech


class Filling:
    """Fills in the actions of one application; what is missing is warned of."""

    def __init__(self, world: World, application: str) -> None:
        self._world = world
        self._application = application

    def fields(self, action: Action, state: str, cause: int | None) -> dict[str, Any]:
        """An action's own fields in the trace, filled in now."""
        if isinstance(action, Speech):
            board = self._world.board
            missing: list[str] = []
            text = translator(self._world.project, board, action.lang)(action.text, missing)
            for sentence in missing:
                self._world.step.warn(cause, sentence, self.where(state))
            language = action.lang if action.lang is not None else board.look("language")
            lang = language if isinstance(language, str) else None
            return {"text": self._text(text, state, cause), "lang": lang}
        if isinstance(action, Sound):
            return {"src": self._text(action.src, state, cause)}
        if isinstance(action, Robot):
            params = self._params(action.params, state, cause)
            return {"resource": action.resource, "command": action.command, "params": params}
        if isinstance(action, Service):
            url = self._text(action.url, state, cause)
            params = self._params(action.params, state, cause)
            return {"method": action.method, "url": url, "params": params}
        assert isinstance(action, Launch)
        params = self._params(action.params, state, cause)
        return {"program": action.program, "params": params}

    def value(self, text: str, state: str, cause: int | None) -> Any:
        """The value of a text."""
        return self._template(text, state, cause).value(self._world.board.look)

    def where(self, state: str) -> str:
        """Where a warning about the state says it is."""
        return f"{self._application}, state {state}"

    def _params(self, params: tuple[Param, ...], state: str, cause: int | None) -> dict[str, Any]:
        return {p.name: self.value(p.text, state, cause) for p in params}

    def _text(self, text: str, state: str, cause: int | None) -> str:
        return self._template(text, state, cause).text(self._world.board.look)

    def _template(self, text: str, state: str, cause: int | None) -> Template:
        filled = template(text)
        for name in filled.missing(self._world.board.look) if filled.names else ():
            self._world.step.warn(cause, f"{name} has no value", self.where(state))
        return filled
