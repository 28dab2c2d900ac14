"""Version 1 of what client and core say to each other: every body a Struct.

docs/protocol.md has a row for each, ``tests/vectors/`` the bytes; ``wire`` makes and reads them.
Three directions:

* *requests*, client to core, told apart by ``do``; ``id`` is the client's own count.
* *replies*, core to client, told apart by ``re``; ``id`` is the request's.
* *notices*, core to whoever subscribed, told apart by ``on``; on ZeroMQ a notice is one
  frame: its topic (``topics``), a newline, its body.

The core is strict (an unknown field is refused, so that a typing error shows), the
client is not (a core may grow fields). Times are whole microseconds since the start of
the runtime, lengths of time are seconds.
"""

from __future__ import annotations

from typing import Any, Literal

import msgspec
from msgspec import UNSET, Struct, UnsetType, field

from situ.blackboard.services import Carried
from situ.decide.deployment import Waits
from situ.decide.expected import Expectation

VERSION = 1
HEARTBEAT = 0.25
LEASE = 1.0
"""Seconds: how often a client says that it lives, and how long it is believed."""

Role = Literal["viewer", "module", "operator", "scenario", "service"]
"""viewer looks; module and operator also write; scenario plays a script (``situ run --script``);
service carries out what the core decides (``situ run --services``)."""


# -- requests ----------------------------------------------------------------


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

# -- replies -----------------------------------------------------------------


class Reply(Struct, frozen=True, kw_only=True, tag_field="re", tag=str.lower):
    id: int | None


Code = Literal[
    "session",
    "version",
    "name",
    "role",
    "denied",
    "limit",
    "clock",
    "malformed",
    "conflict",
    "invalid",
    "refused",
]


class Refused(Reply, frozen=True, kw_only=True):
    """Nothing was done.

    code: ``session`` (say hello first), ``version``, ``name`` (taken), ``role``,
    ``denied`` (by the rights of the key), ``limit`` (too many), ``clock`` (a time from no
    scenario), ``malformed``, ``conflict`` (compare-and-set), ``invalid`` (a tag or pattern that
    is none) or ``refused`` (by the priority management).
    message: one line: what, why, what to do.
    """

    code: str
    message: str


class Addresses(Struct, frozen=True):
    """Where else to knock; http None: there is no screen."""

    requests: str
    notifications: str
    http: str | None = None


class Welcome(Reply, frozen=True, kw_only=True):
    """To hello. runtime: another one after each start of the core, as ``seq`` begins anew.

    resumed: the session is the one that was named; else watches, requests for
    authority and trace are to be asked for anew. seq: the last trace event's. masked: whether
    private values are hidden from this session, which then subscribes to other topics.
    """

    session: str
    resumed: bool
    runtime: str
    version: int
    heartbeat: float
    lease: float
    project: str
    addresses: Addresses
    time: int
    seq: int
    masked: bool = False


class Alive(Reply, frozen=True, kw_only=True):
    """To heartbeat: what the client can find losses by.

    changes: for each pattern that this session watches, how many changes fitted it since
    the core began to count. seq: the last trace event's. holds: this module's resources.
    effects: for each of this client's services the number of the last effect. asked: for a
    module, how often what is asked of it has changed. deployed: for a service, the version of
    the project that runs.
    """

    time: int
    seq: int
    changes: dict[str, int]
    holds: tuple[str, ...]
    effects: dict[str, int] | UnsetType = UNSET
    asked: int | UnsetType = UNSET
    deployed: int | UnsetType = UNSET


class Done(Reply, frozen=True, kw_only=True):
    """To all requests that have nothing to tell."""


class Written(Reply, frozen=True, kw_only=True):
    """To set: the version of each tag that changed."""

    versions: dict[str, int]


class Entry(Struct, frozen=True):
    """value None: deleted, or never there (version 0); version counts on over deletions."""

    value: Any
    version: int
    writer: str | None
    time: int


class Values(Reply, frozen=True, kw_only=True):
    """To get: each name asked for, and each tag there is that a pattern fits."""

    entries: dict[str, Entry]


class Snapshot(Reply, frozen=True, kw_only=True):
    """To watch: what stands there, what was deleted there, and ``changes`` as in Alive."""

    entries: dict[str, Entry]
    changes: dict[str, int]


class Granted(Reply, frozen=True, kw_only=True):
    """To acquire and abandon: the resources that the module holds now; seq as in Alive."""

    holds: tuple[str, ...]
    seq: int


class Traced(Reply, frozen=True, kw_only=True):
    """To trace: events in order of seq, each with ``time``; ask again from ``next`` until
    it is above ``last``. first: the oldest that the core still has."""

    events: tuple[msgspec.Raw, ...]
    first: int
    next: int
    last: int


class Outstanding(Reply, frozen=True, kw_only=True):
    """To perform: all that must be carried out to be where the robot is, by who has carried out
    nothing. next: for each service the number of the next effect."""

    effects: tuple[Carried, ...]
    next: dict[str, int]


class Question(Struct, frozen=True):
    """What an application asks of a module: a service ``board:module/request``."""

    id: int
    request: str
    params: dict[str, Any]
    application: str


class Questions(Reply, frozen=True, kw_only=True):
    """To serve: all that is asked of the module now, in order; count as ``asked`` in Alive."""

    questions: tuple[Question, ...]
    count: int


class Staged(Reply, frozen=True, kw_only=True):
    """To stage: the files whose pieces are to be sent; the robot has the others."""

    wanted: tuple[str, ...]


Stands = Literal["checking", "waiting", "running", "refused", "returned"]


