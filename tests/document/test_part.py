"""*Make a part*: the project does the same with some of its states in a part of their own.

formats.md, *Parts*; laws over generated applications, and the cases by themselves.
"""

from __future__ import annotations

import json
import random
from typing import Any

import pytest
from hypothesis import HealthCheck, given, reject, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.decide.trace import to_fields
from situ.document import codec
from situ.document.check import check
from situ.document.dissolve import dissolve
from situ.document.flatten import flatten
from situ.document.part import NoPart, make_part, part_file_of
from situ.document.project import Project
from situ.document.rbd import Application
from situ.errors import UsageError
from situ.rehearse import scenario
from situ.rehearse.simulate import simulate

FILE, PART = "app.rbd.xml", "inner.rbd.xml"
AT = 'x="1" y="1" width="9" height="9"'


def project(text: str, **parts: str) -> Project:
    def read(name: str, states: str) -> Application:
        whole = f'<application name="{name}">{states}</application>'
        document, problems = codec.read(whole.encode(), name)
        assert not problems, problems
        assert isinstance(document, Application)
        return document

    return Project(
        root=".",
        name="test",
        applications={FILE: read("app", text)},
        parts={f"{name}.rbd.xml": read(name, states) for name, states in parts.items()},
    )


def errors(made: Project) -> list[str]:
    return [str(one) for one in check(made) if one.severity == "error"]


def told(made: Project, lines: list[dict[str, Any]]) -> list[Any]:
    """What the robot does, shows and sends, with the times."""
    found: list[Any] = []

    def tell(events: list[Any]) -> None:
        for event in events:
            fields = to_fields(event)
            if fields["kind"] == "error":
                # A livelock: how far it gets is no matter here.
                reject()
            if fields["kind"] in ("action", "finished", "cancelled", "mapping", "data"):
                drop = ("seq", "cause", "state", "version")
                found.append({key: v for key, v in fields.items() if key not in drop})

    text = "\n".join(json.dumps(line) for line in lines)
    simulate(made, scenario.parse(text.encode(), "s", ["app"]), tell=tell)
    return found


# -- generated applications ------------------------------------------------------


