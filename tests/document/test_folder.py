"""A project as a folder: what its files say, what is wrong with them (formats.md, *A project*)."""

from __future__ import annotations

import os
import stat
from collections.abc import Callable
from pathlib import Path

import pytest

from situ.document import folder, projectfile, reader, texts
from situ.document.check import merge, structure
from situ.document.problem import Problem
from situ.document.project import Mqtt, Project, Setting
from situ.errors import UsageError

TOML = """\
[project]
name = "reception"
applications = ["reception.rbd.xml"]
spds = "reception.spds.xml"
modules = "modules.xml"
media = "media"
scenarios = "scenarios"
languages = ["en", "ja"]
[robot]
endpoint = "tcp://127.0.0.1:5571"
adapter = "sim"
[tags]
"services.records" = "http://127.0.0.1:8080"
[durable]
tags = ["medication.*"]
[places]
lobby = [2.0, 1.5, 90]
[mqtt]
url = "mqtt://127.0.0.1:1883"
in = { "zigbee/+/fall" = "event:fallDetected", "room/temp" = "tag:room.temperature" }
[privacy]
private = ["user.**", "bp.**"]
[[setting]]
tag = "medication.morning"
label = "Morning round"
type = "time"
[[setting]]
tag = "medication.voice"
label = "Voice"
type = "choice"
choices = ["soft", "loud"]
"""
APPLICATION = """\
<application name="reception"><state no="1"><backgroundactions><speech>Hello {user.name}</speech>
<sound src="chime.ogg"/></backgroundactions></state></application>"""
SCRIPT = """\
<spds name="s"><modules><module name="reception" resources="speech"/></modules>
<situation name="always"><module name="reception" priority="1"/></situation></spds>"""
PO = """\
msgid ""
msgstr "Content-Type: text/plain; charset=UTF-8\\n"

msgid "Hello {user.name}"
msgstr "こんにちは、{user.name}さん"

#, fuzzy
msgid "unsure"
msgstr "?"
"""
SETTINGS = {"Morning round": "朝の回診", "Voice": "声", "soft": "小さい声", "loud": "大きい声"}
"""What the settings say, in Japanese."""
PO += "".join(f'\nmsgid "{text}"\nmsgstr "{said}"\n' for text, said in SETTINGS.items())

