"""The words that a form can complete: what a project already knows."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import compress, count
from operator import is_not
from typing import Any

from msgspec import Struct

from situ.document import rbd
from situ.document.condition import Condition, Group, Test
from situ.document.names import references
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import DataType, Observed, Spds
from situ_studio.edits.edit import Document


class Vocabulary(Struct, frozen=True):
    """Sorted, without doubles; states and situations in the document's order."""

    states: tuple[tuple[str, str], ...] = ()
    events: tuple[str, ...] = ()
    tags: tuple[str, ...] = ()
    resources: tuple[str, ...] = ()
    situations: tuple[str, ...] = ()
    modules: tuple[str, ...] = ()
    media: tuple[str, ...] = ()
    data: tuple[tuple[str, DataType | None, str], ...] = ()
    """Tags of which type or unit are known."""

    def type_of(self, tag: str) -> tuple[DataType | None, str]:
        """Type and unit of a datum, None and "" where nobody said them."""
        known = ((kind, unit) for name, kind, unit in self.data if name == tag)
        return next(known, (None, ""))


def _tests(condition: Condition | Group | None) -> Iterator[Test]:
    for child in condition.children if condition is not None else ():
        if isinstance(child, Test):
            yield child
        else:
            yield from _tests(child)


def _parts(application: Application) -> Iterator[rbd.State | rbd.Always]:
    if application.always is not None:
        yield application.always
    yield from application.states


def _actions(part: rbd.State | rbd.Always) -> Iterator[rbd.Action]:
    if isinstance(part, rbd.State):
        yield from part.actions
    for event in part.events:
        yield from event.actions


def events(part: rbd.State | rbd.Always) -> frozenset[str]:
    """Every event that a state expects or raises by itself."""
    found: set[str | None] = {e.name for e in part.events}
    for action in _actions(part):
        found |= {action.done, action.failed}
    if part.screen is not None:
        found.add(part.screen.touched)
        for component in part.screen.components:
            found |= {getattr(component, field, None) for field in ("event", "done", "failed")}
    return frozenset(name for name in found if name)


def tags(part: rbd.State | rbd.Always) -> frozenset[str]:
    """Every tag that a state writes, reads or waits for."""
    found: set[str | None] = set()
    for event in part.events:
        found |= {t.tag for t in _tests(event.when)}
    for action in _actions(part):
        if not isinstance(action, rbd.Clear):
            found |= {getattr(action, "tag", None), getattr(action, "source", None)}
        texts: list[Any] = [getattr(action, "text", ""), getattr(action, "url", "")]
        texts += [p.text for p in getattr(action, "params", ())]
        found |= {r.tag for r in getattr(action, "results", ())}
        for text in texts:
            found |= set(references(text))
    if part.screen is not None:
        for component in part.screen.components:
            found |= {getattr(component, "tag", None), getattr(component, "items", None)}
            found |= set(references(getattr(component, "text", "")))
    return frozenset(tag for tag in found if tag)


class _Words(Struct, frozen=True):
    events: frozenset[str]
    tags: frozenset[str]
    resources: frozenset[str]


class _Read(Struct, frozen=True):
    """What was read of one application: its parts, the words of each, and of all together."""

    application: Application
    parts: list[rbd.State | rbd.Always]
    words: list[_Words]
    every: _Words
    states: tuple[tuple[str, str], ...]


def _words(part: rbd.State | rbd.Always) -> _Words:
    robot = (a for a in _actions(part) if isinstance(a, rbd.Robot))
    return _Words(events(part), tags(part), frozenset(a.resource for a in robot))


def _union(words: Iterable[_Words]) -> _Words:
    every = list(words)
    return _Words(
        frozenset().union(*(one.events for one in every)),
        frozenset().union(*(one.tags for one in every)),
        frozenset().union(*(one.resources for one in every)),
    )


