"""The form of a project: what ``situ.toml`` says, changed field by field, with everything else of
the file as it was written.
"""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QWidget

from situ.document import folder
from situ.document.project import Setting
from situ_studio.project_form.form import ProjectForm
from situ_studio.project_form.going import field_at
from situ_studio.project_form.values import as_kind, kind_of

Start = Callable[..., Any]
CONTROL = Qt.KeyboardModifier.ControlModifier
TOML = """# The ward's own
[project]
name = "ward"   # as on the door
applications = ["a.rbd.xml", "b.rbd.xml"]
spds = "s.spds.xml"
languages = ["en"]
colour = "blue" # nobody knows this

[tags]
"services.records" = "http://127.0.0.1:8080"
visits = 3
"""


@pytest.fixture
def ward(tmp_path: Path) -> Path:
    (tmp_path / "situ.toml").write_text(TOML)
    for name in "ab":
        (tmp_path / f"{name}.rbd.xml").write_text(
            f'<application name="{name}"><state no="1" final="true"/></application>'
        )
    (tmp_path / "s.spds.xml").write_text(
        '<spds name="s"><modules><module name="a" resources=""/><module name="b" resources=""/>'
        '</modules><situation name="all"><module name="a" priority="1"/>'
        '<module name="b" priority="2"/></situation></spds>'
    )
    return tmp_path


@pytest.fixture
def used(studio: Start, ward: Path) -> Any:
    """The ward with its form open, by a click on the project in the tree."""
    made = studio(ward)
    tree = made.window.project_tree.tree
    made.click_row(tree, made.row_with(tree, "ward"))
    assert form(made).isVisible()
    return made


def form(used: Any) -> ProjectForm:
    found = used.window.pages.page("situ.toml")
    assert isinstance(found, ProjectForm)
    return found


def fill(used: Any, field: QWidget, text: str) -> None:
    form(used).area.ensureWidgetVisible(field)
    used.settle()
    used.fill(field, text, Qt.Key.Key_Tab)


def press(used: Any, button: QWidget) -> None:
    form(used).area.ensureWidgetVisible(button)
    used.settle()
    used.click(button)


def choose(used: Any, field: Any, text: str) -> None:
    form(used).area.ensureWidgetVisible(field)
    used.choose(field, text)
    used.key(Qt.Key.Key_Return)


def section(used: Any, name: str) -> Any:
    return form(used).sections[name]


def rows(used: Any, name: str) -> Any:
    return section(used, name).rows


def visits(used: Any) -> Any:
    return used.session.project.tags["visits"]


def said(used: Any) -> str:
    return str(used.window.status.said.text())


def test_a_name_is_one_line_of_the_file_and_one_step(used: Any, ward: Path) -> None:
    name = section(used, "project").fields["project", "name"]
    fill(used, name, "Ward 3")
    assert used.session.project.name == "Ward 3"
    assert used.session.undo_text == "Change name"
    assert used.window.project_tree.tree.model().index(0, 0).data() == "Ward 3"
    used.window.actions_.actions["save"].trigger()
    assert (ward / "situ.toml").read_text() == TOML.replace('"ward" ', '"Ward 3" ')
    used.window.actions_.actions["undo"].trigger()
    assert used.window.tabs.chosen_file == "situ.toml"
    assert name.text() == "ward"
    # What can not be left empty is said at the field, and the old stands there again.
    fill(used, name, "")
    assert name.text() == "ward"
    assert said(used) == "This can not be left empty."


def test_values_at_the_start_have_kinds_and_names(used: Any) -> None:
    tags = rows(used, "tags")
    value: Any = tags.field(1, 1)
    assert value.kind.currentText() == "Number"
    fill(used, value.value_field, "4.5")
    assert visits(used) == 4.5
    fill(used, value.value_field, "many")
    assert said(used) == "Write a number."
    assert visits(used) == 4.5
    choose(used, value.kind, "Yes or no")
    assert visits(used) is True
    choose(used, value.value_field, "no")
    assert visits(used) is False
    choose(used, value.kind, "List")
    fill(used, value.value_field, '["a", {"b": 1}]')
    assert visits(used) == ["a", {"b": 1}]
    fill(used, value.value_field, "[null]")
    assert "no null" in said(used)
    fill(used, tags.field(1, 0), "count.visits")
    assert list(used.session.project.tags) == ["services.records", "count.visits"]
    fill(used, tags.field(1, 0), "Not A Tag")
    assert "A tag is words" in said(used)
    fill(used, tags.field(1, 0), "robot/base")
    assert said(used) == "robot/base is written by the robot itself only."
    fill(used, tags.field(1, 0), "services.records")
    assert said(used) == "services.records is there already."
    assert list(used.session.project.tags) == ["services.records", "count.visits"]


