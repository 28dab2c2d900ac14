"""Version 1 of what client and core say to each other: its terms, and what a client asks.

docs/protocol.md has a row for each message, ``tests/vectors/`` the bytes; ``wire`` makes and
reads them. Every body is a Struct. Three directions:

* *requests*, client to core, told apart by ``do``; ``id`` is the client's own count.
* *replies* (``replies``), core to client, told apart by ``re``; ``id`` is the request's.
* *notices* (``notices``), core to whoever subscribed, told apart by ``on``; on ZeroMQ a notice
  is one frame: its topic (``topics``), a newline, its body.

The core is strict (an unknown field is refused, so that a typing error shows), the
client is not (a core may grow fields). Times are whole microseconds since the start of
the runtime, lengths of time are seconds.
"""

from __future__ import annotations

from typing import Any, Literal

from msgspec import UNSET, Struct, UnsetType, field

VERSION = 1
HEARTBEAT = 0.25
LEASE = 1.0
"""Seconds: how often a client says that it lives, and how long it is believed."""
LONG_LEASE = 10.0
"""Seconds that a client is believed for which nothing stands still: who looks, and an operator who
has not asked for authority. A window that is busy for a moment then loses nothing."""

Role = Literal["viewer", "module", "operator", "scenario", "service"]
"""viewer looks; module and operator also write; scenario plays a script (``situ run --script``);
service carries out what the core decides (``situ run --services``)."""


class Request(
    Struct,
    frozen=True,
    kw_only=True,
    tag_field="do",
    tag=str.lower,
    forbid_unknown_fields=True,
    omit_defaults=True,
):
    """at: the scenario's time in µs; only from the role ``scenario``."""

    id: int
    at: int | None = None


class Need(Struct, frozen=True, omit_defaults=True):
    """What a module requires: exactly one of ``data`` (a tag) and ``module``."""

    data: str | None = None
    module: str | None = None


class Offer(Struct, frozen=True, omit_defaults=True):
    """What a module provides, as in module information."""

    data: str
    type: str | None = None
    unit: str | None = None


class Hello(Request, frozen=True, kw_only=True):
    """Opens a session. module: its name, for the role ``module`` only.

    user: who operates, for the role ``operator``: writes are ``operator:USER``'s.
    session: the one it had before; taken up again while its lease runs.
    services: what it carries out (``situ.blackboard.services``), for the role ``service`` only.
    """

    version: int
    role: Role = "module"
    module: str | None = None
    user: str | None = None
    resources: tuple[str, ...] = ()
    description: str = ""
    requires: tuple[Need, ...] = ()
    provides: tuple[Offer, ...] = ()
    session: str | None = None
    services: tuple[str, ...] = ()


class Heartbeat(Request, frozen=True, kw_only=True):
    """Every request keeps the lease; this one does nothing else."""


class Set(Request, frozen=True, kw_only=True):
    """One write of several tags; null deletes.

    versions: compare-and-set; nothing is written unless each tag stands at this
    version, 0 for one that is missing. writer: who found out, from the role ``service``.
    """

    tags: dict[str, Any]
    versions: dict[str, int] | None = None
    writer: str | None = None


class Get(Request, frozen=True, kw_only=True):
    """names: tags, names that reach into a value (``patient.room``), or patterns."""

    names: tuple[str, ...]


class Watch(Request, frozen=True, kw_only=True):
    """From now on changes are noticed; the reply has what stands there now."""

    patterns: tuple[str, ...]


class Unwatch(Request, frozen=True, kw_only=True):
    patterns: tuple[str, ...]


class Publish(Request, frozen=True, kw_only=True):
    """An event; application None: for every application."""

    event: str
    application: str | None = None


class Acquire(Request, frozen=True, kw_only=True):
    """Asks for authority; replaces what the module asked for before.

    module: whose request it is; only from the role ``scenario``, here and below.
    """

    resources: tuple[str, ...]
    optional: tuple[str, ...] = ()
    module: str | None = None


class Abandon(Request, frozen=True, kw_only=True):
    """resources empty: gives all of them back."""

    resources: tuple[str, ...] = ()
    module: str | None = None


class Command(Request, frozen=True, kw_only=True):
    """valid (``for``): seconds that the command is good for, or None."""

    resource: str
    value: Any
    valid: float | None = field(name="for", default=None)
    module: str | None = None


class Use(Request, frozen=True, kw_only=True):
    """What a person did to a component of the screen shown; value unset for a button."""

    component: str
    value: Any = UNSET


class Touch(Request, frozen=True, kw_only=True):
    """A touch on no component."""


class Attend(Request, frozen=True, kw_only=True):
    """A person types on the screen shown."""


class Perform(Request, frozen=True, kw_only=True):
    """From now on the effects for this service are noticed; the reply has what is outstanding.

    http: where the screen is served, from the service ``screen``.
    """

    http: str | None = None


