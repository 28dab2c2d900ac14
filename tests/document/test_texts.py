"""``situ texts``: the files of a project's languages follow what it shows, says and hears."""

from __future__ import annotations

import json
from pathlib import Path

import msgspec
import polib
import pytest
from hypothesis import given
from hypothesis import strategies as st

from situ.cli import main
from situ.decide.inputs import Start
from situ.decide.robot import Robot
from situ.document.datatypes import shown as quoted
from situ.document.folder import load
from situ.document.project import Project
from situ.document.rbd import Application, Speech, State
from situ.document.texts import read
from situ.document.texts_shown import shown_texts
from situ.document.texts_update import Update, update
from situ.resources import example, examples

Captured = pytest.CaptureFixture[str]

TOML = '[project]\nname = "p"\napplications = ["a.rbd.xml"]\nlanguages = ["en", "ja"]\n'
DOCUMENT = """<application name="a">
<always><screen><components>
  <button id="home" x="1" y="1" width="20" height="20" event="home">Home</button>
</components></screen>
<expectedevents><event name="home" next="1"/></expectedevents></always>
<state no="1" name="hello">
  <screen><components>
    <text id="t" x="1" y="30" width="90" height="9">Hello {user.name}</text>
    <text id="n" x="1" y="40" width="90" height="9">{user.name} 7</text>
    <list id="l" x="1" y="50" width="90" height="9" items="names" label="{item.name}, room {item.room}" tag="patient" event="home"/>
    <image id="i" x="1" y="60" width="9" height="9" src="http://x/nurse.png"/>
  </components></screen>
  <backgroundactions><speech>Hello {user.name}</speech><speech lang="ja">やあ</speech>
  <speech lang="de">Hallo</speech><sound src="http://x/a.ogg"/></backgroundactions>
  <expectedevents><event name="on" next="2"><say>go on</say></event>
  <event name="off" next="2"><say>never</say></event></expectedevents>
</state>
<state no="2" name="bye"><flow src="part.rbd.xml"/>
  <expectedevents><event name="done" next="1"/></expectedevents></state>
</application>"""  # noqa: E501
PART = """<application name="part"><state no="1" final="true"><backgroundactions>
<speech>Goodbye</speech><speech>Hello {user.name}</speech><speech> </speech>
</backgroundactions></state></application>"""
TEXTS = ["Home", "Hello {user.name}", "{item.name}, room {item.room}", "go on", "never", "Goodbye"]
HEADER = 'msgid ""\nmsgstr ""\n"X-Team: us\\n"\n"Language: ja\\n"\n\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, content in (("situ.toml", TOML), ("a.rbd.xml", DOCUMENT), ("part.rbd.xml", PART)):
        (tmp_path / name).write_text(content)
    return tmp_path


def _project(folder: Path) -> Project:
    project, _ = load(folder)
    assert project is not None
    return project


def _update(folder: Path, data: str | None = None) -> tuple[Update, polib.POFile]:
    found, problems = update(
        _project(folder), "ja", None if data is None else data.encode(), "ja.po"
    )
    assert problems == []
    assert found is not None
    return found, polib.pofile(found.data.decode())


def _entry(text: str, translation: str, before: str = "") -> str:
    return f'{before}msgid "{text}"\nmsgstr "{translation}"\n\n'


def _of(project_texts: list[str]) -> Project:
    speeches = tuple(Speech(text=text) for text in project_texts)
    states = (State(no="1", actions=speeches),)
    return Project(
        root=".", name="p", applications={"a.rbd.xml": Application(name="a", states=states)}
    )


def test_every_text_shown_spoken_or_heard_has_an_entry_in_the_order_of_the_states(
    folder: Path,
) -> None:
    found, entries = _update(folder)
    assert [entry.msgid for entry in entries] == TEXTS
    assert found.new == tuple(TEXTS)
    assert (found.texts, found.translated, found.gone, found.unsure) == (6, 0, (), ())
    assert entries.metadata["Language"] == "ja"