def test_a_value_is_added_filled_in_by_keys_and_removed(used: Any) -> None:
    tags = rows(used, "tags")
    press(used, form(used).sections["tags"].plus)
    assert used.session.project.tags["new"] == ""
    # The cursor stands in the name: typing goes over it, Tab goes on to kind and value.
    used.type("greeting")
    used.key(Qt.Key.Key_Tab)
    used.key(Qt.Key.Key_Tab)
    assert QApplication.focusWidget() is tags.field(2, 1).value_field
    used.type("Hello")
    used.key(Qt.Key.Key_Tab)
    assert used.session.project.tags["greeting"] == "Hello"
    press(used, tags.buttons(0)[-1])
    assert list(used.session.project.tags) == ["visits", "greeting"]
    assert len(tags) == 2
    for _ in range(4):
        used.window.actions_.actions["undo"].trigger()
    assert used.session.dirty == []
    assert len(tags) == 2


def test_a_setting_has_choices_and_is_durable_without_a_word(used: Any) -> None:
    settings, before = rows(used, "settings"), used.session.project.durable
    press(used, form(used).sections["settings"].plus)
    used.type("How loud")
    used.key(Qt.Key.Key_Tab)
    fill(used, settings.field(0, 1), "speech.loud")
    assert not settings.field(0, 3).isEnabled()
    choose(used, settings.field(0, 2), "Choice")
    fill(used, settings.field(0, 3), "soft")
    assert "Two or more" in said(used)
    fill(used, settings.field(0, 3), "soft, loud")
    (found,) = used.session.project.settings
    assert found == Setting("speech.loud", "How loud", "choice", ("soft", "loud"))
    assert used.session.project.durable == before
    choose(used, settings.field(0, 2), "Time")
    assert used.session.project.settings == (Setting("speech.loud", "How loud", "time"),)


def test_a_language_is_added_by_the_name_that_somebody_knows(used: Any) -> None:
    for words in ("Japanese", "deutsch", "español", "pt-BR", "nurse"):
        used.answers.put("name", words)
        press(used, form(used).sections["languages"].plus)
    assert used.session.project.languages == ("en", "ja", "de", "es", "pt-BR")
    assert "nurse is no language" in used.window.status.said.text()


def test_languages_are_added_ordered_and_removed(used: Any) -> None:
    languages = rows(used, "languages")
    used.answers.put("name", "ja")
    press(used, form(used).sections["languages"].plus)
    assert used.session.project.languages == ("en", "ja")
    assert [languages.field(0, n).text() for n in range(3)] == ["en", "English", "written in"]
    press(used, languages.buttons(1)[0])
    assert used.session.project.languages == ("ja", "en")
    press(used, languages.buttons(0)[-1])
    assert used.session.project.languages == ("en",)


def test_the_order_of_applications_counts(used: Any) -> None:
    assert list(used.session.project.applications) == ["a.rbd.xml", "b.rbd.xml"]
    press(used, rows(used, "applications").buttons(0)[1])
    assert list(used.session.project.applications) == ["b.rbd.xml", "a.rbd.xml"]
    used.window.actions_.actions["undo"].trigger()
    assert list(used.session.project.applications) == ["a.rbd.xml", "b.rbd.xml"]


def test_everything_that_the_file_may_say_can_be_said(used: Any, ward: Path) -> None:
    for name in ("durable", "private", "places", "mqtt"):
        press(used, section(used, name).plus)
    fill(used, rows(used, "durable").field(0, 0), "medication.*")
    fill(used, rows(used, "private").field(0, 0), "user.**")
    fill(used, rows(used, "private").field(0, 0), "no pattern!")
    fill(used, rows(used, "places").field(0, 0), "lobby")
    for column, number in ((1, "2"), (2, "1.5"), (3, "90")):
        fill(used, rows(used, "places").field(0, column), number)
    fill(used, rows(used, "mqtt").field(0, 0), "zigbee/+/fall")
    fill(used, rows(used, "mqtt").field(0, 2), "fallDetected")
    means = rows(used, "mqtt").field(0, 1)
    means.setFocus()
    used.key(Qt.Key.Key_Down)
    assert "A tag is words" in said(used)
    assert means.currentText() == "an event"
    fill(used, section(used, "mqtt").broker, "mqtt://127.0.0.1:1883")
    fill(used, section(used, "robot").fields["robot", "adapter"], "sim")
    used.window.actions_.actions["save"].trigger()
    project, problems = folder.load(ward)
    assert project is not None
    # What was wrong before is still told, and nothing else.
    assert [p.code for p in problems] == ["unknown-key"]
    assert (project.durable, project.private) == (("medication.*",), ("user.**",))
    assert project.places == {"lobby": (2.0, 1.5, 90.0)}
    assert project.mqtt is not None
    assert project.mqtt.incoming == {"zigbee/+/fall": "event:fallDetected"}
    text = (ward / "situ.toml").read_text()
    assert text.startswith(TOML)
    assert tomllib.loads(text)["robot"] == {"adapter": "sim"}


