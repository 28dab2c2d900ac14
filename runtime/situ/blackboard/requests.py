"""What each request does: with the core, for one session (docs/protocol.md)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, get_args

from msgspec import UNSET, Raw

from situ.blackboard import masked, presence, protocol, replies
from situ.blackboard.acting import No, Session, acts_as, has_a_screen, may_write, writes_as
from situ.blackboard.asking import one_line
from situ.blackboard.core import Core
from situ.blackboard.history import Performing, Told, Traced, Unwatched, Watched
from situ.blackboard.services import carried_by
from situ.decide import inputs
from situ.decide.board import Board
from situ.document import names
from situ.document.names import LONGEST
from situ.errors import Refused

PAGE = 500
"""Trace events in one reply."""
TAGS = 100_000
"""Tags on the board, deleted ones too, for their versions count on."""
PATTERNS = 1_000
"""Patterns that one session watches."""


def answer(core: Core, session: Session, request: protocol.Request) -> replies.Reply:
    """The reply; all but hello and the end of a session. Raises ``No``."""
    return _ANSWERS[type(request)](core, session, request)


def _heartbeat(core: Core, session: Session, request: protocol.Heartbeat) -> replies.Reply:
    return replies.Alive(
        id=request.id,
        time=core.moment,
        seq=core.backlog.last,
        changes=core.watching.changes(session.patterns),
        holds=core.holds(session.module),
        effects={s: core.effects[s] for s in session.services} if session.services else UNSET,
        asked=core.asking.counts[session.module] if session.module is not None else UNSET,
        deployed=core.deployer.version if session.services and core.deployer else UNSET,
    )


def _set(core: Core, session: Session, request: protocol.Set) -> replies.Reply:
    writer = writes_as(core, session, request)
    for tag in request.tags:
        if len(tag) > LONGEST:
            raise No("invalid", f"{tag[:LONGEST]!r} and so on is too long for a tag")
    board = core.board
    for tag, wanted in (request.versions or {}).items():
        entry = board.get(tag)
        found = 0 if entry is None else entry.version
        if found != wanted:
            raise No(
                "conflict",
                f"{tag} is at version {found}, not {wanted}: get it and try again",
            )
    if len(board.state) + len(request.tags) > TAGS:
        new = sum(tag not in board.state for tag in request.tags)
        if new and len(board.state) + new > TAGS:
            raise No("limit", f"there are {len(board.state)} tags already: use fewer names")
    full = core.unkeepable(request.tags)
    if full is not None:
        raise No("refused", full)
    if not session.heeded:
        return replies.Written(id=request.id, versions={})
    before = {tag: _version(board, tag) for tag in request.tags}
    _do(core, inputs.Set(request.tags, writer))
    after = {tag: _version(board, tag) for tag in request.tags}
    versions = {tag: version for tag, version in after.items() if version != before[tag]}
    return replies.Written(id=request.id, versions=versions)


def _get(core: Core, session: Session, request: protocol.Get) -> replies.Reply:
    board = core.board
    found: dict[str, replies.Entry] = {}
    for name in request.names:
        if "*" in name:
            _check(names.is_pattern, name)
            found.update((tag, _entry(entry)) for tag, entry in board.entries(name))
        else:
            _check(names.is_name, name)
            entry = board.last_set(name)
            found[name] = replies.Entry(
                value=board.look(name),
                version=0 if entry is None else entry.version,
                writer=None if entry is None else entry.writer,
                time=0 if entry is None else entry.time,
            )
    return replies.Values(id=request.id, entries=_seen(core, session, found))


def _watch(core: Core, session: Session, request: protocol.Watch) -> replies.Reply:
    for pattern in request.patterns:
        _check(names.is_pattern, pattern)
    begun = tuple(dict.fromkeys(p for p in request.patterns if p not in session.patterns))
    if len(session.patterns) + len(begun) > PATTERNS:
        raise No("limit", f"more than {PATTERNS} patterns: watch wider ones, as face.* or **")
    if begun:
        session.watch(begun, core.watching)
        core.remember(Watched(session.id, begun))
    found: dict[str, replies.Entry] = {}
    state = core.board.state
    for pattern in request.patterns:
        if "*" not in pattern:
            if (entry := state.get(pattern)) is not None:
                found[pattern] = _entry(entry)
            continue
        # Deleted ones too: their versions count on.
        for tag in sorted(state):
            if names.matches(pattern, tag):
                found[tag] = _entry(state[tag])
    changes = core.watching.changes(request.patterns)
    return replies.Snapshot(id=request.id, entries=_seen(core, session, found), changes=changes)


def _seen(
    core: Core, session: Session, found: dict[str, replies.Entry]
) -> dict[str, replies.Entry]:
    return masked.entries(core.mask(), found) if session.is_blind else found


def _unwatch(core: Core, session: Session, request: protocol.Unwatch) -> replies.Reply:
    ended = tuple(session.patterns.intersection(request.patterns))
    session.unwatch(ended, core.watching)
    core.remember(Unwatched(session.id, ended))
    return replies.Done(id=request.id)


def _publish(core: Core, session: Session, request: protocol.Publish) -> replies.Reply:
    may_write(session)
    if session.services:
        raise No("role", "a service raises no events: connect as a module or an operator")
    if not request.event.strip():
        raise No("invalid", "an event has a name")
    if len(request.event) > LONGEST:
        raise No("invalid", f"{request.event[:LONGEST]!r} and so on is too long for a name")
    writer = session.writer if session.role == "operator" else None
    _do(core, inputs.Raise(request.event, request.application, writer))
    return replies.Done(id=request.id)


def _acquire(core: Core, session: Session, request: protocol.Acquire) -> replies.Reply:
    module = acts_as(core, session, request.module)
    _do(core, inputs.Acquire(module, request.resources, request.optional))
    return _granted(core, request.id, module)


def _abandon(core: Core, session: Session, request: protocol.Abandon) -> replies.Reply:
    module = acts_as(core, session, request.module)
    _do(core, inputs.Abandon(module, request.resources))
    return _granted(core, request.id, module)


def _granted(core: Core, number: int, module: str) -> replies.Reply:
    holds = core.holds(module)
    return replies.Granted(id=number, holds=holds, seq=core.backlog.last)


def _command(core: Core, session: Session, request: protocol.Command) -> replies.Reply:
    module = acts_as(core, session, request.module)
    if request.valid is not None and request.valid <= 0:
        raise No("invalid", "a command is good for a number of seconds above 0")
    _do(core, inputs.Command(module, request.resource, request.value, request.valid))
    return replies.Done(id=request.id)


def _use(core: Core, session: Session, request: protocol.Use) -> replies.Reply:
    has_a_screen(session)
    _do(core, inputs.Use(request.component, request.value))
    return replies.Done(id=request.id)


def _touch(core: Core, session: Session, request: protocol.Touch) -> replies.Reply:
    has_a_screen(session)
    _do(core, inputs.Touch())
    return replies.Done(id=request.id)


def _attend(core: Core, session: Session, request: protocol.Attend) -> replies.Reply:
    has_a_screen(session)
    _do(core, inputs.Attend())
    return replies.Done(id=request.id)


def _perform(core: Core, session: Session, request: protocol.Perform) -> replies.Reply:
    if not session.services:
        raise No("role", "only a service carries out effects: say so in hello")
    if request.http is not None and "screen" not in session.services:
        raise No("role", "only the service screen says where the screen is")
    session.http = request.http
    if not session.performing:
        session.performing = True
        core.performing.update(session.services)
        core.remember(Performing(session.id))
    mine = set(session.services)
    return replies.Outstanding(
        id=request.id,
        effects=tuple(e for e in core.outstanding() if mine.intersection(carried_by(e))),
        next={service: core.effects[service] + 1 for service in session.services},
    )


def _finish(core: Core, session: Session, request: protocol.Finish) -> replies.Reply:
    may_write(session)
    if not session.heeded:
        return replies.Done(id=request.id)
    _do(
        core,
        inputs.Finish(
            action=request.action,
            name=request.name,
            application=request.application,
            ok=request.ok,
            result=request.result,
            error=request.error,
            status=request.status,
            id=request.action_id,
        ),
    )
    return replies.Done(id=request.id)


def _serve(core: Core, session: Session, request: protocol.Serve) -> replies.Reply:
    if session.module is None:
        raise No("role", "only a module is asked: connect with its name")
    for name in request.requests:
        if not name or len(name) > LONGEST:
            raise No("invalid", f"{name[:LONGEST]!r} is no name of a request")
    questions = core.asking.serve(session.module, request.requests, core.now)
    count = core.asking.counts[session.module]
    return replies.Questions(id=request.id, questions=questions, count=count)


def _answer(core: Core, session: Session, request: protocol.Answer) -> replies.Reply:
    if session.module is None:
        raise No("role", "only a module answers: connect with its name")
    module = core.asking.asked_of(request.asked)
    if module not in (None, session.module):
        raise No("refused", f"that was asked of {module}, not of {session.module}")
    if module is not None and core.asking.heeds:
        error = None if request.ok else one_line(module, request.error)
        _do(
            core,
            inputs.Finish(
                id=request.asked, ok=request.ok, result=request.result, error=error, status=None
            ),
        )
    return replies.Done(id=request.id)


def _trace(core: Core, session: Session, request: protocol.Trace) -> replies.Reply:
    if not session.tracing:
        core.tracing[session.masked] += 1
        session.tracing = True
        core.remember(Traced(session.id))
    last = core.backlog.last
    since = last + 1 if request.since is None else max(request.since, core.backlog.first)
    kept = core.backlog.since(since, PAGE)
    lines = masked.events(core.mask(), kept) if session.masked else tuple(map(Raw, kept))
    return replies.Traced(
        id=request.id,
        events=lines,
        first=core.backlog.first,
        next=since + len(lines),
        last=last,
    )


def _debug(core: Core, session: Session, request: protocol.Debugging) -> replies.Reply:
    if session.role != "operator":
        raise No("role", "only an operator debugs: connect as one")
    who, of = session.writer, request
    given: inputs.Debugging
    if isinstance(of, protocol.Break):
        given = inputs.Break(who, of.application, of.state, of.source, of.to, of.situation, of.when)
    elif isinstance(of, protocol.Unbreak):
        given = inputs.Unbreak(who, of.breakpoint)
    elif isinstance(of, protocol.Pause):
        given = inputs.Pause(who, of.application)
    elif isinstance(of, protocol.Resume):
        given = inputs.Resume(who, of.application)
    elif isinstance(of, protocol.Step):
        given = inputs.Step(who, of.application)
    else:
        given = inputs.Goto(who, of.state, of.application)
    _do(core, given)
    return replies.Done(id=request.id)


def _deploying(core: Core, session: Session, request: protocol.Deploying) -> replies.Reply:
    looks = isinstance(request, (protocol.Progress, protocol.History))
    fetches = isinstance(request, (protocol.Bundle, protocol.Fetch))
    if fetches and not session.services:
        raise No("role", "only a service fetches what is deployed: documents gives the texts")
    if session.role != "operator" and not (looks or fetches):
        raise No("role", "only an operator deploys: connect as one")
    if core.deployer is None:
        raise No(
            "refused", "a robot that plays a scenario has no versions: run it without --script"
        )
    try:
        return core.deployer.answer(request, session.writer, session.id)
    except Refused as error:
        raise No("refused", str(error)) from None


def _documents(core: Core, session: Session, request: protocol.Documents) -> replies.Reply:
    return replies.Files(id=request.id, project=core.project.name, files=dict(core.files))


def _expected(core: Core, session: Session, request: protocol.Expected) -> replies.Reply:
    told = core.expected()
    if session.is_blind:
        told = masked.expectations(core.mask(), told)
    return replies.Expectations(id=request.id, applications=told)


def _modules(core: Core, session: Session, request: protocol.Modules) -> replies.Reply:
    states = presence.modules(core.project, core.modules, core.holders)
    wanted = presence.wanted(states, lambda tag: core.board.get(tag) is not None)
    return replies.ModuleStates(id=request.id, modules=states, wanted=wanted)


def _disclose(core: Core, session: Session, request: protocol.Disclose) -> replies.Reply:
    if session.module is None:
        raise No("role", "only a module discloses")
    resources, description, _, _ = core.modules[session.module]
    said = (resources, request.description or description, request.requires, request.provides)
    core.modules[session.module] = said
    core.remember(Told(session.id, said))
    return replies.Done(id=request.id)


def _lost(core: Core, session: Session, request: protocol.Bye) -> replies.Reply:
    if session.role != "scenario" or request.module is None:
        raise No("role", "only a scenario speaks for other modules: leave out module")
    _do(core, inputs.Lost(request.module))
    return replies.Done(id=request.id)


def _do(core: Core, given: inputs.AnyInput) -> None:
    refused = core.step(given)
    if refused is not None:
        raise No("refused", refused)


def _check(is_one: Callable[[str], bool], name: str) -> None:
    if len(name) > LONGEST or not is_one(name):
        raise No("invalid", f"{name[:LONGEST]!r} is no tag and no pattern")


def _version(board: Board, tag: str) -> int:
    entry = board.state.get(tag)
    return 0 if entry is None else entry.version


def _entry(entry: Any) -> replies.Entry:
    return replies.Entry(entry.value, entry.version, entry.writer, entry.time)


_ANSWERS: dict[type[protocol.Request], Callable[[Core, Session, Any], replies.Reply]] = {
    protocol.Heartbeat: _heartbeat,
    protocol.Set: _set,
    protocol.Get: _get,
    protocol.Watch: _watch,
    protocol.Unwatch: _unwatch,
    protocol.Publish: _publish,
    protocol.Acquire: _acquire,
    protocol.Abandon: _abandon,
    protocol.Command: _command,
    protocol.Use: _use,
    protocol.Touch: _touch,
    protocol.Attend: _attend,
    protocol.Perform: _perform,
    protocol.Finish: _finish,
    protocol.Serve: _serve,
    protocol.Answer: _answer,
    protocol.Trace: _trace,
    **dict.fromkeys(get_args(protocol.Debugging), _debug),
    **dict.fromkeys(get_args(protocol.Deploying), _deploying),
    protocol.Documents: _documents,
    protocol.Expected: _expected,
    protocol.Modules: _modules,
    protocol.Disclose: _disclose,
    protocol.Bye: _lost,
}
