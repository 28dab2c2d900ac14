"""docs/semantics.md, *Deploy*: when another version takes over, and when it goes back."""

from __future__ import annotations

from typing import Any

import pytest
from tests.decide.conftest import Trace

from situ.decide import inputs
from situ.decide.deployment import Deployment, Waits
from situ.decide.effects import AnyEffect, Refuse
from situ.decide.robot import Robot
from situ.decide.trace import to_fields
from situ.document import deployed
from situ.document.project import Project

ANN = "operator:ann"
SECOND = 1_000_000


def texts(
    rbd: str | list[str], spds: str = "", modules: str = "", toml: str = "", **more: str
) -> dict[str, str]:
    """Pieces of XML as the files of a project; states alone are the application ``app``."""
    flows = [rbd] if isinstance(rbd, str) else rbd
    names = [f"app{number}.rbd.xml" for number in range(len(flows))]
    project = f'[project]\nname = "test"\napplications = {names}\n'
    found = {name: _flow(text) for name, text in zip(names, flows, strict=True)}
    if spds:
        project += 'spds = "s.spds.xml"\n'
        found["s.spds.xml"] = f'<spds name="script">{spds}</spds>'
    if modules:
        project += 'modules = "modules.xml"\n'
        found["modules.xml"] = f"<modules>{modules}</modules>"
    parts = {f"{name}.rbd.xml": _flow(text, name) for name, text in more.items()}
    return {"situ.toml": project + toml, **found, **parts}


def _flow(text: str, name: str = "app") -> str:
    if text.startswith("<application"):
        return text
    return f'<application name="{name}">{text}</application>'


def project_of(files: dict[str, str]) -> Project:
    project, problems = deployed.read(files)
    assert project is not None
    assert [str(one) for one in problems if one.severity == "error"] == []
    return project


class Run:
    """A robot that has started with these files. trace: all of it; refused: what was."""

    def __init__(self, files: dict[str, str], **start: Any) -> None:
        self.files = files
        self.robot = Robot(project_of(files), files=files)
        self.trace = Trace()
        self.effects: list[AnyEffect] = []
        self.version = 0
        self._step(inputs.Start(**start), 0)

    @property
    def refused(self) -> list[str]:
        return [one.message for one in self.effects if isinstance(one, Refuse)]

    def at(self, seconds: float, *given: inputs.AnyInput) -> Run:
        """What falls due by then, then these, and what falls due then."""
        now = round(seconds * SECOND)
        for one in (*given, None):
            while (due := self.robot.due()) is not None and due <= now:
                self._step(None, due)
            if one is not None:
                self._step(one, now)
        return self

    def deploy(
        self,
        seconds: float,
        files: dict[str, str],
        force_after: float | None = None,
        returning: bool = False,
    ) -> Run:
        self.version += 1
        given = inputs.Deploy(self.version, files, ANN, force_after, returning)
        return self.at(seconds, given)

    def since(self, seconds: float, *but: str) -> list[str]:
        """What was traced from then on, but for that of the deploy itself."""
        return self.trace.lines(since=seconds, but=("deployed", *but))

    def versions(self) -> list[tuple[float, int]]:
        """When which version took over."""
        return [(one["t"], one["version"]) for one in self.trace.of("deployed")]

    def look(self, tag: str) -> Any:
        return self.robot.board.look(tag)

    def _step(self, given: inputs.AnyInput | None, now: int) -> None:
        events, effects = self.robot.step(given, now)
        self.trace += map(to_fields, events)
        self.effects += effects


def state(no: str, inside: str = "", events: str = "", actions: str = "") -> str:
    return (
        f'<state no="{no}">{inside}<backgroundactions>{actions}</backgroundactions>'
        f"<expectedevents>{events}</expectedevents></state>"
    )


def event(name: str, to: str) -> str:
    return f'<event name="{name}" next="{to}"/>'


HELLO = "<speech>Hello</speech>"
SAYS = texts(state("1", events=event("go", "2"), actions=HELLO) + state("2"))
OTHER = texts(state("1", events=event("go", "3"), actions=HELLO) + state("3"))