def test_words_are_said_as_somebody_reads_them(used: Any, ward: Path) -> None:
    readings = form(used).readings
    press(used, readings.plus)
    # The cursor stands in the word.
    used.type("Dr.")
    used.key(Qt.Key.Key_Tab)
    used.type("Doctor")
    used.key(Qt.Key.Key_Tab)
    assert used.session.project.readings == {"en": {"Dr.": "Doctor"}}
    press(used, readings.plus)
    used.type("Dr.")
    used.key(Qt.Key.Key_Tab)
    assert said(used) == "Dr. is there already."
    press(used, readings.rows.buttons(1)[-1])
    # To another language and back: one step, though two files change.
    used.answers.put("name", "ja")
    press(used, form(used).sections["languages"].plus)
    # The file of a language that came is begun with it: what lacks is told text by text.
    used.session.check_now()
    assert "missing-texts" not in [one.code for one in used.session.problems]
    form(used).area.ensureWidgetVisible(readings)
    readings.rows.field(0, 0).setFocus()
    used.key(Qt.Key.Key_Down)
    assert used.session.project.readings == {"ja": {"Dr.": "Doctor"}}
    used.window.actions_.actions["undo"].trigger()
    used.window.actions_.actions["undo"].trigger()
    assert used.session.project.readings == {"en": {"Dr.": "Doctor"}}
    used.window.actions_.actions["save"].trigger()
    project, problems = folder.load(ward)
    assert project is not None
    assert project.readings == {"en": {"Dr.": "Doctor"}}
    assert project.texts == {"en": {}}
    assert [p.code for p in problems] == ["unknown-key"]
    text = (ward / "texts/en.po").read_text()
    assert 'msgctxt "reading"\nmsgid "Dr."\nmsgstr "Doctor"' in text
    press(used, readings.rows.buttons(0)[-1])
    assert used.session.project.readings == {}


def test_one_robot_has_its_own_values(used: Any, ward: Path) -> None:
    made = form(used)
    press(used, made.which.button("robot.local.toml"))
    assert not made.sections["languages"].isVisible()
    endpoint = section(used, "robot").fields["robot", "endpoint"]
    fill(used, endpoint, "tcp://10.0.0.7:5570")
    assert used.session.project.endpoint == "tcp://10.0.0.7:5570"
    assert used.session.dirty == ["robot.local.toml"]
    used.key(Qt.Key.Key_S, CONTROL)
    local = ward / "robot.local.toml"
    assert local.read_text() == '[robot]\nendpoint = "tcp://10.0.0.7:5570"\n'
    assert (ward / "situ.toml").read_text() == TOML
    used.window.actions_.actions["undo"].trigger()
    assert used.session.project.endpoint == "tcp://127.0.0.1:5570"
    assert endpoint.text() == ""


def test_whether_robots_announce_themselves_is_said_for_all_and_for_one(
    used: Any, ward: Path
) -> None:
    made, robot = form(used), section(used, "robot")
    assert robot.announce.isChecked()
    press(used, robot.announce)
    assert not used.session.project.announce
    used.key(Qt.Key.Key_S, CONTROL)
    assert "[robot]\nannounce = false" in (ward / "situ.toml").read_text()
    # Where this robot says nothing the project's word counts; it may say another one.
    press(used, made.which.button("robot.local.toml"))
    assert not robot.announce.isChecked()
    press(used, robot.announce)
    assert used.session.project.announce
    used.key(Qt.Key.Key_S, CONTROL)
    assert (ward / "robot.local.toml").read_text() == "[robot]\nannounce = true\n"
    press(used, robot.announce)
    assert not used.session.project.announce
    press(used, made.which.button("situ.toml"))
    press(used, robot.announce)
    assert used.session.project.announce
    used.key(Qt.Key.Key_S, CONTROL)
    assert "announce" not in (ward / "situ.toml").read_text()
    assert field_at(made, ("robot", "announce")) is robot.announce


def test_problems_of_the_file_stand_above_and_lead_here(used: Any) -> None:
    used.session.check_now()
    assert form(used).told.isVisible()
    used.window.tabs.choose("a.rbd.xml")
    (problem,) = [p for p in used.session.problems if p.code == "unknown-key"]
    used.window.problems.chosen.emit(problem)
    used.settle()
    assert form(used).isVisible()
    assert used.window.tabs.chosen_file == "situ.toml"


def test_a_place_of_the_file_has_its_field(used: Any) -> None:
    def at(*place: str) -> QWidget | None:
        return field_at(form(used), place)

    assert at("tags", "visits") is rows(used, "tags").field(1, 0)
    assert at("project", "languages") is section(used, "languages")
    assert at("project", "languages", "0") is rows(used, "languages").field(0, 0)
    assert at("project", "name") is section(used, "project").fields["project", "name"]
    assert at("project", "colour") is section(used, "project")
    assert at("colours") is None
    used.window.pages.go_to_field("situ.toml", ("project", "name"))
    assert QApplication.focusWidget() is at("project", "name")


@pytest.mark.parametrize(
    ("value", "kind", "wanted"),
    [
        ("3", "number", 3),
        ("2.5", "number", 2.5),
        ("no", "flag", False),
        (1, "flag", True),
        (True, "text", "true"),
        ("x", "json", ["x"]),
        ([1], "text", "[1]"),
        ("x", "number", 0),
    ],
)
def test_a_value_of_another_kind_is_as_near_as_can_be(value: Any, kind: str, wanted: Any) -> None:
    assert as_kind(value, kind) == wanted
    assert kind_of(as_kind(value, kind)) == kind
