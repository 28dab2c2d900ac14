"""What is offered as an answer in place of a service."""

from __future__ import annotations

import json

from msgspec.structs import replace

from situ.document.project import Project
from situ.document.rbd import Application, Result, Service, State
from situ.document.ready import load_ready
from situ.resources import example as example_project
from situ_studio.rehearsing.answers import USUAL, example, known
from situ_studio.rehearsing.course import Pending


def test_an_answer_has_the_parts_that_the_service_takes_out_of_it() -> None:
    results = (Result("bp.high", "pressure.systolic"), Result("bp.pulse", "pulse"), Result("all"))
    asked = Service(name="measure", url="board:cuff/measure", results=results)
    other = Service(name="other", url="board:cuff/other", results=(Result("x", "x"),))
    deeper = Service(name="weigh", url="board:scales/weigh", results=(Result("kg", "weight"),))
    states = (State("1", actions=(other, asked)), State("2", flow="part"))
    project = Project(
        root=".",
        name="p",
        toml=None,
        applications={"a": Application("a", states=states)},
        parts={"part": Application("part", states=(State("1", actions=(deeper,)),))},
    )
    begun = Pending("a", "service", "measure", None, 0, None)
    assert json.loads(example(project, begun)) == {"pressure": 1, "pulse": 1}
    in_a_part = Pending("a", "service", "weigh", None, 0, None)
    assert json.loads(example(project, in_a_part)) == {"weight": 1}
    assert example(project, Pending("a", "service", "nobody's", None, 0, None)) == USUAL
    assert example(project, Pending("b", "service", "measure", None, 0, None)) == USUAL


def test_what_a_service_answers_in_the_scenarios_is_known_where_it_ends_well() -> None:
    project = load_ready(example_project("vitals"))
    answers = known(project)
    assert json.loads(answers["measurePressure"]).keys() == {"systolic", "diastolic", "pulse"}
    assert json.loads(answers["login"])["user"]["limits"]["systolic_high"] == 150
    assert known(replace(project, scenarios=None)) == {}