# -- when --------------------------------------------------------------------


def test_a_version_takes_over_at_once_where_no_action_runs() -> None:
    run = Run(texts(state("1", events=event("go", "2")) + state("2")))
    run.deploy(1, texts(state("1", events=event("go", "3")) + state("3"), toml="[tags]\n"))
    assert run.trace.lines("deployed") == ["1 deployed v1 [app0.rbd.xml situ.toml] operator:ann <-"]
    assert run.since(1) == []
    assert run.at(2, inputs.Raise("go")).trace.states() == [(0, "1"), (2, "3")]


def test_it_waits_while_an_action_runs_and_takes_over_at_its_end() -> None:
    run = Run(SAYS).deploy(1, OTHER)
    assert run.robot.deployment() == Deployment(
        version=0, pending=1, waits=(Waits("app", "1", "speech", None),)
    )
    run.at(2, inputs.Finish("speech"), inputs.Raise("go"))
    assert run.versions() == [(2, 1)]
    assert run.trace.states() == [(0, "1"), (2, "3")]


def test_at_the_end_of_an_action_its_event_comes_first() -> None:
    says = '<speech done="said">{}</speech>'
    two = state("1", events=event("said", "2"), actions=says.format("A")) + state(
        "2", actions=says.format("B")
    )
    run = Run(texts(two)).deploy(1, texts(two, toml="[tags]\nx = 1\n"))
    run.at(2, inputs.Finish("speech"))
    assert run.versions() == []
    assert run.robot.deployment().waits == (Waits("app", "2", "speech", None),)
    assert run.at(3, inputs.Finish("speech")).versions() == [(3, 1)]


@pytest.mark.parametrize(
    ("action", "told"),
    [
        ('<robot resource="base" command="goto"/>', ("robot", "goto")),
        ('<service name="find" url="http://x/" keep="true"/>', ("service", "find")),
        ('<launch program="game"/>', ("launch", "game")),
        ('<sound src="a.ogg"/>', ("sound", None)),
    ],
)
def test_it_waits_for_actions_of_every_kind(action: str, told: tuple[str, str | None]) -> None:
    files = texts(state("1", actions=action))
    run = Run(files).deploy(1, {**files, "robot.local.toml": ""})
    assert run.robot.deployment().waits == (Waits("app", "1", *told),)
    assert run.at(2, inputs.Finish()).versions() == [(2, 1)]


def test_a_movie_is_waited_for_too() -> None:
    movie = '<movie id="m" x="1" y="1" width="9" height="9" src="a.webm"/>'
    files = texts(state("1", f"<screen><components>{movie}</components></screen>"))
    run = Run(files).deploy(1, {**files, "robot.local.toml": ""})
    assert run.robot.deployment().waits == (Waits("app", "1", "movie", "m"),)
    assert run.at(2, inputs.Finish()).versions() == [(2, 1)]


def test_it_is_forced_after_the_time_that_the_operator_gives() -> None:
    run = Run(SAYS).deploy(1, OTHER, force_after=2.5)
    assert run.robot.deployment().forced == 3_500_000
    assert run.at(9).versions() == [(3.5, 1)]


@pytest.mark.parametrize("force_after", [0, -1])
def test_it_is_forced_at_once_after_no_time(force_after: float) -> None:
    assert Run(SAYS).deploy(1, OTHER, force_after).versions() == [(1, 1)]


def test_the_time_is_over_when_it_has_taken_over() -> None:
    run = Run(SAYS).deploy(1, OTHER, force_after=5).at(2, inputs.Finish("speech"))
    assert run.at(20).versions() == [(2, 1)]


def test_another_version_takes_the_place_of_one_that_waits() -> None:
    run = Run(SAYS).deploy(1, OTHER, force_after=1).deploy(1.5, SAYS, force_after=3)
    assert run.robot.deployment().pending == 2
    assert run.at(9).versions() == [(4.5, 2)]