def _read(application: Application, before: _Read | None) -> _Read:
    """before: what was read of the same application; what did not change is taken from it."""
    if before is not None and before.application is application:
        return before
    parts = [*_parts(application)]
    shape = len(parts), application.always is None
    if before is not None and shape == (len(before.parts), before.application.always is None):
        words, states = list(before.words), before.states
        same = True
        # ``always`` is no state.
        first = len(parts) - len(application.states)
        for at in compress(count(), map(is_not, before.parts, parts)):
            words[at] = _words(parts[at])
            same = same and words[at] == before.words[at]
            if at >= first and states[at - first] != _called(parts[at]):
                states = (*states[: at - first], _called(parts[at]), *states[at - first + 1 :])
        every = before.every if same else _union(words)
    else:
        known = dict(zip(map(id, before.parts), before.words, strict=True)) if before else {}
        words = [known.get(id(part)) or _words(part) for part in parts]
        every, states = _union(words), tuple(map(_called, application.states))
    return _Read(application, parts, words, every, states)


def _called(part: rbd.State | rbd.Always) -> tuple[str, str]:
    assert isinstance(part, rbd.State)
    return part.no, part.name


class Lexicon:
    """Makes vocabularies of successive values of a project; only what changed is read anew.

    media: the files of a project's media, for whoever completes them.
    """

    def __init__(self, media: Callable[[Project], tuple[str, ...]] = lambda _: ()) -> None:
        self._media = media
        self._read: list[_Read] = []
        self._project: Project | None = None
        self._document: Document | None = None
        self._made = Vocabulary()

    def vocabulary(self, project: Project, document: Document) -> Vocabulary:
        """What a form of ``document`` completes from."""
        if project is not self._project or document is not self._document:
            self._project, self._document = project, document
            self._made = self._make(project, document)
        return self._made

    def _make(self, project: Project, document: Document) -> Vocabulary:
        every = (*project.applications.values(), *project.parts.values())
        before = {one.application.name: one for one in self._read}
        self._read = [_read(application, before.get(application.name)) for application in every]
        words = _union(one.every for one in self._read)
        known_tags = {*project.tags, *words.tags}
        resources = {"screen", "speech", *words.resources}
        if project.spds is not None:
            known_tags |= {o.tag for o in project.spds.observe}
            for situation in project.spds.situations:
                known_tags |= {t.tag for t in _tests(situation.condition)}
                known_tags |= {t.tag for t in _tests(situation.until)}
        if project.modules is not None:
            for module in project.modules.modules:
                known_tags |= {p.data for p in module.provides}
        for each in project.declared().values():
            resources |= set(each)
        script = document if isinstance(document, Spds) else project.spds
        application = document if isinstance(document, Application) else None
        return Vocabulary(
            states=self._states_of(application) if application is not None else (),
            events=tuple(sorted(words.events)),
            tags=tuple(sorted(known_tags)),
            resources=tuple(sorted(resources)),
            situations=tuple(s.name for s in script.situations) if script is not None else (),
            modules=tuple(sorted({*project.declared(), *_names(project)})),
            media=self._media(project),
            data=known_data(project, script.observe if script is not None else ()),
        )

    def _states_of(self, application: Application) -> tuple[tuple[str, str], ...]:
        """The very same value while no number and no name changes."""
        known = (one.states for one in self._read if one.application is application)
        return next(known, None) or tuple((s.no, s.name) for s in application.states)


def known_data(
    project: Project | None, observe: Iterable[Observed]
) -> tuple[tuple[str, DataType | None, str], ...]:
    """Type and unit of tags, as a script observes them or else modules provide them."""
    found: dict[str, tuple[DataType | None, str]] = {}
    if project is not None and project.modules is not None:
        for module in project.modules.modules:
            found |= {p.data: (p.type, p.unit or "") for p in module.provides}
    found |= {o.tag: (o.type, o.unit or "") for o in observe if o.type or o.unit}
    return tuple((tag, kind, unit) for tag, (kind, unit) in found.items() if kind or unit)


def _names(project: Project) -> set[str]:
    return {a.name for a in project.applications.values()}
