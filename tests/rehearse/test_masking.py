"""``[privacy]``: private values are ••• to all but operators where recordings are read or exported
(formats.md, *A project*; architecture.md)."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.rehearse.recorded_robot import Recorded

from situ import cli
from situ.decide import inputs, masking
from situ.decide.masking import HIDDEN, Mask
from situ.decide.step import SECOND
from situ.document.folder import sources
from situ.document.ready import load_ready
from situ.engine.record import OneFile, Recorder
from situ.rehearse.masking import masked
from situ.rehearse.recorded import Document, Heading, Line, Piece, Snapshot, Taken, read

WARD = """<application name="ward">
  <state no="1">
    <screen><components>
      <input id="name" x="1" y="1" width="80" height="9" size="6" tag="user.name" event="go"/>
    </components></screen>
    <expectedevents><event name="go" next="2"/></expectedevents>
  </state>
  <state no="2">
    <screen><components>
      <text id="hello" x="1" y="1" width="80" height="9" size="6">Hello {user.name}</text>
      <text id="free" x="1" y="20" width="80" height="9" size="6">Good morning</text>
    </components></screen>
    <backgroundactions>
      <speech>Dear {user.name}, good morning</speech>
      <set tag="card">For {user.name}</set>
      <service name="find" url="http://localhost/find?who={user.name}">
        <result tag="bp.now" path="bp"/></service>
    </backgroundactions>
  </state>