Write = Callable[..., Path]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Writes a whole project but for what is given, by path; None leaves a file out."""

    def write(**changed: str | None) -> Path:
        files: dict[str, str | None] = {
            "situ.toml": TOML,
            "reception.rbd.xml": APPLICATION,
            "reception.spds.xml": SCRIPT,
            "modules.xml": "<modules/>",
            "media/chime.ogg": "",
            "texts/ja.po": PO,
        }
        files.update({name.replace("__", "/").replace("_", "."): t for name, t in changed.items()})
        for name, text in files.items():
            if text is not None:
                path = tmp_path / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
        return tmp_path

    return write


def found_in(path: Path) -> tuple[Project | None, list[Problem]]:
    project, problems = folder.load(path)
    return project, merge(problems, structure(project) if project is not None else [])


def told(path: Path) -> list[tuple[str, str, int]]:
    return [(Path(p.file).name, p.code, p.line) for p in found_in(path)[1]]


def test_a_whole_project_is_read(write: Write) -> None:
    root = write()
    project, problems = found_in(root)
    assert problems == []
    assert project is not None
    assert (project.root, project.name, project.toml) == (str(root), "reception", "situ.toml")
    assert list(project.applications) == ["reception.rbd.xml"]
    assert project.spds is not None
    assert project.spds.name == "s"
    assert project.modules is not None
    assert (project.media, project.scenarios) == ("media", "scenarios")
    assert project.languages == ("en", "ja")
    assert project.texts == {"ja": {"Hello {user.name}": "こんにちは、{user.name}さん", **SETTINGS}}
    assert (project.endpoint, project.adapter) == ("tcp://127.0.0.1:5571", "sim")
    assert project.announce
    assert project.tags == {"services.records": "http://127.0.0.1:8080"}
    assert project.durable == ("medication.*",)
    assert project.places == {"lobby": (2.0, 1.5, 90.0)}
    assert project.mqtt == Mqtt(
        url="mqtt://127.0.0.1:1883",
        incoming={"zigbee/+/fall": "event:fallDetected", "room/temp": "tag:room.temperature"},
    )
    assert project.private == ("user.**", "bp.**")
    assert project.settings == (
        Setting("medication.morning", "Morning round", "time"),
        Setting("medication.voice", "Voice", "choice", ("soft", "loud")),
    )


def test_folder_and_its_situ_toml_are_the_same_project(write: Write) -> None:
    root = write()
    assert folder.load(root) == folder.load(root / "situ.toml")


def test_an_almost_empty_situ_toml_is_a_project(tmp_path: Path) -> None:
    (tmp_path / "situ.toml").write_text("")
    project, problems = found_in(tmp_path)
    assert problems == []
    assert project is not None
    assert (project.name, project.endpoint) == (tmp_path.name, "tcp://127.0.0.1:5570")


def test_a_single_document_is_a_project(write: Write) -> None:
    root = write()
    project, problems = found_in(root / "reception.rbd.xml")
    assert problems == []
    assert project is not None
    assert (project.name, list(project.applications)) == ("reception", ["reception.rbd.xml"])
    script, problems = found_in(root / "reception.spds.xml")
    assert problems == []
    assert script is not None
    assert script.spds is not None
    modules, problems = found_in(root / "modules.xml")
    assert problems == []
    assert modules is not None
    assert modules.modules is not None


def test_robot_local_toml_overrides_what_is_per_robot(write: Write) -> None:
    root = write(
        robot_local_toml='[robot]\nendpoint = "tcp://127.0.0.1:6000"\nannounce = false\n'
        '[tags]\nlanguage = "ja"\n'
        '"services.records" = "http://10.0.0.2"\n[places]\nbed = [1, 2, 3]\n'
    )
    project, problems = found_in(root)
    assert problems == []
    assert project is not None
    assert project.tags == {"services.records": "http://10.0.0.2", "language": "ja"}
    assert (project.endpoint, project.adapter) == ("tcp://127.0.0.1:6000", "sim")
    assert not project.announce
    assert set(project.places) == {"lobby", "bed"}


@pytest.mark.parametrize(
    ("text", "file", "code", "line"),
    [
        ("[project\n", "situ.toml", "malformed-toml", 1),
        ("[project]\nname = \n", "situ.toml", "malformed-toml", 2),
        ("[project]\nname = 'a'\nname = 'b'\n", "situ.toml", "malformed-toml", 3),
        ("[projekt]\nname = 'a'\n", "situ.toml", "unknown-key", 1),
        ("[project]\nnam = 'a'\n", "situ.toml", "unknown-key", 2),
        ("name = 'a'\n", "situ.toml", "unknown-key", 1),
        ("[robot]\nport = 1\n[tags]\n", "situ.toml", "unknown-key", 2),
        ("[robot]\nannounce = 0\n[tags]\n", "situ.toml", "bad-value", 2),
        ("[project]\nname = 3\n", "situ.toml", "bad-value", 2),
        ("[project]\napplications = 'a.rbd.xml'\n", "situ.toml", "bad-value", 2),
        ("project = 3\n", "situ.toml", "bad-value", 1),
        ("[setting]\ntag = 'a'\n", "situ.toml", "bad-value", 1),
        ("[[setting]]\ntag = 'A'\n", "situ.toml", "bad-tag", 2),
        ("[[setting]]\ntag = 'a'\ntype = 'tim'\n", "situ.toml", "bad-value", 3),
        ("[[setting]]\ntag = 'a'\ntype = 'choice'\n", "situ.toml", "bad-value", 3),
        (
            "[[setting]]\ntag = 'a'\ntype = 'choice'\nchoices = ['b', 'b']\n",
            "situ.toml",
            "bad-value",
            3,
        ),
        ("[[setting]]\ntag = 'a'\nchoices = ['b', 'c']\n", "situ.toml", "bad-value", 1),
        ("[tags]\na = 1\n'B c' = 2\n", "situ.toml", "bad-tag", 3),
        ("[tags]\na = nan\n", "situ.toml", "bad-value", 2),
        ("[tags]\na = 2020-01-01\n", "situ.toml", "bad-value", 2),
        ("[tags]\n'robot/head' = 1\n", "situ.toml", "reserved-tag", 2),
        ("[durable]\ntags = ['a', 'b*']\n", "situ.toml", "bad-tag", 2),
        ("[places]\nbed = [1, 2]\n", "situ.toml", "bad-value", 2),
        ("[places]\nbed = ['1', 2, true]\n", "situ.toml", "bad-value", 2),
        ("[mqtt]\nin = { 'a/b' = 'fall' }\n", "situ.toml", "bad-value", 2),
        ("[mqtt]\nin = { 'a/#/b' = 'event:fall' }\n", "situ.toml", "bad-value", 2),
        ("[mqtt]\nin = { 'a+/b' = 'event:fall' }\n", "situ.toml", "bad-value", 2),
        ("[mqtt]\nurl = 'http://host'\n", "situ.toml", "bad-value", 2),
        ("[mqtt]\nurl = 'mqtt://ann:key@host'\n", "situ.toml", "bad-value", 2),
        ("[project]\napplications = [\n 'a.rbd.xml',\n]\n", "situ.toml", "missing-file", 3),
        ("[project]\nspds = '../a.spds.xml'\n", "situ.toml", "path-outside", 2),
        ("[project]\nmodules = '/etc/passwd'\n", "situ.toml", "path-outside", 2),
        ("[project]\nmedia = '..'\n", "situ.toml", "path-outside", 2),
        ("[project]\nlanguages = ['en', '../x']\n", "situ.toml", "bad-value", 2),
        ("[project]\nspds = 'modules.xml'\n", "situ.toml", "wrong-document", 2),
        (
            "[project]\napplications = ['reception.rbd.xml', 'reception.rbd.xml']\n",
            "situ.toml",
            "duplicate-file",
            2,
        ),
        ("a = " + "[" * 3000, "situ.toml", "malformed-toml", 1),
    ],
)
def test_what_is_wrong_in_situ_toml_is_told_with_its_line(
    write: Write, text: str, file: str, code: str, line: int
) -> None:
    found = told(write(situ_toml=text))
    assert (file, code, line) in found
    assert {f for f, *_ in found} <= {"situ.toml", "reception.rbd.xml"}


def test_unknown_keys_are_told_the_nearest_known_one(write: Write) -> None:
    _, problems = found_in(write(situ_toml="[project]\nlanguage = ['en']\n"))
    assert "did you mean languages?" in problems[0].message


def test_robot_local_toml_may_not_change_the_project(write: Write) -> None:
    assert told(write(robot_local_toml="[project]\nname = 'b'\n")) == [
        ("robot.local.toml", "unknown-key", 1)
    ]


def test_malformed_toml_and_not_utf8_are_no_project(write: Write) -> None:
    root = write()
    (root / "situ.toml").write_bytes(b"[project]\nname = '\xff'\n")
    project, problems = folder.load(root)
    assert project is None
    assert [(p.code, p.line) for p in problems] == [("malformed-toml", 2)]


def test_a_document_that_cannot_be_read_leaves_the_rest(write: Write) -> None:
    project, problems = folder.load(write(reception_rbd_xml="<application"))
    assert [(Path(p.file).name, p.code) for p in problems] == [
        ("reception.rbd.xml", "malformed-xml")
    ]
    assert project is not None
    assert project.applications == {}
    assert project.spds is not None


def test_a_link_that_leads_out_of_the_project_is_refused(write: Write, tmp_path: Path) -> None:
    root = write(reception_rbd_xml=None, media__chime_ogg=None)
    outside = root.parent / f"{root.name}-outside"
    outside.mkdir()
    (outside / "a.xml").write_text(APPLICATION)
    (root / "reception.rbd.xml").symlink_to(outside / "a.xml")
    assert ("situ.toml", "path-outside", 3) in told(root)
    (root / "reception.rbd.xml").unlink()
    (root / "reception.rbd.xml").write_text(APPLICATION)
    (root / "media").mkdir(exist_ok=True)
    (root / "media" / "chime.ogg").symlink_to(outside / "a.xml")
    assert told(root) == [("reception.rbd.xml", "path-outside", 2)]


@pytest.mark.parametrize("name", ["nothing", "nothing/situ.toml", "", "a.txt", "\0"])
def test_what_cannot_be_read_at_all_is_wrong_usage(tmp_path: Path, name: str) -> None:
    (tmp_path / "a.txt").write_text("a")
    with pytest.raises(UsageError) as raised:
        folder.load(tmp_path / name)
    assert "\n" not in str(raised.value)


def test_a_project_that_the_system_does_not_give_is_wrong_usage(
    write: Write, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = write()

    def refuse(_: Path) -> bytes:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "read_bytes", refuse)
    for path in (root, root / "situ.toml", root / "reception.rbd.xml"):
        with pytest.raises(UsageError, match="Permission denied"):
            folder.load(path)


def test_a_file_that_the_system_does_not_give_is_told(
    write: Write, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = write()
    read = Path.read_bytes

    def refuse(path: Path) -> bytes:
        if path.name in closed:
            raise PermissionError(13, "Permission denied")
        return read(path)

    monkeypatch.setattr(Path, "read_bytes", refuse)
    closed = ["reception.rbd.xml", "ja.po"]
    _, problems = folder.load(root)
    assert [(Path(p.file).name, p.code) for p in problems] == [
        (name, "unreadable-file") for name in closed
    ]
    assert "Permission denied" in problems[0].message
    whole = APPLICATION.replace("</state>", '</state><state no="2"><flow src="p.rbd.xml"/></state>')
    part = '<application name="p"><state no="1"/></application>'
    write(reception_rbd_xml=whole, p_rbd_xml=part, robot_local_toml="")
    closed = ["robot.local.toml", "p.rbd.xml"]
    _, problems = folder.load(root)
    assert [(Path(p.file).name, p.code) for p in problems] == [
        (name, "unreadable-file") for name in closed
    ]


def test_a_local_file_that_cannot_be_read_is_told_and_the_project_stays(write: Write) -> None:
    project, problems = folder.load(write(robot_local_toml="[robot\n"))
    assert project is not None
    assert project.endpoint == "tcp://127.0.0.1:5571"
    assert [(Path(p.file).name, p.code) for p in problems] == [
        ("robot.local.toml", "malformed-toml")
    ]


@pytest.mark.parametrize("path", ["a\0b", "a" * 5000])
def test_a_path_that_no_system_has_is_one_line(path: str) -> None:
    with pytest.raises(UsageError, match="no such file"):
        folder.load(path)


def test_links_in_a_circle_lead_nowhere(write: Write) -> None:
    root = write(reception_rbd_xml=None)
    (root / "reception.rbd.xml").symlink_to("other.rbd.xml")
    (root / "other.rbd.xml").symlink_to("reception.rbd.xml")
    assert ("situ.toml", "unreadable-file") not in [(n, c) for n, c, _ in told(root)]
    assert {code for _, code, _ in told(root)} & {"missing-file", "unreadable-file"}


def test_a_part_must_be_an_application(write: Write) -> None:
    whole = APPLICATION.replace(
        "</state>", '</state><state no="2"><flow src="reception.spds.xml"/></state>'
    )
    project, _ = folder.load(write(reception_rbd_xml=whole))
    assert project is not None
    assert project.parts == {}
    assert told(write(reception_rbd_xml=whole)) == [("reception.rbd.xml", "wrong-document", 2)]


@pytest.mark.parametrize(
    ("text", "place", "words"),
    [
        ("[project]\nname =", (2, 7), "no TOML"),
        ("[project]\nname = 1 2", (2, 10), "no TOML"),
        ("[project]\na = " + "[" * 100_000, (1, 1), "no TOML"),
        (b"[project]\n\xff", (2, 1), "UTF-8"),
    ],
)
def test_a_project_file_that_is_no_toml_is_told_with_its_place(
    tmp_path: Path, text: str | bytes, place: tuple[int, int], words: str
) -> None:
    (tmp_path / "situ.toml").write_bytes(text.encode() if isinstance(text, str) else text)
    project, (problem,) = folder.load(tmp_path)
    assert project is None
    assert problem.code == "malformed-toml"
    assert (problem.line, problem.column) == place
    assert words in problem.message


def test_tags_hold_lists_and_tables(write: Write) -> None:
    toml = TOML.replace("[tags]", '[tags]\n"a" = [1, { b = "c" }]\n"d" = { e = [inf] }')
    project, problems = folder.load(write(situ_toml=toml))
    assert project is not None
    assert project.tags["a"] == [1, {"b": "c"}]
    assert "d" not in project.tags
    assert [p.code for p in problems] == ["bad-value"]


@pytest.mark.parametrize(
    ("data", "line", "words"),
    [
        (b'msgid "a"\nmsgstr "\xff"\n', 2, "UTF-8"),
        (b" " * 16_000_001, 1, "larger than 16 MB"),
    ],
)
def test_texts_that_cannot_be_read_are_told(data: bytes, line: int, words: str) -> None:
    found, _, (problem,) = texts.read(data, "ja.po")
    assert found == {}
    assert (problem.code, problem.line) == ("malformed-po", line)
    assert words in problem.message


def test_texts_of_one_line_are_no_name_of_a_file(tmp_path: Path) -> None:
    (tmp_path / "b.po").write_text('msgid "a"\nmsgstr "b"\n')
    assert texts.read(str(tmp_path / "b.po").encode(), "ja.po")[0] == {}


def test_a_file_that_is_too_large_is_told(write: Write, monkeypatch: pytest.MonkeyPatch) -> None:
    root = write()
    for module in (reader, projectfile, texts):
        monkeypatch.setattr(module, "MAX_BYTES", 10)
    _, problems = folder.load(root / "reception.rbd.xml")
    assert [(p.code, p.line, p.column) for p in problems] == [("too-large", 1, 1)]
    _, problems = folder.load(root)
    assert [p.code for p in problems] == ["too-large"]


# -- what only a whole project shows ------------------------------------------


def test_media_must_be_there(write: Write) -> None:
    assert told(write(media__chime_ogg=None)) == [("reception.rbd.xml", "missing-media", 2)]


def test_several_applications_need_a_script(write: Write) -> None:
    toml = '[project]\napplications = ["reception.rbd.xml", "b.rbd.xml"]\nmedia = "media"\n'
    second = APPLICATION.replace('"reception"', '"b"')
    assert told(write(situ_toml=toml, b_rbd_xml=second)) == [("situ.toml", "spds-needed", 2)]


def test_applications_have_different_names(write: Write) -> None:
    toml = TOML.replace('["reception.rbd.xml"]', '["reception.rbd.xml", "b.rbd.xml"]')
    assert told(write(situ_toml=toml, b_rbd_xml=APPLICATION)) == [
        ("b.rbd.xml", "double-application", 1)
    ]


def test_an_application_needs_a_priority_somewhere(write: Write) -> None:
    none = SCRIPT.replace('priority="1"', 'priority="none"')
    assert told(write(reception_spds_xml=none)) == [
        ("reception.rbd.xml", "application-without-priority", 1)
    ]


def test_an_application_declares_the_resources_that_its_states_use(write: Write) -> None:
    screen = SCRIPT.replace('resources="speech"', 'resources="screen"')
    assert told(write(reception_spds_xml=screen)) == [
        ("reception.rbd.xml", "undeclared-resource", 1)
    ]
    base = APPLICATION.replace(
        "<sound", '<robot resource="base" command="stop" optional="true"/>\n<sound'
    )
    assert told(write(reception_rbd_xml=base)) == [("reception.rbd.xml", "undeclared-resource", 2)]
    clears = APPLICATION.replace('<state no="1">', '<state no="1"><screen/>')
    assert told(write(reception_rbd_xml=clears)) == []


def test_a_module_may_be_declared_in_the_module_information(write: Write) -> None:
    script = SCRIPT.replace("<modules>", "<!--").replace("</modules>", "-->")
    known = '<modules><module name="reception" resources="speech"/></modules>'
    assert told(write(reception_spds_xml=script, modules_xml=known)) == []


def test_script_and_module_information_must_not_contradict(write: Write) -> None:
    known = '<modules><module name="reception" resources="speech head"/></modules>'
    assert told(write(modules_xml=known)) == [("reception.spds.xml", "contradiction", 1)]
    observed = SCRIPT.replace(
        "<modules>", '<observe>\n<data tag="a" type="text"/></observe><modules>'
    )
    known = '<modules><module name="m"><provides data="a" type="number"/></module></modules>'
    assert told(write(reception_spds_xml=observed, modules_xml=known)) == [
        ("reception.spds.xml", "contradiction", 2)
    ]


def test_a_text_without_translation_is_a_warning(write: Write) -> None:
    more = APPLICATION.replace("</speech>", "</speech>\n<speech>Bye</speech><speech>{a} 5</speech>")
    _project, problems = found_in(write(reception_rbd_xml=more))
    assert [(p.severity, p.code, p.line) for p in problems] == [("warning", "missing-text", 2)]
    assert '"Bye"' in problems[0].message
    assert "ja" in problems[0].message


def test_labels_and_choices_of_settings_lack_a_translation_as_other_texts_do(write: Write) -> None:
    toml = TOML.replace("Morning round", "Voice of the morning")
    again = '[[setting]]\ntag = "night.voice"\nlabel = "Voice"\n'
    said = PO
    for text in ("Voice", "loud"):
        said = said.replace(f'msgstr "{SETTINGS[text]}"', 'msgstr ""')
    _, problems = found_in(write(situ_toml=toml + again, texts__ja_po=said))
    assert {(p.severity, p.code, p.file.endswith("situ.toml")) for p in problems} == {
        ("warning", "missing-text", True)
    }
    # Each once, where it is written.
    assert [(p.message.split(":")[0], p.place, p.line) for p in problems] == [
        ('No text in ja for "Voice of the morning"', ("setting", "0", "label"), 25),
        ('No text in ja for "Voice"', ("setting", "1", "label"), 29),
        ('No text in ja for "loud"', ("setting", "1", "choices", "1"), 31),
    ]


def test_a_language_without_texts_is_one_warning(write: Write) -> None:
    _, problems = found_in(write(texts__ja_po=None))
    assert [(p.severity, p.code, p.line) for p in problems] == [("warning", "missing-texts", 8)]


def test_malformed_texts_are_told_with_their_line(write: Write) -> None:
    assert told(write(texts__ja_po='msgid "a"\nmsgstr "b"\n\nnonsense\n'))[0] == (
        "ja.po",
        "malformed-po",
        4,
    )


def test_a_setting_is_durable_by_itself(write: Write) -> None:
    toml = TOML.replace('tags = ["medication.*"]', "tags = []")
    assert told(write(situ_toml=toml)) == []


def test_parts_are_read_and_checked_too(write: Write) -> None:
    whole = APPLICATION.replace(
        "</state>", '</state><state no="2"><flow src="part.rbd.xml"/></state>'
    )
    part = '<application name="p"><state no="1"><timeout next="2">5</timeout></state></application>'
    project, problems = found_in(write(reception_rbd_xml=whole, part_rbd_xml=part))
    assert project is not None
    assert list(project.parts) == ["part.rbd.xml"]
    assert [(Path(p.file).name, p.code) for p in problems] == [("part.rbd.xml", "dangling-next")]


def test_a_state_with_a_flow_has_nothing_else(write: Write) -> None:
    whole = APPLICATION.replace(
        "</application>",
        '<state no="2"><flow src="part.rbd.xml"/><timeout>5</timeout><screen/></state>'
        "</application>",
    )
    part = '<application name="p"><state no="1"/></application>'
    found = told(write(reception_rbd_xml=whole, part_rbd_xml=part))
    assert found == [("reception.rbd.xml", "flow-with-content", 2)] * 2


def test_parts_in_a_circle_are_an_error_in_each_file_of_it(write: Write) -> None:
    whole = APPLICATION.replace("</state>", '</state><state no="2"><flow src="p.rbd.xml"/></state>')
    part = (
        '<application name="p"><state no="1"><flow src="reception.rbd.xml"/></state></application>'
    )
    assert told(write(reception_rbd_xml=whole, p_rbd_xml=part)) == [
        ("reception.rbd.xml", "circular-parts", 2),
        ("p.rbd.xml", "circular-parts", 1),
    ]


def test_the_way_that_a_circle_takes_is_told(write: Write) -> None:
    whole = APPLICATION.replace("</state>", '</state><state no="2"><flow src="p.rbd.xml"/></state>')
    part = '<application name="{}"><state no="1"><flow src="{}.rbd.xml"/></state></application>'
    _, problems = found_in(
        write(
            reception_rbd_xml=whole,
            p_rbd_xml=part.format("p", "q"),
            q_rbd_xml=part.format("q", "p"),
        )
    )
    ways = [problem.message for problem in problems if problem.code == "circular-parts"]
    assert len(ways) == 2
    assert "(p.rbd.xml → q.rbd.xml → p.rbd.xml)" in ways[0]
    assert "(q.rbd.xml → p.rbd.xml → q.rbd.xml)" in ways[1]


def test_what_a_part_uses_its_application_declares(write: Write) -> None:
    whole = APPLICATION.replace("</state>", '</state><state no="2"><flow src="p.rbd.xml"/></state>')
    part = (
        '<application name="p"><state no="1"><backgroundactions>'
        '<robot resource="base" command="stop"/></backgroundactions></state></application>'
    )
    assert told(write(reception_rbd_xml=whole, p_rbd_xml=part)) == [
        ("reception.rbd.xml", "undeclared-resource", 1)
    ]


# -- writing -------------------------------------------------------------------


def test_writing_replaces_the_whole_file_and_keeps_its_mode(tmp_path: Path) -> None:
    file = tmp_path / "a.xml"
    file.write_bytes(b"old")
    file.chmod(0o640)
    folder.write(file, b"new")
    assert file.read_bytes() == b"new"
    assert stat.S_IMODE(file.stat().st_mode) == 0o640
    assert os.listdir(tmp_path) == ["a.xml"]


def test_writing_through_a_link_keeps_the_link(tmp_path: Path) -> None:
    (tmp_path / "real.xml").write_bytes(b"old")
    link = tmp_path / "a.xml"
    link.symlink_to("real.xml")
    folder.write(link, b"new")
    assert link.is_symlink()
    assert (tmp_path / "real.xml").read_bytes() == b"new"


def test_a_failed_write_leaves_the_old_file_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "a.xml"
    file.write_bytes(b"old")

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(UsageError, match="No space left"):
        folder.write(file, b"new")
    assert file.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["a.xml"]


def test_writing_where_there_is_no_folder_is_one_line(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="cannot be written"):
        folder.write(tmp_path / "no" / "a.xml", b"new")


def test_the_sources_of_a_project_are_all_its_texts_its_parts_among_them(tmp_path: Path) -> None:
    parts = Path(__file__).parent.parent / "examples" / "parts"
    project, _ = folder.load(parts)
    assert project is not None
    found = folder.sources(project)
    assert {"situ.toml", "visit.rbd.xml", "register.rbd.xml", "confirm.rbd.xml"} <= found.keys()
    assert all(text == (parts / path).read_text("utf-8") for path, text in found.items())
    single = tmp_path / "a.rbd.xml"
    single.write_text('<application name="a"><state no="1"/></application>', "utf-8")
    project, _ = folder.load(single)
    assert project is not None
    assert folder.sources(project) == {"a.rbd.xml": single.read_text("utf-8")}


def test_what_killed_writers_left_is_cleared_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    gone, other, huge = 4_000_001, 4_000_002, 10**30

    def kill(process: int, signal: int) -> None:
        if process == gone:
            raise ProcessLookupError
        if process == other:
            raise PermissionError
        if process == huge:
            raise OverflowError

    monkeypatch.setattr(os, "kill", kill)
    (tmp_path / "texts").mkdir()
    (tmp_path / "a" / "b").mkdir(parents=True)
    left = [tmp_path / f".a.xml.{gone}.unfinished-x", tmp_path / f"texts/.ja.po.{gone}.unfinished-"]
    stay = [
        tmp_path / f".a.xml.{os.getpid()}.unfinished-x",
        tmp_path / f".a.xml.{other}.unfinished-x",
        tmp_path / ".a.xml.unfinished-x",
        tmp_path / ".a.xml.².unfinished-x",
        tmp_path / f".a.xml.{huge}.unfinished-x",
        tmp_path / f"a/b/.deep.{gone}.unfinished-x",
        tmp_path / "a.xml",
    ]
    for file in (*left, *stay):
        file.touch()
    # One that can not be taken away hinders no other.
    (tmp_path / f".folder.{gone}.unfinished-x").mkdir()
    folder.clear_unfinished(tmp_path)
    assert [file.exists() for file in left] == [False, False]
    assert all(file.exists() for file in stay)