class Maker:
    """An application without parts, and its scenario, drawn from ``rng``.

    Its actions raise no event: two that wait at one moment are what a part does not keep.
    """

    def __init__(self, rng: random.Random) -> None:
        self.rng = rng
        self.count = rng.randrange(3, 7)
        self.ids = 0

    def target(self) -> str:
        special = ["#again", "#back"] if self.rng.random() < 0.3 else []
        return self.rng.choice([*map(str, range(1, self.count + 1)), *special])

    def quick(self) -> str:
        self.ids += 1
        return self.rng.choice(
            (
                f'<set tag="t">{self.rng.randrange(3)}</set>',
                '<add tag="n">1</add>',
                f'<service name="s{self.ids}" url="http://x/"/>',
                f'<launch program="g{self.ids}"/>',
            )
        )

    def event(self) -> str:
        name = f' name="{self.rng.choice("abc")}"' if self.rng.random() < 0.85 else ""
        inside = ""
        if not name or self.rng.random() < 0.3:
            held = self.rng.choice(("", ' for="0.5"', ' within="2"'))
            inside = f'<when><data tag="t" is="{self.rng.randrange(3)}"{held}/></when>'
        if self.rng.random() < 0.3:
            inside += self.quick()
        to = f' next="{self.target()}"' if not name or self.rng.random() < 0.85 else ""
        return f"<event{name}{to}>{inside}</event>"

    def common(self, most: int) -> tuple[str, str, str]:
        self.ids += 1
        timeout = screen = ""
        if self.rng.random() < 0.4:
            to = f' next="{self.target()}"' if self.rng.random() < 0.8 else ""
            timeout = f"<timeout{to}>{self.rng.choice((0.7, 1.3, 4))}</timeout>"
        if self.rng.random() < 0.4:
            inner = f'<components><text id="i{self.ids}" {AT}>{{t}}</text></components>'
            screen = f"<screen>{inner}</screen>" if self.rng.random() < 0.8 else "<screen/>"
        events = "".join(self.event() for _ in range(self.rng.randrange(most + 1)))
        return timeout, screen, f"<expectedevents>{events}</expectedevents>" if events else ""

    def state(self, no: int) -> str:
        timeout, screen, events = self.common(3)
        actions = f"<speech>say {no}</speech>" if self.rng.random() < 0.5 else ""
        if self.rng.random() < 0.4:
            actions += f'<robot resource="base" command="c{no}"/>'
        if self.rng.random() < 0.3:
            actions += self.quick()
        actions = f"<backgroundactions>{actions}</backgroundactions>" if actions else ""
        left_out = ' always="false"' if self.rng.random() < 0.1 else ""
        return f'<state no="{no}"{left_out}>{timeout}{screen}{actions}{events}</state>'

    def project(self) -> Project:
        always = ""
        if self.rng.random() < 0.4:
            always = f"<always>{''.join(self.common(2))}</always>"
        states = "".join(self.state(no) for no in range(1, self.count + 1))
        return project(always + states)

    def chosen(self) -> list[str]:
        numbers = [str(no) for no in range(1, self.count + 1)]
        return self.rng.sample(numbers, self.rng.randrange(1, self.count))

    def lines(self) -> list[dict[str, Any]]:
        found: list[dict[str, Any]] = []
        at = 0.0
        for _ in range(25):
            at = round(at + self.rng.choice((0.1, 0.5, 0.9)), 2)
            verb: dict[str, Any] = {"event": self.rng.choice("abc")}
            if self.rng.random() < 0.3:
                verb = {"set": {"t": self.rng.randrange(3)}}
            found.append({"at": at, **verb})
        return [*found, {"at": at + 5, "end": True}]


LAW = settings(
    max_examples=30,
    deadline=None,
    suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow],
)


@LAW
@given(st.integers(0, 2**32))
def test_with_a_part_the_same_actions_come_at_the_same_times(seed: int) -> None:
    maker = Maker(random.Random(seed))
    made, lines = maker.project(), maker.lines()
    try:
        parted = make_part(made, FILE, maker.chosen(), "inner", PART)
    except NoPart:
        reject()
    assert errors(parted) == []
    assert told(parted, lines) == told(made, lines)


@settings(LAW, max_examples=8)
@given(st.integers(0, 2**32))
def test_what_was_made_a_part_is_exported_flat(seed: int) -> None:
    maker = Maker(random.Random(seed))
    made, lines = maker.project(), maker.lines()
    try:
        parted = make_part(made, FILE, maker.chosen(), "inner", PART)
        flat = flatten(parted)
    except (NoPart, UsageError):
        reject()
    kinds = ("action", "cancelled")
    ours = [one for one in told(made, lines) if one["kind"] in kinds and one["action"] != "clear"]
    theirs = [one for one in told(flat, lines) if one["kind"] in kinds and one["action"] != "clear"]
    assert theirs == ours


# -- the cases by themselves ---------------------------------------------------------


def state(no: str, inside: str = "", extra: str = "") -> str:
    return f'<state no="{no}" name="n{no}"{extra}>{inside}</state>'


def ways(*to: str) -> str:
    """Events a, b, c … that lead there."""
    every = "".join(
        f'<event name="{name}" next="{no}"/>' for name, no in zip("abc", to, strict=False)
    )
    return f"<expectedevents>{every}</expectedevents>"


def parted(made: Project, *numbers: str) -> tuple[Application, Application]:
    after = make_part(made, FILE, numbers, "inner", PART)
    assert errors(after) == []
    return after.applications[FILE], after.parts[PART]


CHAIN = state("1", ways("2")) + state("2", ways("3")) + state("3", ways("4", "1")) + state("4")