def test_labels_and_choices_of_settings_have_entries_behind_all_others(folder: Path) -> None:
    toml = folder / "situ.toml"
    told = """
[[setting]]
tag = "voice"
label = "Voice"
type = "choice"
choices = ["soft", "Home", "1"]
"""
    toml.write_text(toml.read_text() + told)
    entries = {one.msgid: one for one in _update(folder)[1]}
    assert list(entries)[-2:] == ["Voice", "soft"]
    assert (entries["Voice"].comment, entries["Voice"].occurrences) == (
        "setting voice", [("situ.toml", "")],
    )  # fmt: skip
    assert entries["soft"].comment == "setting voice: choice"
    # What stands elsewhere, too, is one text; a number is none.
    assert entries["Home"].occurrences[-1] == ("situ.toml", "")
    assert "1" not in entries


def test_an_entry_names_its_files_and_places_but_no_lines(folder: Path) -> None:
    _, entries = _update(folder)
    assert [(entry.comment.split("\n"), entry.occurrences) for entry in entries][1:] == [
        (
            ["state 1 hello: text t", "state 1 hello: speech", "state 1: speech"],
            [("a.rbd.xml", ""), ("part.rbd.xml", "")],
        ),
        (["state 1 hello: list l"], [("a.rbd.xml", "")]),
        (["state 1 hello: phrase of on"], [("a.rbd.xml", "")]),
        (["state 1 hello: phrase of off"], [("a.rbd.xml", "")]),
        (["state 1: speech"], [("part.rbd.xml", "")]),
    ]


def test_a_state_put_in_before_changes_no_other_entry(folder: Path) -> None:
    before = _update(folder)[0].data.decode()
    more = '<state no="0"><backgroundactions><speech>Wait</speech></backgroundactions></state>\n'
    changed = DOCUMENT.replace('<state no="1"', f'{more}<state no="1"', 1)
    (folder / "a.rbd.xml").write_text(changed)
    after = _update(folder, before)[0].data.decode()
    came = '#. state 0: speech\n#: a.rbd.xml\nmsgid "Wait"\nmsgstr ""\n\n'
    assert after.replace(came, "") == before
    assert came in after


def test_what_translators_wrote_is_kept(folder: Path) -> None:
    long = "a" * 60 + " " + "b" * 60
    given = f"# Ours.\n{HEADER}" + _entry("Home", long, "# one word\n#, no-wrap\n")
    found, entries = _update(folder, given)
    home = entries[0]
    assert (home.msgstr, home.tcomment, home.flags) == (long, "one word", ["no-wrap"])
    text = found.data.decode()
    assert text.startswith(f"# Ours.\n{HEADER}")
    assert f'msgstr "{long}"\n' in text  # on one line: an edit of it is a diff of one line
    assert found.translated == 1


@pytest.mark.parametrize("end", ["\r\n", "\r"])
def test_a_file_in_which_nothing_would_change_stays_as_an_editor_laid_it_out(
    folder: Path, end: str
) -> None:
    data = _update(folder)[0].data.decode()
    other = data.replace('msgid "Goodbye"', 'msgid ""\n"Good"\n"bye"').replace("\n", end)
    found, _ = _update(folder, other)
    assert found.data == other.encode()
    assert found.new == ()


def test_what_is_gone_is_obsolete_and_comes_back_translated(folder: Path) -> None:
    zzz = _entry("Zzzzzzzzzz", "ぐう", "# snoring\n")
    found, _ = _update(folder, HEADER + zzz + _entry("Qqqqqq", ""))
    assert found.gone == ("Zzzzzzzzzz", "Qqqqqq")
    text = found.data.decode()
    assert text.endswith('# snoring\n#~ msgid "Zzzzzzzzzz"\n#~ msgstr "ぐう"\n')
    assert "Qqqqqq" not in text
    assert read(found.data, "ja.po")[0] == {}
    (folder / "part.rbd.xml").write_text(PART.replace("Goodbye", "Zzzzzzzzzz"))
    again, entries = _update(folder, text)
    assert again.new == ("Zzzzzzzzzz",)
    assert (entries[-1].obsolete, entries[-1].msgstr) == (False, "ぐう")


def test_a_new_text_takes_over_the_translation_of_one_like_it_unsure(folder: Path) -> None:
    given = HEADER + "".join(
        _entry(text, translation, before)
        for text, translation, before in (
            ("Good bye!", "さらば", ""),
            ("Goodby", "", ""),
            ("Goodbye!", "さようなら", "# to a friend\n#, fuzzy, no-wrap\n"),
            ("ebydooG", "逆", ""),
            ("Something else altogether", "別", ""),
        )
    )
    found, entries = _update(folder, given)
    goodbye = next(entry for entry in entries if entry.msgid == "Goodbye")
    assert found.unsure == ("Goodbye",)
    assert goodbye.msgstr == "さようなら"
    assert goodbye.previous_msgid == "Goodbye!"
    assert goodbye.tcomment == "to a friend"
    assert goodbye.flags == ["no-wrap", "fuzzy"]
    assert "Goodbye!" not in [entry.msgid for entry in entries]
    assert found.translated == 0