def test_what_waits_outlives_a_snapshot_and_so_does_the_version_that_runs() -> None:
    run = Run(SAYS).deploy(1, OTHER, force_after=4)
    run.robot, before = Robot(project_of(SAYS), files=SAYS), run.robot
    run.robot.restore(before.snapshot())
    assert run.robot.deployment() == before.deployment()
    assert run.at(6).versions() == [(5, 1)]
    run.robot, before = Robot(project_of(SAYS), files=SAYS), run.robot
    run.robot.restore(before.snapshot())
    assert (run.robot.version, run.robot.project) == (1, project_of(OTHER))
    assert run.robot.snapshot() == before.snapshot()
    assert run.at(7, inputs.Raise("go")).trace.states() == [(0, "1"), (7, "3")]


def test_a_snapshot_whose_version_can_not_be_read_is_refused() -> None:
    run = Run(SAYS).deploy(1, dict(OTHER), force_after=0)
    run.robot._deploying.state.running.files["app0.rbd.xml"] = "<"
    with pytest.raises(ValueError, match="version 1 can not run"):
        Robot(project_of(SAYS)).restore(run.robot.snapshot())


def test_a_livelock_does_not_keep_a_version_from_taking_over() -> None:
    loop = state("2", events='<event next="#again"/>')
    run = Run(texts(state("1", events=event("go", "2"), actions=HELLO) + loop))
    run.deploy(1, texts(state("1", events=event("go", "2")) + loop)).at(2, inputs.Raise("go"))
    assert run.versions() == [(2, 1)]


# -- what is refused ---------------------------------------------------------


def test_a_version_with_errors_is_refused_and_the_old_one_runs_on() -> None:
    wrong = texts(state("1", '<timeout next="7">3</timeout>') + state("1"))
    run = Run(SAYS).deploy(1, wrong).at(2, inputs.Finish("speech"), inputs.Raise("go"))
    (said,) = run.refused
    assert said.startswith("version 1 can not run: app0.rbd.xml:1:")
    assert said.endswith(" more)")
    assert "\n" not in said
    assert run.trace.one("error")["message"] == said
    assert run.versions() == []
    assert run.trace.states() == [(0, "1"), (2, "2")]


def test_one_that_is_no_project_is_refused() -> None:
    assert "There are no files" in Run(SAYS).deploy(1, {}).refused[0]


def test_what_was_read_before_is_not_read_again() -> None:
    run = Run(SAYS)
    run.robot.prepare(1, project_of(OTHER))
    run.deploy(1, {"not": "read"}, force_after=0).at(2, inputs.Raise("go"))
    assert run.trace.states() == [(0, "1"), (2, "3")]


# -- the first minute --------------------------------------------------------

CALM = texts(state("1", events=event("go", "2")) + state("2"))
LOOPS = texts(state("1", events=event("go", "2")) + state("2", events='<event next="#again"/>'))


def test_a_version_that_fails_in_its_first_minute_is_gone_back_from() -> None:
    run = Run(CALM).deploy(1, LOOPS)
    assert run.robot.deployment() == Deployment(version=1, former=0, until=61_000_000)
    run.at(60.9, inputs.Raise("go"))
    first, why = run.trace.of("error")
    assert why["message"] == f"version 1 failed: {first['message']}; back to 0"
    assert (why["cause"], why["where"]) == (first["seq"], "deploy")
    last = run.trace.of("deployed")[-1]
    assert (last["version"], last["files"]) == (0, ["app0.rbd.xml"])
    assert (last["writer"], last["cause"]) == ("situ", why["seq"])
    assert run.robot.deployment() == Deployment(version=0)
    assert run.robot.project == project_of(CALM)


def test_after_that_it_stays() -> None:
    run = Run(CALM).deploy(1, LOOPS)
    assert run.at(61).robot.deployment().former == 0
    run.at(61, inputs.Touch())
    assert run.robot.deployment() == Deployment(version=1)
    run.at(61, inputs.Raise("go"))
    assert run.versions() == [(1, 1)]


