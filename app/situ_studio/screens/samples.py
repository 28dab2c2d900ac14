"""Sample values: what the texts of a screen stand for while it is designed.

They come from what the project says itself: the tags at the start and what its scenarios set,
type, choose and get from services. None of them is part of a document.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from msgspec import UNSET

from situ.decide import inputs
from situ.document import rbd
from situ.document.names import references
from situ.document.project import Project
from situ.document.values import equal, reach
from situ.errors import UsageError
from situ.rehearse import scenario
from situ.rehearse.expect import Expect

LANGUAGE = "language"
"""The tag that says in which language a robot speaks (formats.md)."""
MOST = 12
"""Values offered of one tag."""
FEW = 40
"""Scenarios read at most: they are examples, not statistics."""


def gather(project: Project) -> dict[str, tuple[Any, ...]]:
    """Tag to the values that the project knows of it, the one of the start first.

    Scenarios that can not be read are passed over: the check tells of them.
    """
    found: dict[str, list[Any]] = {}
    for tag, value in project.tags.items():
        _add(found, tag, value)
    applications = tuple(project.flows.values())
    here = ""
    for line in lines(project):
        match line.does:
            case Expect(fields={"kind": "enter", "state": str(state)}):
                here = state
            case inputs.Use(component=id, value=value):
                for tag in _written(applications, id, here):
                    _add(found, tag, value)
            case does:
                for tag, value in _values(does, applications):
                    _add(found, tag, value)
    return {tag: tuple(values) for tag, values in found.items()}


def wanted(screen: rbd.Screen | None, above: Iterable[rbd.Component] = ()) -> tuple[str, ...]:
    """The names of the values that a screen shows, in its order."""
    found: dict[str, None] = {}
    components = (*(screen.components if screen is not None else ()), *above)
    for one in components:
        match one:
            case rbd.Text(text=text) | rbd.Button(text=text):
                found |= dict.fromkeys(references(text))
            case rbd.Image(src=src) | rbd.Movie(src=src):
                found |= dict.fromkeys(references(src))
            case rbd.List(items=items):
                found[items] = None
            case _:
                pass
    if screen is not None and screen.background:
        found |= dict.fromkeys(references(screen.background))
    return tuple(name for name in found if name)


def chosen(known: Mapping[str, tuple[Any, ...]], picked: Mapping[str, Any]) -> dict[str, Any]:
    """Tag to value: what a person picked, else the first that is known."""
    return {tag: every[0] for tag, every in known.items() if every} | dict(picked)


def filled(
    values: Mapping[str, Any], screen: rbd.Screen | None, above: Iterable[rbd.Component] = ()
) -> dict[str, Any]:
    """The values with something for every name of a screen that has none: a text shows the
    reference itself, a list some entries.
    """
    made: dict[str, Any] = {}
    for one in (*(screen.components if screen is not None else ()), *above):
        if isinstance(one, rbd.List) and value_of(values, one.items) is None:
            made[one.items] = _entries(one.label)
    for name in wanted(screen, above):
        if value_of(values, name) is None and name not in made:
            made[name] = f"{{{name}}}"
    return made | dict(values)


def columns(
    screen: rbd.Screen | None, above: Iterable[rbd.Component] = ()
) -> dict[str, tuple[str, ...]]:
    """The names of lists, each with the fields of its entries that are shown."""
    every = (*(screen.components if screen is not None else ()), *above)
    return {one.items: _fields(one.label) for one in every if isinstance(one, rbd.List)}


def _fields(label: str) -> tuple[str, ...]:
    fields = [name.partition(".")[2] for name in references(label) if name.startswith("item")]
    return tuple(dict.fromkeys(field for field in fields if field and "." not in field))


def _entries(label: str) -> list[Any]:
    """Entries for a list whose label is written so."""
    named = _fields(label)
    if not named:
        return [f"{{item}} {number}" for number in range(1, 4)]
    return [{field: f"{{{field}}} {number}" for field in named} for number in range(1, 4)]


def value_of(values: Mapping[str, Any], name: str) -> Any:
    """The value of a name: that of its tag, or a field of it; None where there is none."""
    if name in values:
        return values[name]
    tag = max((t for t in values if name.startswith(f"{t}.")), key=len, default=None)
    return reach(values[tag], name[len(tag) + 1 :]) if tag is not None else None


def offered(known: Mapping[str, tuple[Any, ...]], name: str) -> tuple[Any, ...]:
    """The values that a name of a text can have."""
    if name in known:
        return known[name]
    found: list[Any] = []
    for tag, every in known.items():
        if name.startswith(f"{tag}."):
            for value in every:
                inner = reach(value, name[len(tag) + 1 :])
                if inner is not None and not any(equal(inner, old) for old in found):
                    found.append(inner)
    return tuple(found[:MOST])


# -- scenarios -----------------------------------------------------------------------------------


def version(project: Project) -> tuple[tuple[str, int, int], ...]:
    """Of the scenarios that ``gather`` reads: another one where they have changed on disk."""
    found = []
    for file in _files(project):
        with suppress(OSError):
            known = file.stat()
            found.append((file.name, known.st_mtime_ns, known.st_size))
    return tuple(found)


def _files(project: Project) -> list[Path]:
    folder = Path(project.root) / project.scenarios if project.scenarios is not None else None
    return sorted(folder.glob("*.jsonl"))[:FEW] if folder is not None else []


def lines(project: Project) -> Iterator[scenario.Line]:
    ours: list[scenario.Line] = []
    others: list[scenario.Line] = []
    for file in _files(project):
        try:
            lines = scenario.load(file)
        except UsageError:
            continue
        (others if _is_foreign(project, lines) else ours).extend(lines)
    yield from (*ours, *others)


def _is_foreign(project: Project, lines: list[scenario.Line]) -> bool:
    """Whether somebody chooses another language there than that of the start."""
    applications = tuple(project.flows.values())
    spoken = project.tags.get(LANGUAGE, project.languages[0] if project.languages else None)
    for line in lines:
        if isinstance(line.does, inputs.Set) and line.does.tags.get(LANGUAGE, spoken) != spoken:
            return True
        if isinstance(line.does, inputs.Use):
            for one in _components(applications, line.does.component):
                sets = isinstance(one, rbd.Button) and one.tag == LANGUAGE
                if sets and getattr(one, "value", spoken) != spoken:
                    return True
    return False


def _values(does: Any, applications: tuple[rbd.Application, ...]) -> Iterator[tuple[str, Any]]:
    match does:
        case inputs.Set(tags=tags):
            yield from tags.items()
        case inputs.Finish(name=name, ok=True, result=result):
            for service in _services(applications, name):
                for one in service.results:
                    value = reach(result, one.path) if one.path else result
                    if value is not None:
                        yield one.tag, value
        case Expect(fields={"kind": "data", "tag": str(tag), "value": value}):
            if value is not None:
                yield tag, value
        case _:
            return


def _components(applications: tuple[rbd.Application, ...], id: str) -> Iterator[rbd.Component]:
    for application in applications:
        for state in application.states:
            if state.screen is not None:
                yield from (c for c in state.screen.components if c.id == id)


def _written(applications: tuple[rbd.Application, ...], id: str, here: str) -> set[str]:
    """The tag to which a component writes: that of the state's own, else of the only one."""
    for application in applications:
        state = application.state(here)
        for one in state.screen.components if state is not None and state.screen else ():
            if one.id == id:
                return _tag_of(one)
    every = set[str]().union(*(_tag_of(one) for one in _components(applications, id)))
    return every if len(every) == 1 else set()


def _tag_of(component: rbd.Component) -> set[str]:
    tag = getattr(component, "tag", None)
    return {tag} if tag else set()


def _services(applications: tuple[rbd.Application, ...], name: str | None) -> Iterator[rbd.Service]:
    for application in applications:
        for state in application.states:
            for action in (*state.actions, *(a for e in state.events for a in e.actions)):
                if isinstance(action, rbd.Service) and action.name == name:
                    yield action


def _add(found: dict[str, list[Any]], tag: str, value: Any) -> None:
    every = found.setdefault(tag, [])
    if value is None or value is UNSET:
        return
    if len(every) < MOST and not any(equal(value, old) for old in every):
        every.append(value)