</application>"""
TOML = """[project]
name = "ward"
applications = ["ward.rbd.xml"]
[privacy]
private = ["user.**", "bp.**"]
"""


@pytest.fixture
def ward(tmp_path: Path) -> Path:
    folder = tmp_path / "ward"
    folder.mkdir()
    (folder / "ward.rbd.xml").write_text(WARD, encoding="utf-8")
    (folder / "situ.toml").write_text(TOML, encoding="utf-8")
    return folder


@pytest.fixture
def file(ward: Path, tmp_path: Path) -> Path:
    """A recording in which Ann Lee tells her name, and her blood pressure is asked for."""
    file = tmp_path / "run.mcap"
    play(Recorded(ward, made(file, ward)))
    return file


def made(file: Path, ward: Path) -> Recorder:
    return Recorder(OneFile(file), sources(load_ready(ward)))


def play(run: Recorded) -> None:
    run.at(SECOND, inputs.Use("name", "Ann Lee"))
    run.at(
        2 * SECOND,
        inputs.Finish(action="service", name="find", result={"bp": {"sys": 143}, "ward": "B"}),
    )
    run.recorder.close()


def trace(out: str) -> list[dict[str, Any]]:
    return [json.loads(line) for line in out.splitlines()]


def test_a_viewer_sees_all_but_what_is_private(
    file: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["replay", str(file)]) == 0
    whole = capfd.readouterr().out
    assert "Ann Lee" in whole
    assert "143" in whole
    assert cli.main(["replay", str(file), "--role", "viewer"]) == 0
    shown = capfd.readouterr().out
    for secret in ("Ann", "ann", "Lee", "143"):
        assert secret not in shown
    before, after = trace(whole), trace(shown)
    # Nothing is missing, and what is not private stands as it stood.
    own = ("kind", "seq", "t", "cause", "application", "state", "tag", "name", "writer")
    for name in own:
        assert [e.get(name) for e in after] == [e.get(name) for e in before]
    hidden = {e["tag"]: e["value"] for e in after if e["kind"] == "data"}
    assert hidden.pop("service/find")["ok"] is True
    assert hidden == {"user.name": HIDDEN, "card": HIDDEN, "bp.now": HIDDEN}
    screen = next(e for e in after if e["kind"] == "screen" and e["state"] == "2")
    assert [c["text"] for c in screen["components"]] == [HIDDEN, "Good morning"]
    assert [c["size"] for c in screen["components"]] == [6, 6]
    said = {e["action"]: e for e in after if e["kind"] == "action"}
    (found,) = (e for e in after if e["kind"] == "finished" and e["action"] == "service")
    assert found["result"] == HIDDEN
    assert said["speech"]["text"] == said["service"]["url"] == HIDDEN


def test_a_masked_export_says_that_it_can_not_be_replayed(
    file: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "shown.mcap"
    assert cli.main(["replay", str(file), "--role", "viewer", "-o", str(out)]) == 0
    assert "masked" in capfd.readouterr().err
    heading, *rest = read(out)
    assert isinstance(heading, Heading)
    assert heading.masked
    # Neither inputs nor documents: they would tell it.
    assert not [piece for piece in rest if isinstance(piece, (Taken, Snapshot, Document))]
    assert b"Ann" not in b"".join(repr(piece).encode() for piece in (heading, *rest))
    cli.main(["replay", str(file), "--role", "viewer"])
    shown = capfd.readouterr().out
    for options in ((), ("--role", "viewer")):
        assert cli.main(["replay", str(out), *options]) == 0
        assert capfd.readouterr().out == shown
    assert cli.main(["replay", str(out), "--decide"]) == 2
    assert "masked" in capfd.readouterr().err


def test_an_operator_s_export_is_whole(
    file: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "copy.mcap"
    assert cli.main(["replay", str(file), "-o", str(out)]) == 0
    assert list(read(out)) == list(read(file))
    assert cli.main(["replay", str(out), "--decide"]) == 0


def test_a_ring_s_file_hides_what_was_known_before_it_began(
    ward: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    first = Recorded(ward, made(tmp_path / "first.mcap", ward))
    first.at(SECOND, inputs.Set({"user.name": "Ann Lee"}, "nod"))
    first.recorder.close()
    file = tmp_path / "second.mcap"
    run = Recorded(ward, made(file, ward), state=first.robot.snapshot())
    run.at(2 * SECOND, inputs.Raise("go"))
    run.at(3 * SECOND)
    run.recorder._waiting.append(("/inputs", 1.7e9, b'{"us":3000000,"t":3.0,"given":null}'))
    run.recorder.close()
    assert cli.main(["replay", str(file), "--role", "viewer"]) == 0
    shown = capfd.readouterr().out
    assert HIDDEN in shown
    assert "Ann" not in shown
    copy = tmp_path / "copy.mcap"
    assert cli.main(["replay", str(file), "-o", str(copy)]) == 0
    assert list(read(copy)) == list(read(file))


def test_a_file_that_breaks_off_is_masked_too(
    file: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    file.write_bytes(file.read_bytes()[:-200])
    assert cli.main(["replay", str(file), "--role", "viewer"]) == 0
    out, told = capfd.readouterr()
    assert HIDDEN in out
    assert "breaks off" in told


def test_what_an_application_wrote_is_masked_though_it_has_not_been_heard_of(file: Path) -> None:
    known = [piece for piece in read(file) if isinstance(piece, (Heading, Document))]
    lines = [
        Line(json.dumps({**data(tag, 41), "seq": at, "t": at, "writer": "ward"}).encode(), at)
        for at, tag in enumerate(("user.age", "card"), 1)
    ]
    shown = [json.loads(one.text) for one in masked([*known, *lines]) if isinstance(one, Line)]
    assert [one["value"] for one in shown] == [HIDDEN, HIDDEN]


def test_what_does_not_go_together_is_2(
    file: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    for options in (
        ("--decide", "--role", "viewer"),
        ("--decide", "-o", str(tmp_path / "x.mcap")),
        ("-o", str(file)),
        ("-o", str(tmp_path / "none" / "x.mcap")),
    ):
        before = file.read_bytes()
        assert cli.main(["replay", str(file), *options]) == 2
        assert len(capfd.readouterr().err.splitlines()) == 1
        assert file.read_bytes() == before


def data(tag: str, value: Any) -> dict[str, Any]:
    return {"kind": "data", "tag": tag, "value": value}


def speech(text: Any) -> dict[str, Any]:
    return {"kind": "action", "action": "speech", "name": None, "text": text}


@pytest.mark.parametrize(
    ("value", "text", "hidden"),
    [
        ("Ann", "Hello Ann!", True),
        ("Ann", "HELLO ANN", True),
        ("Ann", "http://x/?q=%41nn+Lee", True),
        ("田中", "田中さん", True),
        ("A", "Are these your initials: A S?", True),
        ("A", "A day as any other a day", True),
        ("A", "Are you a friend?", False),
        (120, "Your blood pressure is 120 over 80", True),
        (120, "Room 1204", False),
        (120.0, 120, True),
        (120, 121, False),
        (1, True, False),
        (True, "true", False),
        ("", "anything", False),
        (None, "null", False),
        (["Ann", {"last": "Lee"}], {"Lee": 1}, True),
        ([{"last": "Lee"}], ["x", {"y": "Lee"}], True),
        ("Ann", None, False),
    ],
)
def test_what_holds_a_private_value_is_hidden_whole(value: Any, text: Any, hidden: bool) -> None:
    (_, said) = Mask(["user.*"]).step([data("user.x", value), speech(text)])
    assert (HIDDEN in json.dumps(said, ensure_ascii=False)) == hidden
    if not hidden:
        assert said == speech(text)


def test_patterns_reach_into_values() -> None:
    mask = Mask(["user.name", "names.1"])
    (user,) = mask.step([data("user", {"name": "Ann", "room": 7})])
    assert user["value"] == {"name": HIDDEN, "room": 7}
    (names,) = mask.step([data("names", ["Bo", "Cy"])])
    assert names["value"] == ["Bo", HIDDEN]
    assert mask.step([speech("Ann"), speech("Bo")]) == [speech(HIDDEN), speech("Bo")]


def test_a_deletion_is_no_secret_and_what_was_there_stays_one() -> None:
    told = Mask(["user.*"]).step([data("user.x", "Ann"), data("user.x", None), speech("Ann")])
    assert [told[1]["value"], told[2]["text"]] == [None, HIDDEN]


def test_a_value_and_a_text_are_shown_by_what_is_known() -> None:
    mask = Mask(["user"])
    assert mask.shown("user", "Ann") == HIDDEN
    assert mask.shown("note", {"to": "Dear Ann", "at": 3}) == {"to": HIDDEN, "at": 3}
    assert [mask.text("Dear Ann"), mask.text("Dear Bob")] == [HIDDEN, "Dear Bob"]


def test_where_components_stand_is_no_secret() -> None:
    component = {"type": "text", "id": "3", "x": 3, "y": 3, "text": "3", "items": [{"id": 3}]}
    value = {"components": [component]}
    told = Mask(["bp"]).step([data("bp", 3), {"kind": "mapping", "value": value}])[1]
    shown = {"text": HIDDEN, "items": [{"id": HIDDEN}]}
    assert told["value"]["components"] == [{**component, **shown}]


def test_what_the_runtime_says_of_itself_is_never_filled_in_so_it_is_shown() -> None:
    mask = Mask(["user.**"])
    mask.know("user", {"id": 3, "name": "Ann"})
    for tag, value in (
        ("application/home", {"state": "3", "name": "Ann asks", "suspended": False}),
        ("situation", {"name": "day", "priorities": {"home": 3}}),
        ("clock.weekday", 3),
        ("clock.time", "03:00"),
    ):
        assert mask.shown(tag, value, "situ") == value
    for tag in ("application.note", "clock.note"):
        assert mask.shown(tag, "Ann", "home") == HIDDEN
    told = {"ok": True, "status": 3, "error": "Ann: 3"}
    assert mask.shown("service/find", told, "home") == {**told, "error": HIDDEN}
    assert Mask(["clock.*"]).shown("clock.time", "03:00") == HIDDEN


@pytest.mark.parametrize(
    ("writer", "value", "hidden"),
    [
        ("cuff", 3, False),
        ("operator:ann", {"at": [3, {"room": 3}]}, False),
        ("scenario", 3, False),
        ("cuff", "3", True),
        ("cuff", "room 3", True),
        ("home", 3, True),
        ("home", [{"id": 3}], True),
        ("screen", {"id": 3}, True),
    ],
)
def test_a_number_that_no_application_has_set_was_not_filled_in(
    writer: str, value: Any, hidden: bool
) -> None:
    """The same of a trace and of the blackboard; what an application or a list's entry copies
    may be somebody's."""
    event = {"kind": "enter", "application": "home", "state": "3"}
    mask = Mask(["user.*"])
    entered, _, told = mask.step(
        [event, data("user.id", 3), {**data("x", value), "writer": writer}]
    )
    assert entered == event
    assert (HIDDEN in json.dumps(told["value"], ensure_ascii=False)) == hidden
    on_board = Mask(["user.*"], applications=["home"])
    on_board.know("user.id", 3)
    assert on_board.shown("x", value, writer) == told["value"]