def test_the_state_that_runs_it_has_the_number_of_the_first() -> None:
    application, part = parted(project(CHAIN), "3", "2")
    assert [s.no for s in application.states] == ["1", "2", "4"]
    holder = application.states[1]
    assert (holder.name, holder.flow) == ("inner", PART)
    assert part.name == "inner"
    assert part.start_no == "2"


def test_a_way_out_leads_to_an_end_with_the_number_of_its_target() -> None:
    application, part = parted(project(CHAIN), "2", "3")
    assert [s.no for s in part.states] == ["2", "3", "4", "1"]
    assert [s.name for s in part.states[2:]] == ["n4", "n1"]
    assert all(s.final and s.is_end for s in part.states[2:])
    said = [(e.name, e.next) for e in application.states[1].events]
    assert said == [("done.4", "4"), ("done.1", "1")]


def test_what_is_done_on_a_way_out_is_done_after_the_part_was_left() -> None:
    inside = (
        '<expectedevents><event name="a" next="3"><service name="s" url="http://x/"/></event>'
        '<event name="b" next="3"/></expectedevents>'
    )
    made = project(state("1", ways("2")) + state("2", inside) + state("3"))
    application, part = parted(made, "2")
    assert [s.no for s in part.states] == ["2", "3", "3-2"]
    done = application.states[1].events
    assert [(e.name, e.next, len(e.actions)) for e in done] == [
        ("done.3", "3", 1),
        ("done.3-2", "3", 0),
    ]
    lines: list[dict[str, Any]] = [
        {"at": 1, "event": "a"},
        {"at": 2, "event": "a"},
        {"at": 3, "end": True},
    ]
    after = make_part(made, FILE, ["2"], "inner", PART)
    assert [one["name"] for one in told(after, lines)] == ["s"]


def test_states_that_leave_out_what_every_state_has_leave_it_out_as_a_part() -> None:
    left_out = ' always="false"'
    always = "<always><timeout>5</timeout></always>"
    made = project(
        always + state("1", ways("2")) + state("2", ways("3"), left_out) + state("3", ways("1"))
    )
    application, part = parted(made, "2")
    assert not application.states[1].always
    assert all(s.always for s in part.states)


def test_an_end_among_them_ends_the_part_and_what_runs_it_is_meant_as_an_end() -> None:
    final = ' final="true"'
    application, part = parted(
        project(state("1", ways("2")) + state("2", ways("3")) + state("3", "", final)), "2", "3"
    )
    assert part.states[1].final
    assert application.states[1].final
    assert application.states[1].events == ()


def test_a_part_is_made_inside_of_a_part() -> None:
    outer = state("1", "<flow src='sub.rbd.xml'/>")
    made = project(outer, sub=state("1", ways("2")) + state("2", ways("3")) + state("3"))
    after = make_part(made, "sub.rbd.xml", ["2"], "deep", "deep.rbd.xml")
    assert errors(after) == []
    assert list(after.parts) == ["sub.rbd.xml", "deep.rbd.xml"]
    assert list(after.applications) == [FILE]


def test_cards_keep_their_places_and_the_ends_stand_at_the_right() -> None:
    at = ' xmlns:ed="urn:situ:editor" ed:x="{}" ed:y="{}"'
    made = project(
        state("1", ways("2"), at.format(0, 0))
        + state("2", ways("3"), at.format(230, 0))
        + state("3", "", at.format(460, 0))
    )
    application, part = parted(made, "2")
    assert [s.aside.position for s in application.states] == [(0, 0), (230, 0), (460, 0)]
    assert [s.aside.position for s in part.states] == [(230, 0), (460, 0)]


