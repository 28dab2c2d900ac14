"""Scenarios: what feeds the simulator, one JSON object a line (formats.md, *Scenarios*)."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import msgspec
from msgspec import UNSET, Struct, UnsetType

from situ.decide import inputs
from situ.decide.step import SECOND, microseconds
from situ.errors import ScenarioError, UsageError
from situ.rehearse.expect import Expect

WRITER = "scenario"


class End(Struct, frozen=True):
    """The run ends here; what falls due now is done."""


class Line(Struct, frozen=True):
    """One line: its number in the file, its time in µs, and what it does."""

    number: int
    at: int
    does: inputs.AnyInput | Expect | End


class _Finish(Struct, forbid_unknown_fields=True):
    action: str | None = None
    name: str | None = None
    application: str | None = None
    ok: bool = True
    result: Any = None
    error: str | None = None
    status: int | None = None


class _Line(Struct, forbid_unknown_fields=True):
    at: float
    set: dict[str, Any] | UnsetType = UNSET
    event: str | UnsetType = UNSET
    application: str | UnsetType = UNSET
    touch: bool | UnsetType = UNSET
    use: inputs.Use | UnsetType = UNSET
    acquire: inputs.Acquire | UnsetType = UNSET
    abandon: inputs.Abandon | UnsetType = UNSET
    command: inputs.Command | UnsetType = UNSET
    lost: inputs.Lost | UnsetType = UNSET
    finish: _Finish | UnsetType = UNSET
    expect: dict[str, Any] | UnsetType = UNSET
    end: bool | UnsetType = UNSET


VERBS = (
    "set", "event", "touch", "use", "acquire", "abandon", "command", "lost", "finish",
    "expect", "end",
)  # fmt: skip


def load(path: str | Path, applications: Iterable[str] | None = None) -> list[Line]:
    """The scenario at ``path``; ``applications`` are the names it may speak of.

    Raises UsageError where the file can not be read, ScenarioError where a line is wrong.
    """
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        raise UsageError(f"{path}: {error.strerror or error}") from None
    return parse(data, str(path), applications)


def parse(data: bytes, file: str, applications: Iterable[str] | None = None) -> list[Line]:
    """The scenario in ``data``. Empty lines are passed over; raises ScenarioError."""
    known = None if applications is None else set(applications)
    lines: list[Line] = []
    for number, text in enumerate(data.split(b"\n"), 1):
        if not text.strip():
            continue
        try:
            line = _read(number, text, known)
            if lines and isinstance(lines[-1].does, End):
                raise ScenarioError("the scenario has ended; delete this line or move the end")
            if lines and line.at < lines[-1].at:
                raise ScenarioError(
                    f"time goes back: {line.at / 1e6:g} after {lines[-1].at / 1e6:g}; "
                    "order the lines by time"
                )
        except (ScenarioError, msgspec.DecodeError, UnicodeDecodeError) as error:
            raise ScenarioError(f"{file}:{number}: {error}") from None
        except RecursionError:
            said = "lists and objects stand too deep in each other; take some out"
            raise ScenarioError(f"{file}:{number}: {said}") from None
        lines.append(line)
    return lines


def write(lines: Iterable[tuple[int, inputs.AnyInput | Expect | End]]) -> bytes:
    """Times in µs and what is done then, in order, as a scenario's lines; ``parse`` reads the same.

    Raises ValueError for an input that scenarios have no verb for.
    """
    return b"".join(_written(at, does) + b"\n" for at, does in lines)


def _written(at: int, does: inputs.AnyInput | Expect | End) -> bytes:
    seconds: int | float = at // SECOND if at % SECOND == 0 else at / SECOND
    fields: dict[str, Any]
    match does:
        case End():
            fields = {"end": True}
        case Expect():
            fields = {"expect": does.fields}
        case inputs.Touch():
            fields = {"touch": True}
        case inputs.Set():
            fields = {"set": does.tags}
        case inputs.Raise(event=event, application=application):
            fields = {"event": event}
            if application is not None:
                fields["application"] = application
        case inputs.Use() | inputs.Acquire() | inputs.Abandon() | inputs.Command():
            fields = {type(does).__name__.lower(): _own(does)}
        case inputs.Lost() | inputs.Finish(id=None):
            fields = {type(does).__name__.lower(): _own(does)}
        case _:
            raise ValueError(f"a scenario has no verb for {type(does).__name__}")
    return msgspec.json.encode({"at": seconds, **fields})


def _own(does: inputs.AnyInput) -> dict[str, Any]:
    """The fields that are not as they are where nothing is said."""
    found = msgspec.to_builtins(does)
    usual = {f.encode_name: f.default for f in msgspec.structs.fields(does)}
    return {
        name: value
        for name, value in found.items()
        if name != "verb" and (usual[name] is msgspec.NODEFAULT or value != _plain(usual[name]))
    }


def _plain(value: Any) -> Any:
    return list(value) if isinstance(value, tuple) else value


def _read(number: int, text: bytes, applications: set[str] | None) -> Line:
    line = msgspec.json.decode(text, type=_Line)
    verbs = [verb for verb in VERBS if getattr(line, verb) is not UNSET]
    if len(verbs) != 1:
        found = ", ".join(verbs) if verbs else "none"
        raise ScenarioError(f"a line has exactly one verb of {', '.join(VERBS)}; here: {found}")
    if not 0 <= line.at < 1e9:
        raise ScenarioError("“at” is a time in seconds, 0 or more")
    verb = verbs[0]
    if line.application is not UNSET and verb != "event":
        raise ScenarioError("“application” goes with “event” only")
    does = _DO[verb](line)
    named = getattr(does, "application", None)
    if applications is not None and named is not None and named not in applications:
        raise ScenarioError(
            f"unknown application {named}; there is {', '.join(sorted(applications)) or 'none'}"
        )
    return Line(number, microseconds(line.at), does)


def _end(line: _Line) -> End:
    if line.end is not True:
        raise ScenarioError("“end” is true or left out")
    return End()


def _touch(line: _Line) -> inputs.Touch:
    if line.touch is not True:
        raise ScenarioError("“touch” is true or left out")
    return inputs.Touch()


def _command(line: _Line) -> inputs.Command:
    given = line.command
    assert not isinstance(given, UnsetType)
    if given.valid is not None and given.valid <= 0:
        raise ScenarioError("“for” is seconds above 0")
    return given


def _event(line: _Line) -> inputs.Raise:
    assert not isinstance(line.event, UnsetType)
    return inputs.Raise(line.event, None if line.application is UNSET else line.application)


def _finish(line: _Line) -> inputs.Finish:
    given = line.finish
    assert not isinstance(given, UnsetType)
    return inputs.Finish(
        given.action, given.name, given.application, given.ok, given.result, given.error,
        given.status,
    )  # fmt: skip


_DO: dict[str, Any] = {
    "set": lambda line: inputs.Set(line.set, WRITER),
    "event": _event,
    "touch": _touch,
    "use": lambda line: line.use,
    "acquire": lambda line: line.acquire,
    "abandon": lambda line: line.abandon,
    "command": _command,
    "lost": lambda line: line.lost,
    "finish": _finish,
    "expect": lambda line: Expect(line.expect),
    "end": _end,
}