class Finish(Request, frozen=True, kw_only=True):
    """An action ended (``situ.decide.inputs.Finish``). status null: there was none."""

    action: str | None = None
    name: str | None = None
    application: str | None = None
    ok: bool = True
    result: Any = None
    error: str | None = None
    status: int | UnsetType | None = UNSET
    action_id: int | None = None


class Serve(Request, frozen=True, kw_only=True):
    """What this module answers when applications ask; the reply has what they ask now.

    requests: all of them; asked for another one, it fails at once.
    """

    requests: tuple[str, ...]


class Answer(Request, frozen=True, kw_only=True):
    """The answer to the ``Question`` of the id ``asked``; passed over where nobody waits for it."""

    asked: int
    ok: bool = True
    result: Any = None
    error: str | None = None


class Trace(Request, frozen=True, kw_only=True):
    """From now on trace events are noticed; the reply has those from ``since`` on.

    since: a seq; None: only what comes.
    """

    since: int | None = None


class Break(Request, frozen=True, kw_only=True):
    """A breakpoint (``situ.decide.inputs.Break``)."""

    application: str | None = None
    state: str | None = None
    source: str | None = field(name="from", default=None)
    to: str | None = None
    situation: str | None = None
    when: str | None = None


class Unbreak(Request, frozen=True, kw_only=True):
    """breakpoint: its id; None: all of them."""

    breakpoint: int | None = None


class Pause(Request, frozen=True, kw_only=True):
    """application None: all of them, as in ``Resume``."""

    application: str | None = None


class Resume(Request, frozen=True, kw_only=True):
    application: str | None = None


class Step(Request, frozen=True, kw_only=True):
    """The next thing of a paused application; None where there is only one application."""

    application: str | None = None


class Goto(Request, frozen=True, kw_only=True):
    """state: its path (``5/q``)."""

    state: str
    application: str | None = None


class Sent(Struct, frozen=True):
    """A file that is deployed: its bytes, and the SHA-256 of its content."""

    size: int
    sha256: str


class Stage(Request, frozen=True, kw_only=True):
    """Announces the files of a version, by their paths in the project; what was being sent before
    is forgotten. main: the file that the project is read from; None: as in the version that runs,
    of which all that is not announced stays."""

    files: dict[str, Sent]
    main: str | None = None


class Piece(Request, frozen=True, kw_only=True):
    """The next bytes of an announced file; in JSON base64."""

    path: str
    offset: int
    data: bytes


class Deploy(Request, frozen=True, kw_only=True):
    """What was announced has come: it is checked, and runs from the next safe point on.

    force_after: seconds after which it does not wait for one any longer; None: however long.
    """

    force_after: float | None = None


class Rollback(Request, frozen=True, kw_only=True):
    """version None: the one that ran before; 0: the project that ``situ run`` was given."""

    version: int | None = None
    force_after: float | None = None


class Progress(Request, frozen=True, kw_only=True):
    """How far the last version that was asked for is."""


class History(Request, frozen=True, kw_only=True):
    """Which versions there were, and are."""


class Bundle(Request, frozen=True, kw_only=True):
    """Which version runs, and its files; from a service, which needs its media."""


class Fetch(Request, frozen=True, kw_only=True):
    """The bytes of a file of this version from ``offset`` on."""

    version: int
    path: str
    offset: int


class Documents(Request, frozen=True, kw_only=True):
    """The files of the project as the robot runs it."""


class Expected(Request, frozen=True, kw_only=True):
    """What each application expects now."""


class Modules(Request, frozen=True, kw_only=True):
    """Who is declared, who is connected, and what is wanted."""


class Disclose(Request, frozen=True, kw_only=True):
    """A module tells later, or anew, what ``hello`` may tell already."""

    description: str = ""
    requires: tuple[Need, ...] = ()
    provides: tuple[Offer, ...] = ()


class Bye(Request, frozen=True, kw_only=True):
    """Ends the session at once; from a scenario with ``module``: that module is lost."""

    module: str | None = None


Debugging = Break | Unbreak | Pause | Resume | Step | Goto
DebugVerb = Literal["break", "unbreak", "pause", "resume", "step", "goto"]
DEBUGGING: dict[DebugVerb, type[Debugging]] = {
    "break": Break,
    "unbreak": Unbreak,
    "pause": Pause,
    "resume": Resume,
    "step": Step,
    "goto": Goto,
}

Deploying = Stage | Piece | Deploy | Rollback | Progress | History | Bundle | Fetch

AnyRequest = (
    Hello
    | Heartbeat
    | Set
    | Get
    | Watch
    | Unwatch
    | Publish
    | Acquire
    | Abandon
    | Command
    | Use
    | Touch
    | Attend
    | Perform
    | Finish
    | Serve
    | Answer
    | Trace
    | Debugging
    | Deploying
    | Documents
    | Expected
    | Modules
    | Disclose
    | Bye
)
