"""What goes to a robot, and ``situ check`` and ``situ export`` on the command line."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from situ import cli
from situ.document import codec
from situ.document.aside import Aside
from situ.document.export import without_editor, write_out
from situ.document.folder import load
from situ.document.rbd import Application, State
from situ.resources import example, examples

Captured = pytest.CaptureFixture[str]

GOOD = '<application name="a"><state no="1" final="true"/></application>'
BAD = '<application name="a">\n <state no="1" nme="b"/></application>'
EDITED = """\
<application name="a" xmlns:ed="urn:situ:editor" xmlns:my="urn:mine" ed:zoom="2"><!-- why -->
<ed:frame title="x"/><state no="1" ed:x="1" my:y="2"><my:z/>
<e2:note xmlns:e2="urn:situ:editor"/><backgroundactions ed:folded="true"><speech>a</speech>
<ed:note/></backgroundactions></state></application>"""


def test_the_editors_data_is_stripped_and_nothing_else() -> None:
    document, problems = codec.read(EDITED.encode(), "a.xml")
    assert problems == []
    written = codec.write(without_editor(document)).decode()
    assert "urn:situ:editor" not in written
    assert "ed:" not in written
    assert "e2:" not in written
    assert "<!-- why -->" in written
    assert '<state no="1" my:y="2">' in written
    assert "<my:z/>" in written
    assert codec.read(written.encode(), "a.xml")[0] == document


@pytest.mark.parametrize("name", examples())
def test_an_exported_example_is_the_same_project(
    name: str, tmp_path: Path, capsys: Captured
) -> None:
    source, target = example(name), tmp_path / "new" / "out"
    assert cli.main(["export", str(source), "-o", str(target)]) == 0
    assert cli.main(["check", str(target)]) == 0
    assert capsys.readouterr().err == ""
    before, _ = load(source)
    after, _ = load(target)
    assert before is not None
    assert after is not None
    for field in ("applications", "spds", "modules", "texts", "tags", "languages"):
        assert getattr(after, field) == getattr(before, field)
    assert not any(b"urn:situ:editor" in file.read_bytes() for file in target.glob("*.xml"))
    media = {f.name for f in (source / "media").glob("*")}
    assert {f.name for f in (target / "media").glob("*")} == media
    assert not (target / "scenarios").exists()


def test_a_single_document_is_exported_with_the_media_that_it_names(tmp_path: Path) -> None:
    sound = GOOD.replace(
        '<state no="1" final="true"/>',
        '<state no="1"><backgroundactions><sound src="s/a.ogg"/></backgroundactions></state>',
    )
    (tmp_path / "a.rbd.xml").write_text(sound)
    (tmp_path / "s").mkdir()
    (tmp_path / "s" / "a.ogg").write_bytes(b"sound")
    (tmp_path / "private.txt").write_text("not named")
    out = tmp_path / "out"
    assert cli.main(["export", str(tmp_path / "a.rbd.xml"), "-o", str(out)]) == 0
    found = sorted(str(f.relative_to(out)) for f in out.rglob("*") if f.is_file())
    assert found == ["a.rbd.xml", "s/a.ogg"]


def test_media_that_services_read_go_too(tmp_path: Path) -> None:
    (tmp_path / "quiz.json").write_text("{}")
    (tmp_path / "a.rbd.xml").write_text(
        GOOD.replace(
            ' final="true"/>',
            ' final="true"><backgroundactions><service name="q" url="media:quiz.json"/>'
            "</backgroundactions></state>",
        )
    )
    assert cli.main(["export", str(tmp_path / "a.rbd.xml"), "-o", str(tmp_path / "out")]) == 0
    assert (tmp_path / "out" / "quiz.json").read_text() == "{}"


def test_a_project_whose_own_file_leads_elsewhere_is_refused(
    tmp_path: Path, capsys: Captured
) -> None:
    inside = tmp_path / "project"
    inside.mkdir()
    (tmp_path / "elsewhere.toml").write_text('[project]\napplications = ["a.rbd.xml"]\n')
    (inside / "situ.toml").symlink_to("../elsewhere.toml")
    (inside / "a.rbd.xml").write_text(GOOD)
    assert cli.main(["export", str(inside), "-o", str(tmp_path / "out")]) == 2
    assert "situ.toml: leads out of the project" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("name", "make", "told"),
    [
        ("pipe.txt", os.mkfifo, "media/pipe.txt: is no plain file (a pipe, a device)"),
        ("caf\udce9.txt", Path.touch, "its name is not UTF-8"),
    ],
)
def test_media_that_can_not_go_to_a_robot_are_refused_and_not_waited_for(
    tmp_path: Path, capsys: Captured, name: str, make: Callable[[Path], None], told: str
) -> None:
    inside = tmp_path / "project"
    (inside / "media").mkdir(parents=True)
    (inside / "situ.toml").write_text(
        '[project]\nname = "a"\nmedia = "media"\napplications = ["a.rbd.xml"]\n'
    )
    (inside / "a.rbd.xml").write_text(GOOD)
    make(inside / "media" / name)
    assert cli.main(["export", str(inside), "-o", str(tmp_path / "out")]) == 2
    assert told in capsys.readouterr().err


def test_what_the_editor_has_put_in_without_a_declaration_is_stripped() -> None:
    aside = Aside(before=("<ed:note>a</ed:note>", "<my:z/>", "<!-- why -->"))
    stripped = without_editor(Application("a", states=(State("1", aside=aside),)))
    assert stripped.states[0].aside.before == ("<my:z/>", "<!-- why -->")


def test_a_project_with_errors_is_refused_in_one_line(tmp_path: Path, capsys: Captured) -> None:
    (tmp_path / "a.rbd.xml").write_text(BAD)
    assert cli.main(["export", str(tmp_path / "a.rbd.xml"), "-o", str(tmp_path / "out")]) == 2
    shown = capsys.readouterr()
    assert "unknown-attribute" in shown.err
    assert len(shown.err.splitlines()) == 1
    assert os.listdir(tmp_path) == ["a.rbd.xml"]


def test_export_never_writes_over_anything(tmp_path: Path, capsys: Captured) -> None:
    (tmp_path / "a.rbd.xml").write_text(GOOD)
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "mine").write_text("mine")
    for name in ("full", "a.rbd.xml"):
        assert cli.main(["export", str(tmp_path / "a.rbd.xml"), "-o", str(tmp_path / name)]) == 2
        assert len(capsys.readouterr().err.splitlines()) == 1
    (tmp_path / "empty").mkdir()
    assert cli.main(["export", str(tmp_path / "a.rbd.xml"), "-o", str(tmp_path / "empty")]) == 0
    assert (tmp_path / "full" / "mine").read_text() == "mine"


# -- situ check -----------------------------------------------------------------


@pytest.mark.parametrize("name", examples())
def test_the_examples_have_no_problem(name: str, capsys: Captured) -> None:
    assert cli.main(["check", str(example(name))]) == 0
    assert capsys.readouterr() == ("", "")


def test_a_problem_is_a_line_with_its_place_and_exit_1(tmp_path: Path, capsys: Captured) -> None:
    file = tmp_path / "a.rbd.xml"
    file.write_text(BAD)
    assert cli.main(["check", str(file)]) == 1
    assert capsys.readouterr() == (
        (
            f'{file}:2:2: error unknown-attribute <state> has no attribute "nme"; '
            'did you mean "name"?\n'
        ),
        "",
    )


def test_json_is_a_list_of_objects(tmp_path: Path, capsys: Captured) -> None:
    file = tmp_path / "a.rbd.xml"
    file.write_text("<application")
    assert cli.main(["check", "--json", str(file)]) == 1
    (problem,) = json.loads(capsys.readouterr().out)
    assert list(problem) == ["file", "line", "column", "severity", "code", "message"]
    assert (problem["file"], problem["line"], problem["column"]) == (str(file), 1, 1)
    assert (problem["severity"], problem["code"]) == ("error", "malformed-xml")
    file.write_text(GOOD)
    assert cli.main(["check", "--json", str(file)]) == 0
    assert json.loads(capsys.readouterr().out) == []


def test_a_warning_alone_is_exit_0(tmp_path: Path, capsys: Captured) -> None:
    file = tmp_path / "a.spds.xml"
    file.write_text(
        '<spds name="a"><situation name="s"><condition><data tag="a" is="1"/></condition>'
        '</situation><situation name="t"/></spds>'
    )
    assert cli.main(["check", str(file)]) == 0
    assert " warning unobserved-tag " in capsys.readouterr().out


@pytest.mark.parametrize("name", ["nothing", "", "a.txt"])
def test_what_cannot_be_read_is_exit_2(name: str, tmp_path: Path, capsys: Captured) -> None:
    (tmp_path / "a.txt").write_text("a")
    assert cli.main(["check", str(tmp_path / name)]) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert len(shown.err.splitlines()) == 1


def test_several_paths_are_all_checked(tmp_path: Path, capsys: Captured) -> None:
    (tmp_path / "a.rbd.xml").write_text(BAD)
    (tmp_path / "b.rbd.xml").write_text(GOOD)
    paths = [str(tmp_path / name) for name in ("nothing", "a.rbd.xml", "b.rbd.xml", "a.rbd.xml")]
    assert cli.main(["check", *paths[1:]]) == 1
    assert len(capsys.readouterr().out.splitlines()) == 1
    assert cli.main(["check", *paths]) == 2
    assert len(capsys.readouterr().out.splitlines()) == 1


def test_files_are_called_as_the_user_called_the_project(
    tmp_path: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "p").mkdir()
    (tmp_path / "p" / "situ.toml").write_text('[project]\napplications = ["a.rbd.xml"]\n')
    (tmp_path / "p" / "a.rbd.xml").write_text(BAD)
    monkeypatch.chdir(tmp_path)
    cli.main(["check", "p"])
    assert capsys.readouterr().out.startswith(f"p{os.sep}a.rbd.xml:2:2: ")
    monkeypatch.chdir(tmp_path / "p")
    cli.main(["check", "."])
    assert capsys.readouterr().out.startswith("a.rbd.xml:2:2: ")


def test_what_can_not_be_written_whole_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="a"):
        write_out({"a": b"1", "a/b": b"2"}, tmp_path / "robot")
    assert list(tmp_path.iterdir()) == []
    write_out({"a/b": b"2"}, tmp_path / "robot")
    assert (tmp_path / "robot" / "a" / "b").read_bytes() == b"2"