ALWAYS_AGAIN = '<always><expectedevents><event name="z" next="#again"/></expectedevents></always>'
REFUSED = [
    (CHAIN, [], "Select the states"),
    (state("1", ways("2")) + state("2") + state("2"), ["2"], "Two of these states have one number"),
    (CHAIN, ["2", "4"], "lead to state 2 n2 and state 4 n4: select more or fewer"),
    (state("1", ways("2")) + state("2", ways("#back")), ["2"], "lead it to a state first"),
    (ALWAYS_AGAIN + CHAIN, ["2", "3"], "What every state has leads to the state anew"),
    (
        state("1", ways("2"))
        + state("2", ways("3"))
        + state("3", ways("4"))
        + state("4", ways("#back", "1")),
        ["2", "3"],
        "State 4 n4 leads back to the state before",
    ),
    (
        state("1", ways("2"), ' always="false"') + state("2", ways("3")) + state("3"),
        ["1", "2"],
        "State 1 n1 leaves out what every state has",
    ),
    (
        state("1", ways("2"))
        + state("2", "<backgroundactions><speech>{application/app}</speech></backgroundactions>"),
        ["2"],
        "What application/app says is used",
    ),
]


@pytest.mark.parametrize(("text", "numbers", "why"), REFUSED)
def test_what_can_not_be_taken_out_alone_is_refused_with_how_to_mend_it(
    text: str, numbers: list[str], why: str
) -> None:
    with pytest.raises(NoPart) as refused:
        make_part(project(text), FILE, numbers, "inner", PART)
    assert why in str(refused.value)
    assert "\n" not in str(refused.value)


def test_an_end_for_which_another_application_waits_is_left_out() -> None:
    outer = state("1", "<flow src='sub.rbd.xml'/>")
    made = project(outer, sub=state("1", ways("2")) + state("2"))
    with pytest.raises(NoPart, match="is an end of sub, for which app waits"):
        make_part(made, "sub.rbd.xml", ["2"], "deep", "deep.rbd.xml")


def test_an_end_that_every_state_expects_is_left_out() -> None:
    always = '<always><expectedevents><event name="done" next="1"/></expectedevents></always>'
    made = project(always + state("1", ways("2")) + state("2"))
    with pytest.raises(NoPart, match=r"Every state expects done"):
        make_part(made, FILE, ["2"], "inner", PART)


def test_a_parts_file_stands_beside_the_applications_under_a_free_name() -> None:
    assert part_file_of("app.rbd.xml", "Vital signs", []) == "vital-signs.rbd.xml"
    assert part_file_of("a/app.rbd.xml", "x", ["a/x.rbd.xml"]) == "a/x-2.rbd.xml"
    assert part_file_of("app.rbd.xml", "!", []) == "part.rbd.xml"
    assert part_file_of("app.rbd.xml", "受付", []) == "受付.rbd.xml"


# -- and back ------------------------------------------------------------------------


@settings(LAW, max_examples=20)
@given(st.integers(0, 2**32))
def test_a_part_dissolved_is_what_it_was_made_of(seed: int) -> None:
    maker = Maker(random.Random(seed))
    made = maker.project()
    try:
        parted = make_part(made, FILE, maker.chosen(), "inner", PART)
    except NoPart:
        reject()
    (no,) = (s.no for s in parted.applications[FILE].states if s.flow is not None)
    after = dissolve(parted, FILE, no).applications[FILE]
    before = made.applications[FILE]
    assert {s.no: s for s in after.states} == {s.no: s for s in before.states}
    assert (after.start_no, after.always) == (before.start_no, before.always)


DONE = '<event name="done" next="3"/>'
EXPECTS = f"<expectedevents>{DONE}</expectedevents>"


def held(events: str = DONE) -> str:
    """State 2, which runs the part ``sub``, and state 3."""
    inside = f'<flow src="sub.rbd.xml"/><expectedevents>{events}</expectedevents>'
    return state("1", ways("2")) + state("2", inside) + state("3", ways("1"))


SUB = state("1", ways("2", "9")) + state("2", ways("9")) + state("9")