def test_what_fails_in_the_step_of_its_coming_is_gone_back_from_there() -> None:
    run = Run(CALM).at(1, inputs.Raise("go")).deploy(2, LOOPS)
    assert run.versions() == [(2, 1), (2, 0)]
    assert run.trace.states()[-1] == (2, "2")


def test_an_action_that_may_not_do_what_it_does_is_a_failure() -> None:
    bad = '<event name="go" next="2"><set tag="situation">1</set></event>'
    project, _ = deployed.read(texts(state("1", events=bad) + state("2")))
    assert project is not None
    run = Run(CALM)
    run.robot.prepare(1, project)
    run.deploy(1, {"v": "1"}).at(2, inputs.Raise("go"))
    assert run.versions() == [(1, 1), (2, 0)]


def test_what_is_refused_to_others_is_no_failure() -> None:
    run = Run(CALM).deploy(1, LOOPS)
    run.at(2, inputs.Set({"robot/head": 1}, ANN), inputs.Acquire("nobody", ("head",)))
    assert len(run.refused) == 2
    assert run.versions() == [(1, 1)]


def test_where_no_file_changed_there_is_nothing_to_go_back_to() -> None:
    run = Run(LOOPS).deploy(1, LOOPS)
    assert run.trace.one("deployed")["files"] == []
    assert run.robot.deployment() == Deployment(version=1)
    run = Run(CALM).deploy(1, LOOPS).deploy(2, LOOPS)
    assert run.robot.deployment() == Deployment(version=2, former=0, until=61_000_000)


def test_a_return_is_at_once_and_is_not_returned_from() -> None:
    run = Run(SAYS).deploy(1, OTHER, force_after=0).deploy(2, SAYS, returning=True)
    assert run.versions() == [(1, 1), (2, 2)]
    assert run.robot.deployment() == Deployment(version=2)


def test_a_version_that_waits_goes_on_waiting_over_a_return() -> None:
    says = texts(state("1", events=event("go", "2"), actions=HELLO) + state("2"))
    loops = texts(
        state("1", events=event("go", "2"), actions=HELLO)
        + state("2", events='<event next="#again"/>', actions=HELLO)
    )
    run = Run(says).deploy(1, loops, force_after=0).deploy(2, OTHER)
    run.at(3, inputs.Raise("go"))
    assert run.versions() == [(1, 1), (3, 0), (3, 2)]


def test_what_waits_takes_over_where_a_return_ends_the_last_action() -> None:
    leaves = '<event next="2"><when><data tag="x" is="1"/></when></event>'
    old = texts(state("1", events=leaves, actions=HELLO) + state("2"))
    again = '<event name="go"><message topic="t" done="go">1</message></event>'
    loops = texts(state("1", events=again, actions=HELLO))
    run = Run(old).deploy(1, loops, force_after=0).deploy(2, SAYS)
    run.at(3, inputs.Set({"x": 1}, "m")).at(4, inputs.Raise("go"))
    assert run.versions() == [(1, 1), (4, 0), (4, 2)]


def test_the_former_version_is_returned_to_from_a_snapshot() -> None:
    run = Run(CALM).deploy(1, LOOPS)
    run.robot, before = Robot(project_of(LOOPS), 1, LOOPS), run.robot
    run.robot.restore(before.snapshot())
    run.at(2, inputs.Raise("go"))
    assert run.versions() == [(1, 1), (2, 0)]
    assert run.robot.project == project_of(CALM)


def test_what_begins_at_the_moment_at_which_a_version_may_take_over_is_waited_for() -> None:
    says = state("1", events=event("go", "2"), actions=HELLO) + state("2", actions=HELLO)
    run = Run(texts(says)).deploy(1, texts(says + state("3")))
    # Nobody let the version take over between these two.
    run._step(inputs.Finish("speech"), 2 * SECOND)
    run._step(inputs.Raise("go"), 2 * SECOND)
    assert run.at(2).versions() == []
    assert run.at(3, inputs.Finish("speech")).versions() == [(3, 1)]
