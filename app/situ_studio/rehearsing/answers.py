"""What a service may answer, to be seen by whoever answers in its place."""

from __future__ import annotations

import json

from situ.decide import inputs
from situ.document.analysis_data import actions
from situ.document.project import Project
from situ.document.rbd import Service
from situ.rehearse.ways import states
from situ_studio.rehearsing.course import Pending
from situ_studio.screens.samples import lines

USUAL = '{"names": []}'


def known(project: Project) -> dict[str, str]:
    """What services answer in the project's scenarios where they end well, by name, as JSON: of
    several answers the first."""
    found: dict[str, str] = {}
    for line in lines(project):
        does = line.does
        if isinstance(does, inputs.Finish) and does.name and does.ok and does.result is not None:
            found.setdefault(does.name, json.dumps(does.result, ensure_ascii=False))
    return found


def example(project: Project, pending: Pending) -> str:
    """An answer with the parts that the service of that name takes out of it, as JSON."""
    runs = {frame.file: frame.application for frame in states(project, pending.application)}
    services = (
        one
        for application in runs.values()
        for one in actions(application)
        if isinstance(one, Service) and one.name == pending.name
    )
    parts = {
        result.path.partition(".")[0]: 1
        for one in services
        for result in one.results
        if result.path
    }
    return json.dumps(parts, ensure_ascii=False) if parts else USUAL
