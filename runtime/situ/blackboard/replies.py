"""What the core answers: ``REPLIES`` has which of these to which request of ``protocol``."""

from __future__ import annotations

from typing import Any, Literal

from msgspec import UNSET, Raw, Struct, UnsetType

from situ.blackboard import protocol
from situ.blackboard.services import Carried
from situ.decide.deployment import Waits
from situ.decide.expected import Expectation


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
    private values are hidden from this session, which then subscribes to other topics. situ: the
    version of Situ that the core runs; a core from before it was told leaves it out.
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
    situ: str | UnsetType = UNSET


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

    events: tuple[Raw, ...]
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
    files: dict[str, protocol.Sent] = {}


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
    requires: tuple[protocol.Need, ...]
    provides: tuple[protocol.Offer, ...]


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

REPLIES: dict[type[protocol.Request], type[Reply]] = {
    protocol.Hello: Welcome,
    protocol.Heartbeat: Alive,
    protocol.Set: Written,
    protocol.Get: Values,
    protocol.Watch: Snapshot,
    protocol.Unwatch: Done,
    protocol.Publish: Done,
    protocol.Acquire: Granted,
    protocol.Abandon: Granted,
    protocol.Command: Done,
    protocol.Use: Done,
    protocol.Touch: Done,
    protocol.Attend: Done,
    protocol.Perform: Outstanding,
    protocol.Finish: Done,
    protocol.Serve: Questions,
    protocol.Answer: Done,
    protocol.Trace: Traced,
    protocol.Break: Done,
    protocol.Unbreak: Done,
    protocol.Pause: Done,
    protocol.Resume: Done,
    protocol.Step: Done,
    protocol.Goto: Done,
    protocol.Stage: Staged,
    protocol.Piece: Done,
    protocol.Deploy: Deployment,
    protocol.Rollback: Deployment,
    protocol.Progress: Deployment,
    protocol.History: Turns,
    protocol.Bundle: Bundled,
    protocol.Fetch: Fetched,
    protocol.Documents: Files,
    protocol.Expected: Expectations,
    protocol.Modules: ModuleStates,
    protocol.Disclose: Done,
    protocol.Bye: Done,
}
"""What each request is answered with, unless with ``Refused``."""