class Deployment(Reply, frozen=True, kw_only=True):
    """To deploy, rollback and progress. version: the one that runs.

    asked: the last one that was asked for, None: none since the core was started; stands: how it
    is with that one: ``waiting`` for what ``waits`` names, ``refused`` or ``returned`` from for
    ``problems``. forced: seconds until it does not wait any longer; None: no such time.
    minute: seconds that the version which runs has left to show that it does not fail, and
    former: the one that is gone back to if it does; None: it counts. restart: what of it counts
    only when the robot is started again.
    """

    version: int
    asked: int | None = None
    stands: Stands = "running"
    waits: tuple[Waits, ...] = ()
    forced: float | None = None
    minute: float | None = None
    former: int | None = None
    problems: tuple[str, ...] = ()
    restart: tuple[str, ...] = ()


class Turn(Struct, frozen=True):
    """Something that happened to the versions of a robot: ``deployed``, ``rolled back`` or
    ``returned`` to this version, by whom and why; ``refused``; ``given``: its own folder was
    changed, and that runs. time: UNIX seconds. changed: in plain words."""

    time: float
    version: int
    who: str
    did: Literal["deployed", "rolled back", "returned", "refused", "given"]
    why: str = ""
    changed: tuple[str, ...] = ()


class Bundled(Reply, frozen=True, kw_only=True):
    """To bundle. main, files: as in Stage; none for version 0, of which a service has a copy."""

    version: int
    main: str = ""
    files: dict[str, Sent] = {}


class Fetched(Reply, frozen=True, kw_only=True):
    """To fetch: at most 700,000 bytes; in JSON base64. None at the end of the file."""

    data: bytes


class Turns(Reply, frozen=True, kw_only=True):
    """To history: what happened, the oldest first; the version that runs; the versions that can
    be gone back to."""

    turns: tuple[Turn, ...]
    version: int
    kept: tuple[int, ...]


class Files(Reply, frozen=True, kw_only=True):
    """To documents: path relative to the project, to the text of the file."""

    project: str
    files: dict[str, str]


class Expectations(Reply, frozen=True, kw_only=True):
    """To expected: by application, in the project's order."""

    applications: dict[str, Expectation]


class ModuleState(Struct, frozen=True):
    """A module, or an application (then ``application`` is true and it is always present)."""

    name: str
    application: bool
    declared: bool
    present: bool
    resources: tuple[str, ...]
    holds: tuple[str, ...]
    description: str
    requires: tuple[Need, ...]
    provides: tuple[Offer, ...]


class Wanted(Struct, frozen=True):
    """Something that ``by`` require and nobody who is present provides."""

    data: str | None
    module: str | None
    by: tuple[str, ...]


class ModuleStates(Reply, frozen=True, kw_only=True):
    modules: tuple[ModuleState, ...]
    wanted: tuple[Wanted, ...]


AnyReply = (
    Refused
    | Welcome
    | Alive
    | Done
    | Written
    | Values
    | Snapshot
    | Granted
    | Traced
    | Outstanding
    | Questions
    | Staged
    | Deployment
    | Turns
    | Bundled
    | Fetched
    | Files
    | Expectations
    | ModuleStates
)

REPLIES: dict[type[Request], type[Reply]] = {
    Hello: Welcome,
    Heartbeat: Alive,
    Set: Written,
    Get: Values,
    Watch: Snapshot,
    Unwatch: Done,
    Publish: Done,
    Acquire: Granted,
    Abandon: Granted,
    Command: Done,
    Use: Done,
    Touch: Done,
    Attend: Done,
    Perform: Outstanding,
    Finish: Done,
    Serve: Questions,
    Answer: Done,
    Trace: Traced,
    Break: Done,
    Unbreak: Done,
    Pause: Done,
    Resume: Done,
    Step: Done,
    Goto: Done,
    Stage: Staged,
    Piece: Done,
    Deploy: Deployment,
    Rollback: Deployment,
    Progress: Deployment,
    History: Turns,
    Bundle: Bundled,
    Fetch: Fetched,
    Documents: Files,
    Expected: Expectations,
    Modules: ModuleStates,
    Disclose: Done,
    Bye: Done,
}
"""What each request is answered with, unless with ``Refused``."""

# -- notices -----------------------------------------------------------------


class Notice(Struct, frozen=True, kw_only=True, tag_field="on", tag=str.lower):
    """What is sent to all who subscribed to its topic."""


class Change(Notice, frozen=True, kw_only=True):
    """Topic ``t:TAG``. value None: deleted."""

    tag: str
    value: Any
    version: int
    writer: str
    time: int


class Authority(Notice, frozen=True, kw_only=True):
    """Topic ``a:RESOURCE``: it passed from one module (or nobody) to another."""

    resource: str
    source: str | None = field(name="from")
    to: str | None
    seq: int


class Events(Notice, frozen=True, kw_only=True):
    """Topic ``trace``: the trace events of one step."""

    events: tuple[msgspec.Raw, ...]


class Message(Notice, frozen=True, kw_only=True):
    """Topic ``m:TOPIC``: an application's action ``message``."""

    topic: str
    value: Any
    application: str


class Effect(Notice, frozen=True, kw_only=True):
    """Topic ``x:SERVICE``: to be carried out. number: counts up by one for each service."""

    service: str
    number: int
    does: Carried


class Asked(Notice, frozen=True, kw_only=True):
    """Topic ``q:MODULE``: what is asked of the module has changed, so many times by now."""

    count: int


class Echo(Notice, frozen=True, kw_only=True):
    """Topic ``echo:TOKEN``, sent once when somebody subscribes to it: all that he subscribed
    to before is heard from here on."""


class End(Notice, frozen=True, kw_only=True):
    """Topic ``end``: the runtime stops."""


AnyNotice = Change | Authority | Events | Message | Effect | Asked | Echo | End
