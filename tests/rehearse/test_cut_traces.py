"""A trace that begins late, ends early or is another project's is read as far as it goes."""

from __future__ import annotations

from typing import Any

import pytest

from situ.document.folder import load
from situ.document.project import Project
from situ.rehearse import scenario
from situ.rehearse.coverage import Coverage
from situ.rehearse.recording import Recording, record
from situ.rehearse.why import chain, why_not
from situ.resources import example

SCRIPTS = {"conversation": "fig5.jsonl", "reception": "new-user.jsonl"}
QUESTIONS: dict[str, list[dict[str, Any]]] = {
    "conversation": [
        {"kind": "enter", "state": "6", "application": "converse"},
        {"kind": "situation", "to": "accepted"},
        {"kind": "authority", "resource": "head", "to": "nod"},
        {"kind": "mapping", "resource": "base", "module": "transfer"},
        {"kind": "resume"},
    ],
    "reception": [
        {"kind": "enter", "state": "16/gone"},
        {"kind": "transition", "from": "16", "to": "10"},
        {"kind": "action", "action": "service", "name": "regUsr"},
        {"kind": "event", "name": "done"},
    ],
}


def played(name: str) -> tuple[Project, list[dict[str, Any]]]:
    project, _ = load(example(name))
    assert project is not None
    names = [application.name for application in project.applications.values()]
    script = example(name) / "scenarios" / SCRIPTS[name]
    return project, record(project, scenario.load(script, names))[0].events


@pytest.fixture(scope="module", params=SCRIPTS)
def run(request: pytest.FixtureRequest) -> tuple[str, Project, list[dict[str, Any]]]:
    return (request.param, *played(request.param))


def counted(project: Project, events: list[dict[str, Any]]) -> dict[str, int]:
    coverage = Coverage(project)
    coverage.add(Recording.of(events))
    return {kind: found["covered"] for kind, found in coverage.document().items()}


def test_a_trace_that_was_cut_off_covers_no_more_than_the_whole(
    run: tuple[str, Project, list[dict[str, Any]]],
) -> None:
    _, project, events = run
    whole = counted(project, events)
    for cut in range(0, len(events), 9):
        for part in (events[:cut], events[cut:]):
            # Where it begins is taken for the start, so its conditions may be judged anew there.
            found = counted(project, part)
            assert found["states"] <= whole["states"]
            assert found["transitions"] <= whole["transitions"]
            assert found["situations"] <= whole["situations"]


def test_a_trace_that_was_cut_off_can_be_asked(
    run: tuple[str, Project, list[dict[str, Any]]],
) -> None:
    name, project, events = run
    for cut in range(1, len(events), 23):
        for part in (events[:cut], events[cut:]):
            for wanted in QUESTIONS[name]:
                answer = why_not(project, Recording.of(part), wanted, part[-1]["t"])
                assert answer.happened is not None or answer.reasons
        assert chain(events[cut:], events[-1]["seq"])[-1] == events[-1]


def test_the_trace_of_another_project_covers_nothing() -> None:
    project, _ = played("conversation")
    _, events = played("reception")
    found = counted(project, events)
    assert (found["states"], found["transitions"], found["situations"]) == (0, 0, 0)