@pytest.mark.parametrize(
    ("number", "hidden"),
    [
        (5551234, True),
        (-555123, True),
        (35.689487, True),
        (0.00123456, True),
        # Short ones, and round ones, are others' too.
        (55512, False),
        (120.5, False),
        (1_000_000, False),
        (12_345_000, False),
        (True, False),
    ],
)
def test_a_private_number_is_hidden_wherever_a_module_sets_it_if_it_can_be_no_other_one(
    number: Any, hidden: bool
) -> None:
    mask = Mask(["user.*"], applications=["home"])
    mask.know("user.phone", number)
    shown = HIDDEN if hidden else number
    assert mask.shown("called", {"number": [number]}, "phone") == {"number": [shown]}
    command = {"kind": "mapping", "resource": "base", "module": "phone", "value": number}
    assert mask.step([command])[0]["value"] == shown
    other = 7654321
    assert mask.shown("called", other, "phone") == other


def test_what_a_module_commands_has_its_numbers_and_what_an_application_commands_has_not() -> None:
    mask = Mask(["user.*"], applications=["home"])
    mask.know("user.room", 3)
    command = {"kind": "mapping", "resource": "base", "value": {"vx": 3, "to": "room 3"}}
    told = mask.step([{**command, "module": "joystick"}, {**command, "module": "home"}])
    assert [one["value"] for one in told] == [
        {"vx": 3, "to": HIDDEN},
        {"vx": HIDDEN, "to": HIDDEN},
    ]


