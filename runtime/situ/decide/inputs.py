"""What comes into ``Robot.step``: one typed message an input.

A recording of a run is the list of these with their times, ``Start`` first.
All of them can be written and read as JSON (tagged by ``verb``).
"""

from __future__ import annotations

from typing import Any

from msgspec import UNSET, Struct, UnsetType, field


class Input(
    Struct, frozen=True, gc=False, tag_field="verb", tag=str.lower, forbid_unknown_fields=True
):
    """The base of all inputs; read strictly, so that a misspelt field shows."""


class Start(Input, frozen=True):
    """The first input of a run.

    seed: of everything random. auto_finish: seconds after which every action ends well,
    or None. everyone: every declared module counts as present until it is lost (the
    simulator); else only those that are connected. restored: what durable tags held in the
    run before, tag to (value, version, writer); it goes before the project's ``[tags]``.
    """

    seed: int = 0
    auto_finish: float | None = None
    everyone: bool = True
    restored: dict[str, tuple[Any, int, str]] = {}


class Set(Input, frozen=True):
    """Tags written in one write; null deletes."""

    tags: dict[str, Any]
    writer: str


class Raise(Input, frozen=True):
    """An event from outside; application None: every application gets it. writer: the operator who
    raises it, None for all others."""

    event: str
    application: str | None = None
    writer: str | None = None


class Touch(Input, frozen=True):
    """A touch on no component of the screen shown."""


class Attend(Input, frozen=True):
    """A person types on the screen shown: an ``idle`` timeout counts anew."""


class Use(Input, frozen=True):
    """What a person does to a component of the screen shown.

    value: the text typed or the entry chosen; unset for a button.
    """

    component: str
    value: Any = UNSET


class Acquire(Input, frozen=True):
    module: str
    resources: tuple[str, ...]
    optional: tuple[str, ...] = ()


class Abandon(Input, frozen=True):
    """resources empty: all that it asked for."""

    module: str
    resources: tuple[str, ...] = ()


class Command(Input, frozen=True):
    """valid: seconds that the command is good for (``for`` in files), or None."""

    module: str
    resource: str
    value: Any
    valid: float | None = field(name="for", default=None)


class Lost(Input, frozen=True):
    """The module died, hangs or is out of reach: its requests and commands end."""

    module: str


class Connected(Input, frozen=True):
    """A module connected; ``resources`` are those it says it has."""

    module: str
    resources: tuple[str, ...] = ()


class Finish(Input, frozen=True):
    """An action ended. ``id`` (an effect's) names it exactly; else the earliest that fits."""

    action: str | None = None
    name: str | None = None
    application: str | None = None
    ok: bool = True
    result: Any = None
    error: str | None = None
    status: int | UnsetType | None = UNSET
    id: int | None = None


class Break(Input, frozen=True):
    """A breakpoint: on a ``state`` (its path), on transitions (``from``, ``to`` or both; paths)
    or on a ``situation``; exactly one of these.

    application: None where there is only one, or, on a situation, for all of them. when: what
    stands inside of a ``<when>``, as text; only while it holds does the breakpoint pause.
    """

    writer: str
    application: str | None = None
    state: str | None = None
    source: str | None = field(name="from", default=None)
    to: str | None = None
    situation: str | None = None
    when: str | None = None


class Unbreak(Input, frozen=True):
    """A breakpoint is taken away; id None: all are."""

    writer: str
    id: int | None = None


class Pause(Input, frozen=True):
    """application None: all of them. One that is paused already stays as it is."""

    writer: str
    application: str | None = None


class Resume(Input, frozen=True):
    """application None: all of them. One that is not paused stays as it is."""

    writer: str
    application: str | None = None


class Step(Input, frozen=True):
    """The next thing of a paused application; None where there is only one application."""

    writer: str
    application: str | None = None


class Goto(Input, frozen=True):
    """The application, None where there is only one, leaves its state for ``state`` (a path)."""

    writer: str
    state: str
    application: str | None = None


class Deploy(Input, frozen=True):
    """Another version of the project, to run from the next moment on at which no action runs.

    files: its texts by their paths (``situ.document.folder.sources``, and ``robot.local.toml``
    where there is one). force_after: seconds after which it does not wait any longer, at once
    where they are none; None: it waits as long as it takes. returning: it goes back to what ran
    before, at once.
    """

    version: int
    files: dict[str, str]
    writer: str
    force_after: float | None = None
    returning: bool = False


Debugging = Break | Unbreak | Pause | Resume | Step | Goto

AnyInput = (
    Start
    | Set
    | Raise
    | Touch
    | Use
    | Attend
    | Acquire
    | Abandon
    | Command
    | Lost
    | Connected
    | Finish
    | Deploy
    | Debugging
)
