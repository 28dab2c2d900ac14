"""What goes out of ``Robot.step``: what the driver must carry out, in this order.

The simulator ignores them; the live runtime (``situ.engine.live``) carries them
out and answers with ``inputs.Finish``.
"""

from __future__ import annotations

from typing import Any

from msgspec import Struct


class Effect(Struct, frozen=True, gc=False, tag_field="effect", tag=str.lower):
    """The base of all effects."""


class Changed(Effect, frozen=True):
    """An entry of the blackboard changed, those kept by the runtime included.

    version counts up per tag, over deletions too; value None: deleted. time: µs.
    """

    tag: str
    value: Any
    version: int
    writer: str
    time: int


class Map(Effect, frozen=True):
    """``robot/<resource>`` changed: adapters apply ``value``, None is stop and hold.

    resource is ``speech`` or ``screen`` too. actions: ids of the application's
    actions that this value carries out (a speech, a sound, a robot action, the
    movies of a screen), each to be answered by ``Finish(id=…)``; empty for modules. Of a
    screen one for each of its movies, in order; 0 for one that has ended.
    """

    resource: str
    module: str | None
    value: Any
    actions: tuple[int, ...] = ()


class Begin(Effect, frozen=True):
    """Carry out an action that uses no resource: ``service``, ``launch`` or ``message``.

    fields: as in its trace event (name, url, method, params, topic, value, program).
    A message needs no ``Finish``.
    """

    id: int
    application: str
    action: str
    name: str | None
    fields: dict[str, Any]


class Cancel(Effect, frozen=True):
    """Stop the begun action ``id``; a late ``Finish`` for it is ignored."""

    id: int


class Refuse(Effect, frozen=True):
    """The input was refused; whoever sent it is told ``message``."""

    message: str


AnyEffect = Changed | Map | Begin | Cancel | Refuse
