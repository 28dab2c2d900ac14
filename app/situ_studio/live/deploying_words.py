"""Versions of what a robot runs, in a designer's words."""

from __future__ import annotations

from datetime import datetime
from typing import TYPE_CHECKING

from situ_studio.live.deploying import Deploying
from situ_studio.wording.language import said, tr

if TYPE_CHECKING:
    from situ.blackboard.replies import Deployment, Turn
    from situ.decide.deployment import Waits


def standing(deploying: Deploying) -> str:
    """How it is with what was asked for last; nothing where nothing was."""
    number, why = deploying.number, said(deploying.why)
    stands = deploying.stands
    if stands == "idle":
        return ""
    if stands == "sending":
        return tr("Sending…")
    if stands == "failed":
        return tr("The robot did not take it: {0}").format(why)
    if stands == "elsewhere":
        runs = deploying.turns.version if deploying.turns is not None else "?"
        told = tr("Version {0} runs, not version {1}.").format(runs, number)
        return f"{told} {why}".strip()
    assert deploying.state is not None
    every = (_robot(deploying.state), _paused(deploying, deploying.state), why)
    return " ".join(filter(None, every))


def _paused(deploying: Deploying, state: Deployment) -> str:
    """What a safe point waits for in vain until somebody lets it go on."""
    names = dict.fromkeys(one.application for one in state.waits)
    paused = [name for name in names if deploying.is_paused(name)]
    if state.stands != "waiting" or not paused:
        return ""
    return tr("{0} is paused: let it go on.").format(", ".join(paused))


def _robot(state: Deployment) -> str:
    number = state.asked
    if state.stands == "checking":
        return tr("The robot checks version {0}.").format(number)
    if state.stands == "waiting":
        what = ", ".join(map(waited, state.waits)) or tr("a moment")
        told = tr("Checked. The robot waits for a safe point: {0}.").format(what)
        if state.forced is None:
            return told
        return f"{told} {tr('In {0} s at the latest it runs.').format(round(state.forced))}"
    if state.stands == "refused":
        told = tr("The robot refused version {0}; version {1} runs on.")
        return told.format(number, state.version)
    if state.stands == "returned":
        return tr("The robot has gone back to version {0} by itself:").format(state.version)
    told = tr("Version {0} runs.").format(state.version)
    if state.minute is not None and state.former is not None:
        trial = tr("For {0} s more the robot goes back to version {1} by itself if it fails.")
        told += " " + trial.format(round(state.minute), state.former)
    if state.restart:
        later = tr("Some of it counts when the robot is started again: {0}.")
        told += " " + later.format(", ".join(state.restart))
    return told


def waited(one: Waits) -> str:
    """An action that a version waits for."""
    name = "" if one.name is None else f" {one.name}"
    words = tr("{0} in state {1} of {2}")
    return words.format(f"{one.action}{name}", one.state, one.application)


def turn(one: Turn) -> tuple[str, str, str]:
    """When, what and who."""
    when = datetime.fromtimestamp(one.time).strftime("%Y-%m-%d %H:%M:%S")
    did = {
        "deployed": tr("Version {0} deployed"),
        "rolled back": tr("Rolled back to version {0}"),
        "returned": tr("Went back to version {0} by itself"),
        "refused": tr("Version {0} refused"),
        "given": tr("Version {0}: what lies in the robot's own folder"),
    }[one.did].format(one.version)
    why = f": {said(one.why)}" if one.why else ""
    return when, did + why, one.who.removeprefix("operator:")