def test_an_application_begins_where_the_part_did() -> None:
    inner = state("1", ways("9")) + state("2", ways("1")) + state("9")
    made = project(state("2", f'<flow src="sub.rbd.xml"/>{EXPECTS}') + state("3"), sub=inner)
    sub = replace(made.parts["sub.rbd.xml"], start="2")
    after = dissolve(replace(made, parts={"sub.rbd.xml": sub}), FILE, "2").applications[FILE]
    assert ([s.no for s in after.states], after.start_no) == (["1", "2", "3"], "2")


def test_an_end_that_would_end_the_part_around_is_refused() -> None:
    holder = state("1", '<flow src="deep.rbd.xml"/>')
    made = project(
        state("1", '<flow src="sub.rbd.xml"/>'), sub=holder, deep=state("1", ways("5")) + state("5")
    )
    with pytest.raises(NoPart, match="State 5 n5 would be an end for which app waits"):
        dissolve(made, "sub.rbd.xml", "1")


def test_cards_lie_as_they_did_in_the_part_from_where_its_card_was() -> None:
    at = ' xmlns:ed="urn:situ:editor" ed:x="{}" ed:y="{}"'.format
    inner = state("1", ways("2"), at(10, 10)) + state("2", ways("9"), at(30, 50)) + state("9")
    holder = state("1", f'<flow src="sub.rbd.xml"/>{EXPECTS}', at(500, 600)) + state("3")
    after = dissolve(project(holder, sub=inner), FILE, "1").applications[FILE]
    assert [s.aside.position for s in after.states] == [(500, 600), (520, 640), None]


def test_numbers_that_are_taken_change_and_ways_follow() -> None:
    made = project(held(), sub=SUB)
    after = dissolve(made, FILE, "2")
    application = after.applications[FILE]
    assert [s.no for s in application.states] == ["1", "2", "2-2", "3"]
    assert [[e.next for e in s.events] for s in application.states] == [
        ["2"],
        ["2-2", "3"],
        ["3"],
        ["1"],
    ]
    assert errors(after) == []
    lines = [{"at": at, "event": "ab"[at % 2]} for at in range(1, 9)]
    assert told(after, [*lines, {"at": 9, "end": True}]) == told(
        made, [*lines, {"at": 9, "end": True}]
    )


def test_what_the_state_around_expects_every_state_expects_then() -> None:
    more = f'{DONE}<event name="z" next="1"/>'
    after = dissolve(project(held(more), sub=SUB), FILE, "2")
    inner = after.applications[FILE].states[1:3]
    assert [s.events[-1].name for s in inner] == ["z", "z"]


GUARDED = '<event name="done" next="3"><when><data tag="t" is="1"/></when></event>'
SPEAKS = "<backgroundactions><speech>bye</speech></backgroundactions>"


@pytest.mark.parametrize(
    ("events", "sub", "why"),
    [
        (DONE, f"<always><timeout>3</timeout></always>{SUB}", "has something in every state"),
        (GUARDED, SUB, "without a condition"),
        (DONE, state("1", ways("9")) + state("9", SPEAKS), "let an empty state after it"),
        (DONE, state("1"), "there is nothing in it"),
        (
            '<event name="done" next="3"><set tag="t">1</set></event>',
            state("1", '<timeout next="9">5</timeout>') + state("9"),
            "The timeout of state 1 n1 ends the part, and done does something",
        ),
        (f'{DONE}<event name="z" next="#back"/>', SUB, "In state 2 n2 z leads to #back"),
        (DONE, state("1", ways("#back", "9")) + state("9"), "leads back to the state before"),
    ],
)
def test_what_can_not_stand_alone_is_not_dissolved(events: str, sub: str, why: str) -> None:
    with pytest.raises(NoPart) as refused:
        dissolve(project(held(events), sub=sub), FILE, "2")
    assert why in str(refused.value)
    with pytest.raises(NoPart, match="Select a state that runs a part"):
        dissolve(project(held(events), sub=sub), FILE, "1")
