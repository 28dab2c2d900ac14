"""Sample values come from the project itself: its tags at the start and its scenarios."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from situ.document import folder, rbd
from situ.resources import example
from situ_studio.screens import samples
from situ_studio.screens.shown import content


def test_the_reception_knows_its_people_from_its_scenarios_in_the_language_of_the_start() -> None:
    project, _ = folder.load(example("reception"))
    assert project is not None
    known = samples.gather(project)
    # What was typed into the input of the state that was entered, not into its namesake.
    assert known["user.initial.x"][0] == "J"
    assert known["user.initial.y"][0] == "N"
    assert known["language"][0] == "en"
    assert known["patients"][0][0]["name"] == "Jack Nilsen"
    assert samples.offered(known, "user.name") == ("Jack Nilsen", "Anna Silva")


def test_what_a_person_picks_goes_before_what_is_known() -> None:
    values = samples.chosen({"user.name": ("Jack", "Ana")}, {"user.name": "Mere"})
    assert samples.value_of(values, "user.name") == "Mere"
    assert samples.value_of({"user": {"name": "Ana"}}, "user.name") == "Ana"
    assert samples.value_of(values, "user.room") is None


def test_a_text_without_a_sample_shows_its_reference_and_a_list_has_entries() -> None:
    each = "{item.name}, {item.room}"
    screen = rbd.Screen(
        components=(
            rbd.Text(id="t", text="Hello {user.name}", x=5, y=5, width=90, height=20),
            rbd.List(id="l", items="people", label=each, x=5, y=30, width=90, height=30),
            rbd.List(id="m", items="words", x=5, y=65, width=90, height=30),
        )
    )
    shown = content(screen, values=samples.filled({}, screen)).components
    assert shown[0]["text"] == "Hello {user.name}"
    assert shown[1]["items"][0]["label"] == "{name} 1, {room} 1"
    assert len(shown[2]["items"]) == 3


def test_a_scenario_that_can_not_be_read_is_passed_over(project: Callable[[str], Path]) -> None:
    copied = project("reception")
    (copied / "scenarios" / "broken.jsonl").write_text("{", encoding="utf-8")
    read, _ = folder.load(copied)
    assert read is not None
    assert samples.gather(read)["spo2.value"] == (97,)
