"""formats.md, *Module information*: who needs whom."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from situ.decide.inputs import Acquire, Connected, Start
from situ.decide.robot import Robot

if TYPE_CHECKING:
    from tests.decide.conftest import Build, Play

MODULES = """<module name="chase" resources="head"><requires module="camera"/>
  <requires data="face.visible"/></module><module name="camera" resources=""/>
  <module name="app" resources="head"><requires module="camera"/></module>"""
SPDS = """<situation name="s"><module name="chase" priority="2"/><module name="app" priority="1"/>
</situation>"""


def acquire(at: float) -> dict[str, Any]:
    return {"at": at, "acquire": {"module": "chase", "resources": ["head"]}}


def test_a_module_that_asks_while_one_it_requires_is_absent_is_warned_of(play: Play) -> None:
    lines = [{"at": 1, "lost": {"module": "camera"}}, acquire(2)]
    assert play((), lines, spds=SPDS, modules=MODULES).lines(since=2) == [
        "2 acquire chase [head] <-",
        "2 warning chase needs camera, which is absent <acquire",
        "2 authority head - chase <acquire",
    ]


def test_the_simulator_counts_every_declared_module_as_present_until_lost(play: Play) -> None:
    lines = [acquire(1), {"at": 2, "lost": {"module": "camera"}}, {"at": 3, "end": True}]
    assert play((), lines, spds=SPDS, modules=MODULES).lines("warning") == []


def test_one_that_is_declared_nowhere_is_absent(play: Play) -> None:
    modules = MODULES.replace('module="camera"/>', 'module="other"/>', 1)
    trace = play((), [acquire(1)], spds=SPDS, modules=modules)
    assert trace.lines("warning") == ["1 warning chase needs other, which is absent <acquire"]


def test_an_application_is_warned_of_too_when_its_state_asks(play: Play) -> None:
    rbd = """<state no="1"><expectedevents><event name="go" next="2"/></expectedevents></state>
      <state no="2"><backgroundactions><robot resource="head" command="nod"/></backgroundactions>
      </state>"""
    lines = [{"at": 1, "lost": {"module": "camera"}}, {"at": 2, "event": "go"}]
    trace = play(rbd, lines, spds=SPDS, modules=MODULES)
    assert trace.lines("warning") == ["2 warning app needs camera, which is absent <acquire"]


def test_live_only_those_that_are_connected_are_present(build: Build) -> None:
    robot = Robot(build((), SPDS, MODULES.replace("app", "other")))
    robot.step(Start(everyone=False), 0)
    assert robot.modules() == {"camera": False, "chase": False, "other": False}
    events, _ = robot.step(Acquire("chase", ("head",)), 1)
    assert [type(event).__name__ for event in events] == ["Acquire", "Warned", "Authority"]
    robot.step(Connected("camera"), 2)
    assert robot.modules()["camera"] is True


def test_a_module_discloses_its_resources_when_it_connects(build: Build) -> None:
    robot = Robot(build((), '<situation name="s"/>'))
    robot.step(Start(everyone=False), 0)
    robot.step(Connected("new", ("head",)), 1)
    events, _ = robot.step(Acquire("new", ("head",)), 2)
    assert [type(event).__name__ for event in events] == ["Acquire"]
