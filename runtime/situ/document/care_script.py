"""Care with what decides: that the robot can be stopped, and that no missing value moves it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeGuard

from situ.document import names, words
from situ.document.analysis_data import CLOCK, actions, holders, placed_actions, screens
from situ.document.analysis_search import Search
from situ.document.analysis_written import constant
from situ.document.care_mend import path_to
from situ.document.condition import Condition, Group, Test
from situ.document.datatypes import shown
from situ.document.finding import Place
from situ.document.mend import written
from situ.document.problem import Change, Mend
from situ.document.project import Project
from situ.document.rbd import Application, Clear, List, Robot, Service, Set, Take
from situ.document.spds import Observed, Situation, Spds

HARMLESS = frozenset(("screen", "speech", "head", "face", "lights"))
"""Resources that hurt nobody: a head turns where it is."""

STOP = "robot.stop"
"""The tag that the mend of ``nothing-stops`` looks at."""


# -- what stops the robot ----------------------------------------------------------


def nothing_stops(search: Search) -> None:
    """``nothing-stops``: something may move more than ``HARMLESS`` of the robot, and no first
    situation takes that away from all.

    Such a situation stands before all others, has a condition, and gives no module a priority
    that declared another resource. One with ``limit`` is none: the robot would move again while
    the condition still holds. Without a script, applications with robot actions are told, and
    only in a whole project.
    """
    project = search.project
    if project.spds is None or project.spds_file is None:
        if search.whole:
            for file, application in project.applications.items():
                _unstopped(search, file, application)
        return
    script, moving = project.spds, _moving(project)
    dangerous = {m for s in script.situations for m in script.priorities(s) if moving.get(m)}
    first = script.situations[0] if script.situations else None
    if not dangerous or first is None or _is_stop(script, first, dangerous):
        return
    who = words.listed(shown(one) for one in sorted(dangerous)[:3])
    message = (
        f"Nothing stops this robot ({who} may move it): begin with a situation, without a limit, "
        "that gives no priority to what moves it and holds while somebody says stop"
    )
    place = ("situation", first.name)
    search.warn(project.spds_file, "nothing-stops", message, first.aside, place, _stop(search))


def _moving(project: Project) -> dict[str, set[str]]:
    """Module to the resources with which it can do harm."""
    found = {name: set(having) - HARMLESS for name, having in project.declared().items()}
    for application in project.applications.values():
        declared = project.resources(application.name)
        found[application.name] = set(declared or ()) - HARMLESS
    return found


def _is_stop(script: Spds, situation: Situation, dangerous: set[str]) -> bool:
    if situation.condition is None or situation.limit is not None:
        return False
    return not dangerous & set(script.priorities(situation))


def _stop(search: Search) -> Mend | None:
    script, file = search.project.spds, search.project.spds_file
    assert script is not None
    assert file is not None
    if script.situation("stopped") is not None:
        return None
    when = Condition((Test(STOP, "is", "true"),))
    changes = [Change(("situations", 0), "insert", written(Situation("stopped", condition=when)))]
    if all(one.tag != STOP for one in script.observe):
        changes.append(Change(("observe", 0), "insert", written(Observed(STOP, "boolean"))))
    return search.mend(file, f"Begin with a situation that holds while {STOP} is true", *changes)


def _unstopped(search: Search, file: str, application: Application) -> None:
    for action, place in placed_actions(application):
        if isinstance(action, Robot) and action.resource not in HARMLESS:
            message = (
                f"Nothing stops this robot once it moves ({shown(action.resource)}): write a "
                "script whose first situation gives nobody a priority while somebody says stop"
            )
            search.warn(file, "nothing-stops", message, action.aside, place)
            return


# -- isnot -------------------------------------------------------------------------


def isnot_alone(search: Search) -> None:
    """``isnot-without-exists``: a condition can hold because a value is missing, by ``isnot``.

    Not where what must hold with it needs that value (each test but ``isnot`` and
    ``exists="false"`` does); where ``exists="false"`` beside it in an ``any`` says that it is
    meant; under ``none``; with ``within``, which needs a value that was set; for what the runtime
    keeps; nor for what ``[tags]`` or the start state gives and nothing in the project takes away.
    """
    taken: _Taken | None = None
    for file, condition, place in _conditions(search.project):
        for test, at, in_all in _alone(condition, place, set()):
            taken = taken or _Taken(search.project)
            if taken.never_missing(file, test.tag):
                continue
            message = (
                f"This holds too while {shown(test.tag)} is missing, as when its sensor is off: "
                f"ask beside it that {shown(test.tag)} exists"
            )
            mend: Mend | None = None
            if in_all:
                path = path_to(search, file, at, test)
                to = written(Test(test.tag, "exists", "true"))
                if path is not None:
                    said = f"Ask that {test.tag} exists"
                    mend = search.mend(file, said, Change(path, "insert", to))
            search.warn(file, "isnot-without-exists", message, test.aside, at, mend)


def _conditions(project: Project) -> Iterator[tuple[str, Condition, Place]]:
    for file, application in project.flows.items():
        for holder, place in holders(application):
            for index, event in enumerate(holder.events):
                if event.when is not None:
                    yield file, event.when, (*place, "event", str(index), "when")
    if project.spds is not None and project.spds_file is not None:
        for situation in project.spds.situations:
            place = ("situation", situation.name)
            if situation.condition is not None:
                yield project.spds_file, situation.condition, (*place, "condition")
            if situation.until is not None:
                yield project.spds_file, situation.until, (*place, "until")


def _alone(
    group: Condition | Group, place: Place, told: set[str]
) -> Iterator[tuple[Test, Place, bool]]:
    """The ``isnot`` of a group that can hold on a missing value, and whether all beside it must
    hold too; ``told``: the tags of which something around the group speaks.
    """
    kind = group.kind if isinstance(group, Group) else "all"
    if kind == "none":
        return
    if kind == "all":
        told = told | _needed(group)
    else:
        told = told | {one.tag for one in group.children if _is_missing(one)}
    for index, child in enumerate(group.children):
        at = (*place, str(index))
        if isinstance(child, Group):
            yield from _alone(child, at, told)
        elif child.test == "isnot" and child.within is None and not _is_told(child.tag, told):
            yield child, at, kind == "all"


def _is_told(tag: str, told: set[str]) -> bool:
    # What is inside a value cannot be there without it.
    return any(one == tag or one.startswith(f"{tag}.") for one in told)


def _needed(one: Condition | Group | Test) -> set[str]:
    """The tags that must have a value where this holds."""
    if isinstance(one, Test):
        needs = one.within is not None or (one.test != "isnot" and not _is_missing(one))
        return {one.tag} if needs else set()
    found = [_needed(child) for child in one.children]
    if isinstance(one, Group) and one.kind == "none":
        return {child.tag for child in one.children if _is_missing(child)}
    if isinstance(one, Group) and one.kind == "any":
        return set.intersection(*found) if found else set()
    return set().union(*found)


def _is_missing(one: Test | Group) -> TypeGuard[Test]:
    return isinstance(one, Test) and one.test == "exists" and one.value == "false"


class _Taken:
    """What may take values away again."""

    def __init__(self, project: Project) -> None:
        self._project = project
        self._tags: set[str] = set()
        self._patterns: set[str] = set()
        for application in project.flows.values():
            for action in actions(application):
                if isinstance(action, Clear):
                    self._patterns.add(action.tag)
                elif isinstance(action, Set):
                    known, value = constant(action.text)
                    if value is None and (known or names.only_reference(action.text)):
                        self._tags.add(action.tag)
                elif isinstance(action, Take):
                    self._tags.add(action.tag)
                elif isinstance(action, Service):
                    self._tags |= {result.tag for result in action.results}
            for screen, _ in screens(application):
                for component in screen.components:
                    if isinstance(component, List) and component.tag is not None:
                        self._tags.add(component.tag)

    def never_missing(self, file: str, name: str) -> bool:
        root = name.partition("/")[0].partition(".")[0]
        if root in ("application", "situation", "listen") or name in CLOCK:
            return True
        if name in self._tags or any(names.matches(one, name) for one in self._patterns):
            return False
        return self._project.tags.get(name) is not None or name in self._at_start(file)

    def _at_start(self, file: str) -> set[str]:
        """What an application's start state gives a value before any condition is judged."""
        application = self._project.applications.get(file)
        start = application.state(application.start_no or "") if application is not None else None
        given: set[str] = set()
        for action in start.actions if start is not None else ():
            if isinstance(action, Set) and constant(action.text)[1] is not None:
                given.add(action.tag)
            if action.wait:
                break
        return given
