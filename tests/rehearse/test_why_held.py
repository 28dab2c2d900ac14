"""Why a situation was not current, a resource not held (``why_situation``, ``why_held``)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from tests.rehearse.asked import APP, SCRIPT, answered

from situ.document.modules import Module, Modules
from situ.document.project import Project
from situ.rehearse.recording import Recording

if TYPE_CHECKING:
    from tests.rehearse.conftest import Make, Record


# -- situations ---------------------------------------------------------------


def test_the_condition_of_a_situation(lab: Project, record: Record) -> None:
    told = answered(lab, record(lab, {"at": 1, "set": {"heat": 39}}), 2, "situation", to="hot")
    assert told == (
        "- the condition of hot did not hold: heat above 40: it was 39, set at 1 s by scenario"
    )


def test_a_situation_that_goes_first_or_is_kept(lab: Project, record: Record) -> None:
    lines_ = [{"at": 1, "set": {"hold": True, "light": 1}}, {"at": 2, "set": {"hold": False}}]
    recording = record(lab, *lines_)
    assert answered(lab, recording, 1.5, "situation", to="dark").startswith(
        "- situation held, which goes before dark, was current since 1 s: hold is true"
    )
    assert answered(lab, recording, 3, "situation", to="dark").startswith(
        "- situation held, which goes before dark, was current since 1 s; it stays at least 10 s"
    )


def test_a_situation_that_was_ended_by_its_limit_or_until(lab: Project, record: Record) -> None:
    recording = record(lab, {"at": 1, "set": {"heat": 50}}, {"at": 9, "set": {"cooled": True}})
    assert answered(lab, recording, 7, "situation", to="hot").startswith(
        "- hot has ended at 6 s by until or limit"
    )
    assert answered(lab, recording, 10, "situation", to="hot").startswith(
        "- until of hot held, so it does not begin: cooled is true: it was true, set at 9 s"
    )


def test_a_situation_that_ended_before_the_trace_begins_is_told_without_its_end(
    lab: Project, record: Record
) -> None:
    recording = record(lab, {"at": 1, "set": {"heat": 50}}, {"at": 9, "set": {"heat": 60}})
    late = [event for event in recording.events if event["t"] >= 9]
    assert answered(lab, Recording.of(late), 10, "situation", to="hot") == (
        "- hot has ended by until or limit and begins again only after its condition has once "
        "been false"
    )


def test_more_of_authority_and_situations(lab: Project, make: Make, record: Record) -> None:
    told = answered(lab, record(lab), 1, "situation", to="calm")
    assert told == "- calm was current already, since 0 s"
    kept = SCRIPT.replace('dwell="10"', 'limit="10"').replace(
        '<situation name="held" limit="10"><condition><data tag="hold" is="true"/></condition>',
        '<situation name="held" limit="10"><condition><data tag="hold" is="true"/></condition>'
        '<until><data tag="stop" is="1"/></until>',
    )
    held = {"at": 1, "set": {"hold": True}}, {"at": 2, "set": {"hold": False}}
    project = make(APP, kept)
    told = answered(project, record(project, *held), 2, "situation", to="calm")
    assert told == (
        "- situation held, which goes before calm, was current since 1 s; "
        "it stays until stop is 1 and it ends after 10 s at the latest"
    )
    free = make(APP)
    told = answered(free, record(free), 1, "authority", resource="head", to="app")
    assert told == "- app did not ask for head, only for base"
    assert answered(lab, record(lab), 1, "resume", application="app") == "- app was not suspended"


def test_a_limit_alone_and_a_holder_of_less_priority(
    lab: Project, make: Make, record: Record
) -> None:
    until = SCRIPT.replace(' limit="5"', "")
    project = make(APP, until)
    heat = {"at": 1, "set": {"heat": 50}}, {"at": 2, "set": {"heat": 1}}
    told = answered(project, record(project, *heat), 3, "situation", to="calm")
    assert told.endswith("was current since 1 s; it stays until cooled is true")
    # A trace without its situations: who holds a resource may have less priority than who asks.
    lines_ = {"at": 1, "acquire": {"module": "arm", "resources": ["base"]}}, heat[0]
    events = record(lab, *lines_).events
    late = [e for e in events if not (e["kind"] == "authority" and e["t"] == 1)]
    told = answered(lab, Recording.of(late), 1, "authority", resource="base", to="arm")
    assert told == "- app held base since 0 s"


# -- authority and mapping ----------------------------------------------------


@pytest.mark.parametrize(
    ("module", "resource", "told"),
    [
        ("arm", "hand", "- arm did not ask for hand"),
        ("arm", "head", "- arm did not declare head, only base and hand"),
        ("leg", "base", "- no module leg is declared"),
        ("app", "speech", "- app did not ask for speech, only for base"),
    ],
)
def test_a_module_that_can_not_hold_a_resource(
    lab: Project, record: Record, module: str, resource: str, told: str
) -> None:
    recording = record(lab, {"at": 2, "end": True})
    assert answered(lab, recording, 1, "authority", resource=resource, to=module) == told


def test_the_priority_that_stood_in_the_way(lab: Project, record: Record) -> None:
    def ask(module: str, *more: dict[str, Any]) -> str:
        acquire = {"module": module, "resources": ["base"]}
        recording = record(lab, *more, {"at": 1, "acquire": acquire})
        return answered(lab, recording, 1, "authority", resource="base", to=module)

    held = "- app held base since 0 s: priority 10"
    assert ask("arm") == f"{held} against 5 of arm in situation calm"
    assert ask("other") == f"{held} like other, and it came first"
    assert ask("other", {"at": 0, "set": {"light": 1}}).startswith(
        "- other has no priority in situation dark"
    )
    both = {"at": 0.5, "acquire": {"module": "arm", "resources": ["base", "hand"]}}
    told = answered(lab, record(lab, both), 1, "authority", resource="hand", to="arm")
    assert told.splitlines() == [
        "- arm asks for base and hand together: all of them or none",
        f"  {held} against 5 of arm in situation calm",
    ]


def test_a_module_that_was_lost(lab: Project, record: Record) -> None:
    recording = record(
        lab,
        {"at": 1, "acquire": {"module": "arm", "resources": ["hand"]}},
        {"at": 2, "lost": {"module": "arm"}},
    )
    told = answered(lab, recording, 3, "authority", resource="hand", to="arm")
    assert told.startswith("- arm was lost at 2 s and has not asked again")
    told = answered(lab, recording, 1.5, "authority", resource="hand", to="arm")
    assert told.startswith("- arm held hand already, since 1 s")


def test_a_module_that_nobody_gave_a_priority(make: Make, record: Record) -> None:
    known = Modules((Module("arm", ("hand",)),))
    free = make(APP, modules=known, modules_file="modules.xml")
    recording = record(free, {"at": 1, "acquire": {"module": "arm", "resources": ["hand"]}})
    told = answered(free, recording, 2, "authority", resource="hand", to="arm")
    assert told == "- arm has no priority in this project"


def test_a_holder_without_a_valid_command(lab: Project, record: Record) -> None:
    def ask(*more: dict[str, Any], at: float = 3) -> str:
        acquire = {"at": 1, "acquire": {"module": "arm", "resources": ["hand"]}}
        return answered(
            lab, record(lab, acquire, *more), at, "mapping", resource="hand", module="arm"
        )

    assert ask().startswith("- arm held hand but had no valid command for it")
    command = {"module": "arm", "resource": "hand", "value": {"grip": 1}}
    assert 'hand was already moved by arm: {"grip":1}' in ask({"at": 2, "command": command})
    early = {"at": 0.5, "command": command}
    recording = record(lab, early, {"at": 1, "acquire": {"module": "arm", "resources": ["hand"]}})
    told = answered(lab, recording, 3, "mapping", resource="hand", module="arm")
    assert told.startswith('- arm held hand but had no valid command for it; what it commanded, {"')


def test_a_trace_cut_off_before_authority_was_given(lab: Project, record: Record) -> None:
    acquire = {"at": 1, "acquire": {"module": "arm", "resources": ["hand"]}}
    events = record(lab, acquire).events
    cut = [e for e in events if not (e["kind"] == "authority" and e["t"] == 1)]
    told = answered(lab, Recording.of(cut), 1, "authority", resource="hand", to="arm")
    assert told == "- nobody held hand"
    late = Recording.of([e for e in events if e["kind"] == "acquire"])
    told = answered(lab, late, 1, "authority", resource="hand", to="arm")
    assert told == "- arm has no priority in no situation"


def test_giving_back_some_keeps_the_rest(lab: Project, record: Record) -> None:
    given: list[dict[str, Any]] = [
        {"at": 1, "set": {"hold": True}},
        {"at": 1, "acquire": {"module": "arm", "resources": ["base", "hand"]}},
        {"at": 2, "abandon": {"module": "arm", "resources": ["base"]}},
        {"at": 3, "abandon": {"module": "arm", "resources": ["hand"]}},
    ]
    recording = record(lab, *given)
    told = answered(lab, recording, 2, "authority", resource="base", to="arm")
    assert told == "- arm gave base back at 2 s and has not asked for it again"
    told = answered(lab, recording, 3, "authority", resource="hand", to="arm")
    assert told == "- arm gave hand back at 3 s and has not asked for it again"
    alone = Recording.of([e for e in recording.events if e["kind"] == "abandon"])
    assert answered(lab, alone, 4, "authority", resource="hand", to="arm") == told
    again = [
        {"at": 5, "acquire": {"module": "arm", "resources": ["hand"]}},
        {"at": 6, "acquire": {"module": "arm", "resources": ["base"]}},
    ]
    told = answered(lab, record(lab, *given, *again), 6, "authority", resource="hand", to="arm")
    assert told == "- arm did not ask for hand, only for base"


def test_who_asked_in_vain_and_gave_up_is_told_what_stood_in_the_way_until_then(
    lab: Project, record: Record
) -> None:
    recording = record(
        lab,
        {"at": 1, "set": {"light": 3}},
        {"at": 2, "acquire": {"module": "arm", "resources": ["base", "hand"]}},
        {"at": 3, "set": {"light": 9}},
        {"at": 4, "abandon": {"module": "arm", "resources": ["hand"]}},
        {"at": 6, "abandon": {"module": "arm", "resources": ["base"]}},
        {"at": 8, "set": {"light": 3}},
    )
    vain = "in vain, and not again since"
    hand = [
        f"- arm asked for hand from 2 s to 4 s {vain}",
        "  - arm asks for base and hand together: all of them or none",
        "    - app held base since 3 s: priority 10 against 5 of arm in situation calm",
    ]
    base = [
        f"- arm asked for base from 2 s to 6 s {vain}",
        "  - app held base since 3 s: priority 10 against 5 of arm in situation calm",
    ]
    for at in (6, 8):
        for kind, field in (("authority", "to"), ("mapping", "module")):
            for resource, told in (("hand", hand), ("base", base)):
                wanted = {"resource": resource, field: "arm"}
                assert answered(lab, recording, at, kind, **wanted).splitlines() == told
    # Given up in one go, of each is told what kept it from that one.
    at_once = record(
        lab,
        {"at": 2, "acquire": {"module": "arm", "resources": ["base", "hand"]}},
        {"at": 4, "abandon": {"module": "arm", "resources": ["base", "hand"]}},
    )
    for resource, count in (("base", 2), ("hand", 3)):
        told = answered(lab, at_once, 6, "authority", resource=resource, to="arm").splitlines()
        assert told[0] == f"- arm asked for {resource} from 2 s to 4 s {vain}"
        assert len(told) == count
        assert told[-1].lstrip().startswith("- app held base since 0 s")
    # Asked for again it is told how that is now.
    again = record(
        lab,
        {"at": 2, "acquire": {"module": "arm", "resources": ["base"]}},
        {"at": 4, "abandon": {"module": "arm", "resources": ["base"]}},
        {"at": 5, "set": {"light": 3}},
        {"at": 6, "acquire": {"module": "arm", "resources": ["base"]}},
    )
    now = answered(lab, again, 6, "authority", resource="base", to="arm")
    assert now == "- arm has no priority in situation dark"