def test_texts_of_the_project_are_shown_as_they_are_written_unless_they_are_the_value() -> None:
    mask = Mask(["user.*"], written=["Blood pressure", "Question 3 of 5", "Ann"])
    mask.know("user.last", "pressure")
    mask.know("user.id", 3)
    mask.know("user.name", "Ann")
    texts = ("Blood pressure", "Question 3 of 5", "Ann", "Ann: blood pressure", "3 of 5")
    shown = ["Blood pressure", "Question 3 of 5", HIDDEN, HIDDEN, HIDDEN]
    assert [mask.text(one) for one in texts] == shown


def test_written_are_the_texts_without_a_reference_in_all_languages(ward: Path) -> None:
    (ward / "texts").mkdir()
    (ward / "texts" / "ja.po").write_text(
        'msgid "Good morning"\nmsgstr "おはようございます"\n\n'
        'msgid "Hello {user.name}"\nmsgstr "{user.name}さん、こんにちは"\n'
    )
    toml = TOML.replace("[privacy]", 'languages = ["en", "ja"]\n[privacy]')
    (ward / "situ.toml").write_text(toml, encoding="utf-8")
    assert masking.written(load_ready(ward)) == {"Good morning", "おはようございます"}


def test_a_recording_knows_the_texts_of_its_project(
    ward: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "run.mcap"
    run = Recorded(ward, made(file, ward))
    run.at(SECOND, inputs.Use("name", "morning"))
    run.recorder.close()
    assert cli.main(["replay", str(file), "--role", "viewer"]) == 0
    events = trace(capfd.readouterr().out)
    screen = next(e for e in events if e["kind"] == "screen" and e["state"] == "2")
    assert [c["text"] for c in screen["components"]] == [HIDDEN, "Good morning"]


def test_private_values_stay_hidden_where_the_project_in_a_recording_is_damaged() -> None:
    told = [data("user.name", "Ann Lee"), data("ward", "B")]
    pieces: list[Piece] = [
        Heading(private=("user.**",)),
        Document("situ.toml", b"["),
        *(Line(json.dumps({"t": 0.0, **event}).encode(), 0) for event in told),
    ]
    shown = [json.loads(piece.text) for piece in masked(pieces) if isinstance(piece, Line)]
    assert [event["value"] for event in shown] == [HIDDEN, "B"]


def test_only_so_many_are_known_and_the_last_seen_stay(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(masking, "MANY", 2)
    mask = Mask(["user"])
    for name in ("Ann", "Bob", "Ann", "Cyd"):
        mask.step([data("user", name)])
    told = mask.step([speech("Ann"), speech("Bob"), speech("Cyd")])
    assert [one["text"] for one in told] == [HIDDEN, "Bob", HIDDEN]


@settings(max_examples=100)
@given(st.text(min_size=2), st.text(), st.text())
def test_no_text_that_holds_a_private_text_is_shown(secret: str, left: str, right: str) -> None:
    if len(secret.strip()) > 1 and not masking._is_number(secret.strip().casefold()):
        told = Mask(["user"]).step([data("user", secret), speech(left + secret + right)])
        assert told[1]["text"] == HIDDEN


def test_without_private_tags_nothing_is_hidden() -> None:
    events = [data("user.name", "Ann"), speech("Hello Ann")]
    assert Mask(()).step(events) == events
