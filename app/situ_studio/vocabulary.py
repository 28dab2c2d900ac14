"""The words that a form can complete: what a project already knows."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from msgspec import Struct

from situ.document import rbd
from situ.document.condition import Condition, Group, Test
from situ.document.names import references
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.edit import Document


class Vocabulary(Struct, frozen=True):
    """Sorted, without doubles; states and situations in the document's order."""

    states: tuple[tuple[str, str], ...] = ()
    events: tuple[str, ...] = ()
    tags: tuple[str, ...] = ()
    resources: tuple[str, ...] = ()
    situations: tuple[str, ...] = ()
    modules: tuple[str, ...] = ()
    media: tuple[str, ...] = ()


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
            found |= {getattr(component, "event", None), getattr(component, "done", None)}
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


class _Known(Struct, frozen=True):
    """What one state adds; kept as long as the state is this very value."""

    part: rbd.State | rbd.Always
    words: _Words


def _media(project: Project) -> tuple[str, ...]:
    if project.media is None:
        return ()
    folder = Path(project.root) / project.media
    if not folder.is_dir():
        return ()
    every = (f for f in folder.rglob("*") if f.is_file())
    return tuple(sorted(f.relative_to(folder).as_posix() for f in every))


class Lexicon:
    """Makes vocabularies of successive values of a project; only what changed is read anew."""

    def __init__(self) -> None:
        self._known: dict[int, _Known] = {}
        self._words = _Words(frozenset(), frozenset(), frozenset())
        self._of: list[_Known] = []
        self._project: Project | None = None
        self._document: Document | None = None
        self._made = Vocabulary()

    def vocabulary(self, project: Project, document: Document) -> Vocabulary:
        """What a form of ``document`` completes from."""
        if project is not self._project or document is not self._document:
            self._project, self._document = project, document
            self._made = self._make(project, document)
        return self._made

    def _parts(self, project: Project) -> Iterator[_Known]:
        kept: dict[int, _Known] = {}
        for application in (*project.applications.values(), *project.parts.values()):
            for part in _parts(application):
                known = self._known.get(id(part))
                if known is None or known.part is not part:
                    robot = (a for a in _actions(part) if isinstance(a, rbd.Robot))
                    resources = frozenset(a.resource for a in robot)
                    known = _Known(part, _Words(events(part), tags(part), resources))
                kept[id(part)] = known
                yield known
        self._known = kept

    def _words_of(self, parts: list[_Known]) -> _Words:
        """Of all states; those of before where no state has other words than it had."""
        before, self._of = self._of, parts
        if len(before) == len(parts) and all(
            old.words == new.words for old, new in zip(before, parts, strict=True) if old is not new
        ):
            return self._words
        self._words = _Words(
            frozenset().union(*(known.words.events for known in parts)),
            frozenset().union(*(known.words.tags for known in parts)),
            frozenset().union(*(known.words.resources for known in parts)),
        )
        return self._words

    def _make(self, project: Project, document: Document) -> Vocabulary:
        words = self._words_of([*self._parts(project)])
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
            states=tuple((s.no, s.name) for s in application.states) if application else (),
            events=tuple(sorted(words.events)),
            tags=tuple(sorted(known_tags)),
            resources=tuple(sorted(resources)),
            situations=tuple(s.name for s in script.situations) if script is not None else (),
            modules=tuple(sorted({*project.declared(), *_names(project)})),
            media=_media(project),
        )


def _names(project: Project) -> set[str]:
    return {a.name for a in project.applications.values()}
