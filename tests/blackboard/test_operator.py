"""An operator speaks as the module ``operator``, which has what the script gives it."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from situ.document.project import Project
from situ.document.ready import load_ready

LAB = Path(__file__).parent / "lab"
Hand = Any
ACQUIRE = {"do": "acquire", "module": "operator", "resources": ["speech"]}
COMMAND = {"do": "command", "module": "operator", "resource": "speech", "value": {"text": "Hm"}}


@pytest.fixture(scope="module")
def stage(tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The lab, whose script lets operators speak."""
    folder = shutil.copytree(LAB, tmp_path_factory.mktemp("stage") / "lab")
    script = folder / "lab.spds.xml"
    text = script.read_text()
    text = text.replace("</modules>", '<module name="operator" resources="speech"/></modules>')
    calm = '<situation name="calm">'
    script.write_text(text.replace(calm, calm + '<module name="operator" priority="60"/>'))
    return load_ready(folder)


@pytest.fixture
def hand(stage: Project, make_hand: Callable[..., Hand]) -> Hand:
    made: Hand = make_hand(stage)
    for name in ("ann", "bob"):
        made.hello(name, role="operator", user=name)
    return made


def said(hand: Hand) -> Any:
    return hand.core.board.look("robot/speech")


def test_an_operator_asks_for_the_voice_and_commands_it(hand: Hand) -> None:
    assert hand.ask("ann", **ACQUIRE)["holds"] == ["speech"]
    assert hand.ask("ann", **COMMAND)["re"] == "done"
    assert said(hand) == {"text": "Hm"}
    assert hand.core.board.state["robot/speech"].writer == "operator"
    hand.ask("ann", "abandon", module="operator")
    assert said(hand) is None


def test_once_he_has_asked_for_authority_he_is_believed_no_longer_than_a_module(
    hand: Hand,
) -> None:
    # Nobody knew of a lease that ends so early.
    hand.at(5.0).ask("ann", **ACQUIRE)
    hand.ask("ann", **COMMAND)
    assert said(hand.at(5.9)) == {"text": "Hm"}
    assert said(hand.at(6.0)) is None
    # Who only looks on is still there.
    assert hand.ask("bob", "heartbeat")["re"] == "alive"


def test_he_speaks_for_no_other_module(hand: Hand) -> None:
    for module in ({"module": "nod"}, {}):
        refused = hand.ask("ann", "acquire", resources=["head"], **module)
        assert (refused["re"], refused["code"]) == ("refused", "role")
    hand.hello("nod", resources=["head"])
    assert hand.ask("nod", **ACQUIRE)["code"] == "role"
    hand.hello("tablet", role="viewer")
    assert hand.ask("tablet", **ACQUIRE)["code"] == "role"


def test_where_the_script_does_not_know_the_module_he_is_told_what_to_do(
    make_hand: Callable[..., Hand],
) -> None:
    hand = make_hand()
    hand.hello("ann", role="operator", user="ann")
    refused = hand.ask("ann", **ACQUIRE)
    assert refused["code"] == "refused"
    assert "ask the task designer for a priority in the script" in refused["message"]


def test_the_voice_goes_back_when_the_last_who_speaks_has_gone(hand: Hand) -> None:
    hand.hello("eve", role="operator", user="eve")
    for name in ("ann", "bob"):
        hand.ask(name, **ACQUIRE)
    hand.ask("ann", **COMMAND)
    hand.ask("ann", "bye")
    assert said(hand) == {"text": "Hm"}
    # Eve only looks on.
    hand.ask("bob", "bye")
    assert said(hand) is None
    assert hand.core.holders["speech"] is None


@pytest.mark.parametrize("snapshot", ["before", "after"])
def test_after_a_kill_it_still_goes_back_with_him(
    snapshot: str, hand: Hand, stage: Project, make_hand: Callable[..., Hand]
) -> None:
    kept = hand.robot.snapshot(), hand.sessions.state()
    past, take = [], hand.sessions.take

    def follow() -> Any:
        out = take()
        past.extend(out.past)
        return out

    hand.sessions.take = follow
    hand.core.remembers = True
    hand.ask("ann", **ACQUIRE)
    hand.ask("ann", **COMMAND)
    if snapshot == "after":
        kept, past = (hand.robot.snapshot(), hand.sessions.state()), []
    after = make_hand(stage, begin=False)
    after.robot.restore(kept[0])
    after.sessions.restore(kept[1], past, 0)
    assert said(after) == {"text": "Hm"}
    assert said(after.at(1.5)) is None


def test_a_module_of_that_name_speaks_for_itself(hand: Hand) -> None:
    hand.hello("operator", resources=["speech"])
    refused = hand.ask("ann", **ACQUIRE)
    assert refused["code"] == "name"
    assert hand.ask("operator", "acquire", resources=["speech"])["holds"] == ["speech"]
