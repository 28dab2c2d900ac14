"""A project from pieces of XML, a scenario from a list, and the trace in one line an event.

::

    trace = play('<state no="1">…</state>', [{"at": 1, "event": "go"}])
    assert trace.lines("enter") == ["0 enter app 1 <-", "1 enter app 2 <transition"]

A line is time, kind, the fields of the kind in the order of formats.md, and ``<`` with
the kind of the event that caused it: ``<data`` is the last one before, ``<data^1`` the
one before that, ``<-`` none.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Protocol

import pytest

from situ.decide.trace import TraceEvent, to_fields, to_line
from situ.document import codec
from situ.document.check import check
from situ.document.modules import Modules
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ.rehearse import scenario
from situ.rehearse.simulate import simulate

Event = dict[str, Any]


class Trace(list[Event]):
    """The events of a run. raw: as bytes. failures: of its expectations."""

    raw: bytes = b""
    failures: Sequence[object] = ()

    def of(self, *kinds: str, **fields: Any) -> list[Event]:
        """The events of these kinds (none: of every kind) that have these fields."""
        return [
            event
            for event in self
            if (not kinds or event["kind"] in kinds)
            and all(event.get(key) == value for key, value in fields.items())
        ]

    def one(self, kind: str, **fields: Any) -> Event:
        """The only event of this kind with these fields."""
        found = self.of(kind, **fields)
        assert len(found) == 1, f"{len(found)} × {kind} {fields} in {self.lines()}"
        return found[0]

    def lines(self, *kinds: str, since: float = 0, but: Iterable[str] = ()) -> list[str]:
        """One line an event: those of these kinds (none: of all but ``but``), from ``since`` on."""
        return [
            self.line(event)
            for event in self
            if event["t"] >= since
            and event["kind"] not in but
            and (not kinds or event["kind"] in kinds)
        ]

    def line(self, event: Event) -> str:
        told = _TOLD[event["kind"]](event)
        return f"{event['t']:g} {event['kind']} {told} <{self._cause(event)}"

    def cause(self, event: Event) -> Event | None:
        """The event that caused this one."""
        return None if event["cause"] is None else self[event["cause"] - 1]

    def chain(self, event: Event) -> list[str]:
        """The kinds of this event and of its causes, back to the first."""
        found = []
        at: Event | None = event
        while at is not None:
            found.append(at["kind"])
            at = self.cause(at)
        return found

    def states(self, application: str = "app") -> list[tuple[float, str]]:
        """When it entered which state."""
        return [(e["t"], e["state"]) for e in self.of("enter", application=application)]

    def situations(self) -> list[tuple[float, str | None]]:
        """When which situation became current."""
        return [(e["t"], e["to"]) for e in self.of("situation")]

    def values(self, tag: str) -> list[Any]:
        """What was written to the tag, one after the other."""
        return [e["value"] for e in self.of("data", tag=tag)]

    def _cause(self, event: Event) -> str:
        cause = self.cause(event)
        if cause is None:
            return "-"
        later = self[cause["seq"] : event["seq"] - 1]
        back = sum(one["kind"] == cause["kind"] for one in later)
        return f"{cause['kind']}^{back}" if back else str(cause["kind"])


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def _dash(value: str | None) -> str:
    return "-" if value is None else value


def _set(resources: Iterable[str]) -> str:
    return f"[{' '.join(resources)}]"


def _shown(component: Event) -> str:
    rest = component.get("text", component.get("value", component.get("src")))
    return str(component["id"]) if rest is None else f"{component['id']}={rest}"


def _mapped(event: Event) -> str:
    value = event["value"]
    if isinstance(value, dict) and "components" in value:
        value = _set(map(_shown, value["components"]))
    else:
        value = _json(value)
    return f"{event['resource']} {_dash(event['module'])} {value}"


def _action(event: Event) -> str:
    fields = ("text", "lang", "resource", "params", "method", "url", "topic", "from", "tag", "src")
    told = [f"{key}={_json(event[key])}" for key in fields if event.get(key) not in (None, {})]
    if "value" in event:
        told.append(f"value={_json(event['value'])}")
    return " ".join(
        [event["application"], event["state"], event["action"], _dash(event["name"]), *told]
    )


def _finished(event: Event) -> str:
    ended = f"ok {_json(event['result'])}" if event["ok"] else f"failed {_json(event['error'])}"
    return f"{event['application']} {event['action']} {_dash(event['name'])} {ended}"


def _transition(event: Event) -> str:
    why = "timeout" if event.get("timeout") else _dash(event["event"])
    return f"{event['application']} {event['from']} {event['to']} {why}"


def _acquire(event: Event) -> str:
    optional = f" {_set(event['optional'])}" if event.get("optional") else ""
    return f"{event['module']} {_set(event['resources'])}{optional}"


_TOLD: dict[str, Callable[[Event], str]] = {
    "data": lambda e: f"{e['tag']} {_json(e['value'])} {e['writer']} v{e['version']}",
    "condition": lambda e: f"{e['situation']} {_json(e['holds'])}",
    "situation": lambda e: f"{_dash(e['from'])} {_dash(e['to'])}",
    "acquire": _acquire,
    "abandon": _acquire,
    "lost": _acquire,
    "authority": lambda e: f"{e['resource']} {_dash(e['from'])} {_dash(e['to'])}",
    "mapping": _mapped,
    "event": lambda e: f"{e['application']} {e['name']}",
    "ignored": lambda e: f"{e['application']} {e['name']} {e['reason']}",
    "exit": lambda e: f"{e['application']} {e['state']}",
    "enter": lambda e: f"{e['application']} {e['state']}",
    "transition": _transition,
    "screen": lambda e: f"{e['application']} {e['state']} {_set(map(_shown, e['components']))}",
    "action": _action,
    "finished": _finished,
    "cancelled": lambda e: f"{e['application']} {e['action']} {_dash(e['name'])}",
    "suspend": lambda e: f"{e['application']} {_set(e['missing'])}",
    "resume": lambda e: f"{e['application']} {_set(e['missing'])}",
    "deployed": lambda e: f"v{e['version']} {_set(e['files'])} {e['writer']}",
    "warning": lambda e: e["message"],
    "error": lambda e: e["message"],
}


RESOURCES = ("acquire", "abandon", "authority", "mapping")
"""Kinds that only tell of resources, for tests of something else."""


class Build(Protocol):
    def __call__(
        self,
        rbd: str | Sequence[str] = ...,
        spds: str | None = ...,
        modules: str | None = ...,
        **project: Any,
    ) -> Project: ...


class Play(Protocol):
    def __call__(
        self,
        rbd: str | Sequence[str],
        lines: Sequence[Event],
        *,
        spds: str | None = ...,
        modules: str | None = ...,
        pauses: str | None = ...,
        seed: int = ...,
        auto_finish: float | None = ...,
        **project: Any,
    ) -> Trace: ...


def build_project(
    rbd: str | Sequence[str] = (),
    spds: str | None = None,
    modules: str | None = None,
    **project: Any,
) -> Project:
    """Pieces of XML as a project: states alone become the application ``app``, situations
    alone the script ``script``. Every document must be read without a problem.
    """
    applications = {}
    for number, text in enumerate([rbd] if isinstance(rbd, str) else rbd):
        file = f"app{number}.rbd.xml"
        read = _read(_wrap(text, "application", "app"), file)
        assert isinstance(read, Application)
        applications[file] = read
    script = None if spds is None else _read(_wrap(spds, "spds", "script"), "s.spds.xml")
    known = None if modules is None else _read(f"<modules>{modules}</modules>", "modules.xml")
    assert script is None or isinstance(script, Spds)
    assert known is None or isinstance(known, Modules)
    built = Project(
        root=".", name="test", applications=applications, spds=script, modules=known, **project
    )
    errors = [str(problem) for problem in check(built) if problem.severity == "error"]
    assert not errors, "\n".join(errors)
    return built


def _wrap(text: str, element: str, name: str) -> str:
    if text.lstrip().startswith(f"<{element}"):
        return text
    return f'<{element} name="{name}">{text}</{element}>'


def _read(text: str, file: str) -> object:
    document, problems = codec.read(text.encode(), file)
    assert not problems, "\n".join(map(str, problems))
    return document


def run(
    project: Project,
    lines: Sequence[Event],
    seed: int = 0,
    auto_finish: float | None = None,
) -> Trace:
    """Plays the scenario in virtual time."""
    trace, raw = Trace(), bytearray()

    def tell(events: list[TraceEvent]) -> None:
        for event in events:
            trace.append(to_fields(event))
            raw.extend(to_line(event))

    text = "\n".join(json.dumps(line) for line in lines)
    known = [application.name for application in project.applications.values()]
    verdict = simulate(project, scenario.parse(text.encode(), "s", known), seed, auto_finish, tell)
    trace.raw, trace.failures = bytes(raw), verdict.failures
    return trace


_PAUSING = """
  <observe><data tag="busy"/></observe>
  <modules><module name="app" resources="{}"/></modules>
  <situation name="busy"><condition><data tag="busy" is="true"/></condition></situation>
  <situation name="calm"><module name="app" priority="1"/></situation>
"""


@pytest.fixture
def build() -> Build:
    return build_project


@pytest.fixture
def play() -> Play:
    """Builds a project and plays a scenario in it. ``pauses``: resources of the application
    ``app`` in a script of two situations; while the tag ``busy`` is true it may hold none.
    """

    def played(
        rbd: str | Sequence[str],
        lines: Sequence[Event],
        *,
        spds: str | None = None,
        modules: str | None = None,
        pauses: str | None = None,
        seed: int = 0,
        auto_finish: float | None = None,
        **project: Any,
    ) -> Trace:
        script = spds if pauses is None else _PAUSING.format(pauses)
        return run(build_project(rbd, script, modules, **project), lines, seed, auto_finish)

    return played
