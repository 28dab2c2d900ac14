"""What tells two projects apart: their files, parts, texts and media."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from tests.document.described import SCRIPT, pills, read_document

from situ.cli import main
from situ.document.diff import compare
from situ.document.diff_media import compare_media
from situ.document.folder import load
from situ.document.project import Mqtt, Project, Setting
from situ.errors import UsageError


def _project(**more: Any) -> Project:
    document = read_document(pills())
    given: dict[str, Any] = {
        "root": ".", "name": "p", "toml": "situ.toml", "applications": {"a.rbd.xml": document},
        "spds_file": "s.spds.xml", "spds": read_document(SCRIPT), "languages": ("en", "ja"),
        "texts": {"ja": {"Now": "今"}}, "tags": {"a": 1}, "places": {"lobby": (1.0, 2.0, 0.0)},
        "private": ("user.**",), "settings": (Setting("a", "A"),), "durable": ("a",),
        "mqtt": Mqtt("mqtt://here", {"x": "event:y"}),
    }  # fmt: skip
    return Project(**{**given, **more})


@pytest.mark.parametrize(
    ("more", "told", "behaviour"),
    [
        ({"name": "q"}, "project's name “p” → “q”", False),
        ({"languages": ("ja", "en")}, "order of languages en, ja → ja, en", True),
        ({"languages": ("en",)}, "language ja gone", True),
        ({"texts": {"ja": {"Now": "いま"}}}, "in ja, “Now”: “今” → “いま”", True),
        ({"tags": {"a": True}}, "tag at the start a 1 → yes", True),
        ({"tags": {"a": 1, "b": [2]}}, "tag at the start b added: [2]", True),
        ({"places": {}}, "place lobby gone, was [1.0, 2.0, 0.0]", True),
        ({"private": ()}, "private tags user.** gone", True),
        ({"durable": ("a", "b")}, "durable tags b added", True),
        ({"settings": ()}, "setting a gone", True),
        ({"settings": (Setting("a", "B"),)}, "setting a: label “A” → “B”", False),
        (
            {"settings": (Setting("a", "A", "text", ("b", "c")),)},
            "setting a: choices “” → “b, c”",
            True,
        ),
        ({"media": "pictures"}, "folder of media none → “pictures”", True),
        ({"announce": False}, "announced in the network yes → no", False),
        ({"adapter": "ros2"}, "adapter “sim” → “ros2”", True),
        ({"mqtt": Mqtt("mqtt://here", {})}, "mqtt x gone, was “event:y”", True),
        ({"applications": {}}, "application a gone", True),
        ({"spds": None, "spds_file": None}, "s.spds.xml gone", True),
        (
            {"spds": read_document(SCRIPT), "spds_file": "t.spds.xml"},
            "its file is t.spds.xml, was s.spds.xml",
            False,
        ),
        ({"modules": read_document("<modules/>"), "modules_file": "m.xml"}, "m.xml added", True),
        (
            {"texts": {"ja": {"Now": "今", "New": "新" * 61}}},
            f"in ja, “New”: none → “{'新' * 59}…”",
            True,
        ),
        ({"parts": {"p.rbd.xml": read_document(pills())}}, "part a added", True),
        (
            {"applications": {"b.rbd.xml": read_document(pills())}},
            "application a: its file is b.rbd.xml, was a.rbd.xml",
            False,
        ),
    ],
)
def test_projects(more: dict[str, Any], told: str, behaviour: bool) -> None:
    (change,) = compare(_project(), _project(**more))
    assert (change.text, change.behaviour) == (told, behaviour)


def test_parts_and_texts_that_stayed_or_changed_where_it_can_not_be_seen() -> None:
    part, other = read_document(pills()), read_document(pills(seconds="60"))
    before = _project(parts={"p": part})
    assert compare(before, _project(parts={"p": read_document(pills())})) == []
    (change,) = compare(before, _project(parts={"p": other}))
    assert (change.file, change.text) == ("p", "state Take pills: timeout 30 → 60 s")
    long = "a" * 70
    before = _project(texts={"ja": {"Now": long}})
    (change,) = compare(before, _project(texts={"ja": {"Now": long + "b"}}))
    assert change.text == f"in ja, “Now”: {long} → {long}b"


def test_a_document_alone_is_compared_without_what_only_a_project_has() -> None:
    alone = Project(
        root=".", name="q", applications={"other.rbd.xml": read_document(pills(seconds="9"))}
    )
    before = Project(root=".", name="p", applications={"a.rbd.xml": read_document(pills())})
    assert [c.text for c in compare(before, alone)] == ["state Take pills: timeout 30 → 9 s"]
    assert (
        compare(read_document(SCRIPT), read_document(pills()))[0].text
        == "a script → an application"
    )


def test_the_order_of_applications_counts() -> None:
    a, b = read_document(pills()), read_document(pills().replace('name="a"', 'name="b"'))
    before = _project(applications={"a": a, "b": b})
    (change,) = compare(before, _project(applications={"b": b, "a": a}))
    assert (change.text, change.behaviour) == ("application b now comes first", True)
    assert compare(before, _project(applications={"a": a, "b": b})) == []


DAY = """<application name="day"><state no="1" name="hall"/>
  <state no="2" name="ask"><backgroundactions><speech>Who?</speech></backgroundactions>
  <expectedevents><event name="ok" next="3"/></expectedevents></state>
  <state no="3" name="thanks"><backgroundactions><speech>Thanks</speech></backgroundactions>
  <expectedevents><event name="ok" next="1"/></expectedevents></state></application>"""

WITH_PART = """<application name="day"><state no="1" name="hall"/>
  <state no="2" name="learn"><flow src="ask.rbd.xml"/></state></application>"""

ASK = """<application name="ask">
  <state no="a" name="ask"><backgroundactions><speech>Who?</speech></backgroundactions>
  <expectedevents><event name="ok" next="b"/></expectedevents></state>
  <state no="b" name="thanks"><backgroundactions><speech>Thanks</speech></backgroundactions>
  <expectedevents><event name="ok" next="end"/></expectedevents></state>
  <state no="end" final="true"/></application>"""


def _days(text: str, **parts: str) -> Project:
    read = {f"{name}.rbd.xml": read_document(part) for name, part in parts.items()}
    return _project(applications={"day.rbd.xml": read_document(text)}, parts=read)


def _lines(before: Project, after: Project) -> list[str]:
    return [f"{change.file}: {change.text}" for change in compare(before, after)]


def test_states_that_went_into_a_part_are_told_as_that_and_so_is_the_way_back() -> None:
    before, after = _days(DAY), _days(WITH_PART, ask=ASK)
    assert _lines(before, after) == [
        "day.rbd.xml: state 2 ask: now in ask.rbd.xml, as a ask",
        "day.rbd.xml: state 3 thanks: now in ask.rbd.xml, as b thanks",
        "day.rbd.xml: state learn: added, runs the part ask.rbd.xml",
        "ask.rbd.xml: part ask added",
    ]
    assert _lines(after, before) == [
        "day.rbd.xml: state learn: gone, ran the part ask.rbd.xml",
        "ask.rbd.xml: part ask gone",
        "ask.rbd.xml: state a ask: now in day.rbd.xml, as 2 ask",
        "ask.rbd.xml: state b thanks: now in day.rbd.xml, as 3 thanks",
    ]


def test_a_state_that_is_gone_or_new_is_told_where_its_like_stands_in_no_other_file() -> None:
    more = ASK.replace("</application>", '<state no="c" name="again"/></application>')
    assert _lines(_days(WITH_PART, ask=more), _days(WITH_PART, ask=ASK)) == [
        "ask.rbd.xml: state again: gone"
    ]
    assert _lines(_days(WITH_PART, ask=ASK), _days(WITH_PART, ask=more)) == [
        "ask.rbd.xml: state again: added"
    ]


def test_a_part_in_a_file_of_another_name_is_the_same_part() -> None:
    renamed = WITH_PART.replace("ask.rbd.xml", "who.rbd.xml")
    changes = compare(_days(WITH_PART, ask=ASK), _days(renamed, who=ASK))
    assert [(change.file, change.text, change.behaviour) for change in changes] == [
        ("day.rbd.xml", "state learn: part ask.rbd.xml → who.rbd.xml", True),
        ("who.rbd.xml", "part ask: its file is who.rbd.xml, was ask.rbd.xml", False),
    ]


# -- media --------------------------------------------------------------------


def test_media_without_a_folder_or_that_can_not_be_read(tmp_path: Path) -> None:
    (tmp_path / "media").mkdir()
    (tmp_path / "media" / "a.png").symlink_to(tmp_path / "nowhere")
    whole = Project(root=str(tmp_path), name="p", toml="situ.toml", media="media")
    bare = Project(root=str(tmp_path), name="p", toml="situ.toml")
    assert [c.text for c in compare_media(bare, whole)] == ["media a.png added"]
    assert compare_media(bare, Project(root=".", name="p")) == []
    with pytest.raises(UsageError, match="cannot be read"):
        compare_media(whole, whole)


def test_media_with_other_content_are_told(tmp_path: Path) -> None:
    projects = []
    for name, content in (("one", b"1"), ("two", b"2")):
        folder = tmp_path / name
        (folder / "media").mkdir(parents=True)
        (folder / "media" / "a.png").write_bytes(content)
        (folder / "media" / f"{name}.png").write_bytes(content)
        (folder / "media" / "same.png").write_bytes(b"same")
        (folder / "a.rbd.xml").write_text(pills(), encoding="utf-8")
        text = '[project]\nname = "p"\napplications = ["a.rbd.xml"]\nmedia = "media"\n'
        (folder / "situ.toml").write_text(text, encoding="utf-8")
        projects.append(str(folder))
    assert main(["diff", *projects]) == 1
    loaded = [load(path)[0] for path in projects]
    assert loaded[0] is not None
    assert loaded[1] is not None
    assert [c.text for c in compare_media(loaded[0], loaded[1])] == [
        "media a.png has other content",
        "media one.png gone",
        "media two.png added",
    ]
