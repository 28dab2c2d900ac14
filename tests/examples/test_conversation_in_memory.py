"""The modules of the conversation in ``situ.testing``: seed 000, Fig. 5, to its end."""

from __future__ import annotations

import runpy
from collections.abc import Iterator
from pathlib import Path

import pytest

import situ.testing

CONVERSATION = Path(__file__).resolve().parents[2] / "examples" / "conversation"
MODULES = {
    "chase-face": ["head"],
    "nod": ["head"],
    "gaze-sound": ["head"],
    "face-caller": ["head"],
    "transfer": ["base", "head"],
}


@pytest.fixture
def robot() -> Iterator[situ.testing.Robot]:
    with situ.testing.robot(CONVERSATION) as made:
        for module, resources in MODULES.items():
            name = module.replace("-", "_")
            program = runpy.run_path(str(CONVERSATION / "modules" / f"{name}.py"))[name]
            made.start(program, made.connect(module=module, resources=resources))
        yield made


def test_attention_goes_from_module_to_module_and_back(robot: situ.testing.Robot) -> None:
    robot.set({"face.visible": True, "face.direction": 12})
    assert robot.command("head") == {"yaw": 12, "pitch": 0}
    # (B) a nod, and the face again
    robot.set("speech.acceptable", True)
    nods = []
    for _ in range(4):
        nods.append((robot.holder("head"), robot.command("head")))
        robot.pass_time(0.25)
    assert nods == [("nod", {"pitch": pitch}) for pitch in (-12, 0, -12, 0)]
    assert robot.holder("head") == "chase-face"
    robot.pass_time(0.3)
    assert robot.situation == "conversation"
    # (C) a slap
    robot.set("sound.slap", 40)
    assert robot.command("head") == {"yaw": 40, "pitch": 0}
    robot.pass_time(1.6)
    assert robot.command("head") == {"yaw": 12, "pitch": 0}
    # (D) somebody calls, (E) and waves: in that very step the robot breaks off and goes there
    robot.set({"person.calling": True, "person.direction": -45})
    assert robot.command("head") == {"yaw": -45, "pitch": 0}
    robot.set("hand.waving", True)
    assert (robot.holder("base"), robot.holder("head")) == ("transfer", "transfer")
    assert robot.command("base") == {"turn": -45.0}
    begun = robot.now
    robot.until(lambda: robot.value("transfer.phase") == "moving", within=5.0)
    assert robot.now - begun == pytest.approx(1.0)
    assert robot.command("base") == {"vx": 0.4}
    robot.until(lambda: robot.value("transfer.phase") == "arrived", within=10.0)
    assert robot.now - begun == pytest.approx(5.0)
    assert robot.command("base") is None
    robot.pass_time(6.0)
    assert (robot.situation, robot.holder("head")) == ("conversation", "chase-face")


def test_the_stop_button_takes_everything_from_everybody(robot: situ.testing.Robot) -> None:
    robot.set({"face.visible": True, "face.direction": 12})
    robot.set({"person.calling": True, "person.direction": 90, "hand.waving": True})
    robot.pass_time(0.5)
    robot.set("robot.stop", True)
    assert [robot.command(resource) for resource in ("base", "head")] == [None, None]
    robot.pass_time(10.0)
    assert robot.value("transfer.phase") == "failed"
    robot.set("robot.stop", False)
    robot.pass_time(1.0)
    assert (robot.command("base"), robot.command("head")) == (None, {"yaw": 12, "pitch": 0})


def test_a_module_that_is_lost_leaves_the_face_to_the_next(robot: situ.testing.Robot) -> None:
    robot.set({"face.visible": True, "face.direction": 12})
    robot.lose("chase-face")
    assert robot.command("head") is None
    robot.regain("chase-face")
    robot.pass_time(0.3)
    assert robot.command("head") == {"yaw": 12, "pitch": 0}