def test_the_robot_does_not_use_what_is_unsure(folder: Path) -> None:
    (folder / "texts").mkdir()
    found, _ = _update(folder, HEADER + _entry("Home!", "最初へ") + _entry("go on", "次"))
    (folder / "texts" / "ja.po").write_bytes(found.data)
    assert found.unsure == ("Home",)
    (folder / "situ.toml").write_text(f'{TOML}[tags]\nlanguage = "ja"\n')
    events, _ = Robot(_project(folder)).step(Start(), 0)
    told = [msgspec.to_builtins(event) for event in events]
    (shown,) = (event["components"] for event in told if event["kind"] == "screen")
    assert [one["text"] for one in shown if one["id"] == "home"] == ["Home"]
    (listen,) = (e["message"] for e in told if e["kind"] == "warning" and "“Home”" in e["message"])
    assert listen == "no text in ja for “Home”"


def test_a_translation_that_the_robot_uses_is_kept_though_none_is_needed(folder: Path) -> None:
    given = HEADER + _entry("{user.name} 7", "七 {user.name}") + _entry("やあ", "よう")
    found, entries = _update(folder, given + _entry("Hallo", "やあやあ"))
    kept = {entry.msgid: entry.obsolete for entry in entries if entry.msgstr}
    assert kept == {"{user.name} 7": False, "やあ": False, "Hallo": True}
    assert found.gone == ("Hallo",)


def test_of_several_entries_of_one_text_that_is_kept_which_the_robot_uses(folder: Path) -> None:
    home = [
        _entry("Home", "used"),
        _entry("Home", "unsure", "#, fuzzy\n"),
        _entry("Home", ""),
        '#~ msgid "Home"\n#~ msgstr "old"\n',
    ]
    found, entries = _update(folder, HEADER + "".join(home))
    assert [entry.msgstr for entry in entries if entry.msgid == "Home"] == ["used"]
    assert found.translated == 1


def test_plural_translations_of_other_programs_are_kept(folder: Path) -> None:
    given = HEADER + 'msgid "Zzzz"\nmsgid_plural "Zzzzs"\nmsgstr[0] "ぐう"\n'
    assert "ぐう" in _update(folder, given)[0].data.decode()


def test_a_malformed_file_is_told_and_not_touched(folder: Path) -> None:
    found, (problem,) = update(_project(folder), "ja", b"nonsense\nhere", "texts/ja.po")
    assert found is None
    assert (problem.file, problem.line, problem.code) == ("texts/ja.po", 1, "malformed-po")


# What XML may hold, and what other programs take for the end of a line.
CHARACTERS = st.characters(codec="utf-8", exclude_categories=["Cc"]) | st.sampled_from("\n\r\t\x85")
TEXT = st.text(CHARACTERS, min_size=1, max_size=12)


@given(
    st.lists(TEXT, max_size=6),
    st.lists(TEXT, max_size=6),
    st.dictionaries(TEXT, TEXT, max_size=6),
)
def test_translations_survive_and_a_second_update_changes_nothing(
    texts: list[str], later: list[str], translations: dict[str, str]
) -> None:
    first, _ = update(_of(texts), "ja", None, "ja.po")
    assert first is not None
    entries = polib.pofile(first.data.decode(), wrapwidth=0)
    for entry in entries:
        entry.msgstr = translations.get(entry.msgid, "")
    given = str(entries).encode()
    known = read(given, "ja.po")[0]
    # By way of others, in which all of them may be gone, and back.
    away, _ = update(_of(later), "ja", given, "ja.po")
    assert away is not None
    assert read(away.data, "ja.po")[0] == {t: s for t, s in known.items() if t in later}
    again, _ = update(_of(later), "ja", away.data, "ja.po")
    assert again is not None
    assert again.data == away.data
    assert (again.new, again.gone) == ((), ())


@pytest.mark.parametrize("name", examples())
def test_the_files_of_an_example_are_up_to_date(name: str) -> None:
    assert main(["texts", str(example(name)), "--check"]) == 0


def test_a_text_that_check_misses_is_one_that_situ_texts_puts_in(
    folder: Path, capsys: Captured
) -> None:
    assert main(["texts", str(folder)]) == 0
    project = _project(folder)
    every = [t for a in (*project.applications.values(), *project.parts.values())
             for t in shown_texts(a)]  # fmt: skip
    asked = {one.text for one in every if one.is_to_translate}
    capsys.readouterr()
    main(["check", str(folder), "--json"])
    missing = [p for p in json.loads(capsys.readouterr().out) if p["code"] == "missing-text"]
    told = {text for text in asked for p in missing if f" {quoted(text)}:" in p["message"]}
    assert told == asked == set(TEXTS)


def test_the_command_makes_the_files_that_languages_name(folder: Path, capsys: Captured) -> None:
    file = folder / "texts" / "ja.po"
    assert main(["texts", str(folder), "--check"]) == 1
    assert not file.exists()
    assert capsys.readouterr().out == f"{file}: 6 texts, 0 translated; 6 new, 0 gone; not written\n"
    assert main(["texts", str(folder)]) == 0
    assert main(["texts", str(folder), "--check"]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == f"{file}: 6 texts, 0 translated; up to date"
    # The first language is the one in which the texts are written.
    assert sorted(folder.glob("texts/*")) == [file]


def test_the_command_tells_what_is_unsure_and_what_only_moved(
    folder: Path, capsys: Captured
) -> None:
    main(["texts", str(folder)])
    file = folder / "texts" / "ja.po"
    file.write_text(file.read_text().replace('"Home"\nmsgstr ""', '"Home"\nmsgstr "最初へ"'))
    (folder / "a.rbd.xml").write_text(DOCUMENT.replace(">Home<", ">Home!<"))
    capsys.readouterr()
    main(["texts", str(folder)])
    assert "; 1 new (1 to be looked at), 1 gone\n" in capsys.readouterr().out
    (folder / "a.rbd.xml").write_text(
        DOCUMENT.replace(">Home<", ">Home!<").replace('"home" x', '"h" x')
    )
    main(["texts", str(folder)])
    assert capsys.readouterr().out.endswith("; places changed\n")


def test_the_answer_as_json(folder: Path, capsys: Captured) -> None:
    assert main(["texts", str(folder), "--json", "--check"]) == 1
    (found,) = json.loads(capsys.readouterr().out)
    assert found == {
        "language": "ja",
        "file": str(folder / "texts" / "ja.po"),
        "changed": True,
        "new": TEXTS,
        "unsure": [],
        "gone": [],
        "texts": 6,
        "translated": 0,
    }


def test_a_file_of_the_first_language_is_kept_up_to_date_where_there_is_one(folder: Path) -> None:
    (folder / "texts").mkdir()
    (folder / "texts" / "en.po").write_text(HEADER)
    assert main(["texts", str(folder)]) == 0
    assert len(polib.pofile(str(folder / "texts" / "en.po"))) == 6


@pytest.mark.parametrize(
    ("file", "content", "words"),
    [
        ("texts/ja.po", 'msgid "a"\nmgsstr "b"\n', "ja.po:2:1: error malformed-po"),
        ("part.rbd.xml", "<application", "part.rbd.xml:1:"),
    ],
)
def test_what_can_not_be_read_is_one_line_and_nothing_is_written(
    folder: Path, file: str, content: str, words: str, capsys: Captured
) -> None:
    (folder / "texts").mkdir()
    (folder / file).write_text(content)
    assert main(["texts", str(folder)]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert words in line
    assert (folder / file).read_text() == content
    assert len(list(folder.glob("texts/*"))) == (file == "texts/ja.po")


def test_languages_are_named_in_situ_toml(folder: Path, capsys: Captured) -> None:
    assert main(["texts", str(folder / "a.rbd.xml")]) == 2
    assert "give the project, whose situ.toml names its languages" in capsys.readouterr().err
    (folder / "situ.toml").write_text(TOML.replace(', "ja"', ""))
    assert main(["texts", str(folder), "--check"]) == 0
    assert "one language only; name others in languages of situ.toml" in capsys.readouterr().out
