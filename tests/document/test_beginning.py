"""``situ new``: what a new project starts from is whole, clean and tested."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from situ.cli import main
from situ.document import codec
from situ.document.beginning import PLACEHOLDER, begin, languages, project_name
from situ.document.check import check
from situ.document.folder import load
from situ.document.texts_shown import has_words
from situ.document.texts_table import rows
from situ.errors import UsageError
from situ.resources import template, templates

Captured = pytest.CaptureFixture[str]


def test_there_are_templates() -> None:
    assert list(templates()) == ["conversation", "empty", "menu", "reception", "reminder"]


@pytest.mark.parametrize("language", ["en", "ja"])
@pytest.mark.parametrize("name", ["my-robot", "conversation", "sound", "hello"])
@pytest.mark.parametrize("kind", templates())
def test_a_new_project_has_no_warning_and_its_scenarios_pass(
    kind: str, name: str, language: str, tmp_path: Path, capsys: Captured
) -> None:
    target = tmp_path / "new" / name
    assert main(["new", str(target), "--template", kind, "--language", language]) == 0
    assert capsys.readouterr() == (
        f"{target}: made from the template {kind}; now: situ studio {target}\n",
        "",
    )
    project, problems = load(target)
    assert project is not None
    assert [str(problem) for problem in (*problems, *check(project))] == []
    assert project.name == name
    assert project.languages == (language,)
    assert [one.name for one in project.applications.values()] == [name]
    assert list(project.applications) == [f"{name}.rbd.xml"]
    assert main(["test", str(target)]) == 0
    told = capsys.readouterr().out
    assert "100 %" in told
    assert re.findall(r"\d+ of \d+ \((?!100 %)", told) == []
    for scenario in sorted(target.glob("scenarios/*.jsonl")):
        assert main(["simulate", str(target), "--script", str(scenario)]) == 0
    assert not [one for one in target.rglob("*") if PLACEHOLDER in one.name]


@pytest.mark.parametrize("kind", templates())
def test_begun_in_another_language_nothing_is_left_of_english(kind: str, tmp_path: Path) -> None:
    target = tmp_path / "robot"
    assert languages(template(kind)) == ["en", "ja"]
    begin(template(kind), target, "robot", "ja")
    project, _ = load(target)
    assert project is not None
    (application,) = project.applications.values()
    said = [row.text for row in rows(project) if has_words(row.text)]
    notes = re.findall(r"<!--.*?-->", "".join(f.read_text() for f in target.glob("*.xml")))
    described = (
        [one.description or "" for one in project.modules.modules] if project.modules else []
    )
    named = [one.name or "" for one in application.states]
    named += [one.name for one in project.spds.situations] if project.spds else []
    for text in (*said, *notes, *described, *named):
        assert re.search("[ぁ-んァ-ヶ一-龯]", text), text
    assert not (target / "texts").exists()
    assert {file.name for file in target.iterdir()} == {
        file.name.replace(PLACEHOLDER, "robot") for file in template(kind).iterdir()
    } - {"texts"}


@pytest.mark.parametrize("language", ["en", "ja"])
def test_the_media_of_a_template_come_along_as_they_are(tmp_path: Path, language: str) -> None:
    whole, picture = tmp_path / "whole", b"\x89PNG\r\n\x1a\n\xff\xfe"
    shutil.copytree(template("empty"), whole)
    (whole / "media").mkdir()
    (whole / "media" / "robot.png").write_bytes(picture)
    begin(whole, tmp_path / "robot", "robot", language)
    assert (tmp_path / "robot" / "media" / "robot.png").read_bytes() == picture


def test_a_language_that_a_template_does_not_have_is_refused_with_those_it_has(
    tmp_path: Path, capsys: Captured
) -> None:
    assert main(["new", str(tmp_path / "a"), "--language", "fr"]) == 2
    said = "situ: this template has no texts in 'fr'; it has them in: en, ja\n"
    assert capsys.readouterr().err == said
    assert list(tmp_path.iterdir()) == []
    broken = tmp_path / "broken"
    shutil.copytree(template("empty"), broken)
    (broken / "texts" / "ja.po").write_text("nothing of this kind\n")
    with pytest.raises(UsageError, match=r"texts/ja\.po:1"):
        begin(broken, tmp_path / "a", "a", "ja")
    assert [one.name for one in tmp_path.iterdir()] == ["broken"]


@pytest.mark.parametrize("kind", templates())
def test_the_documents_of_a_template_are_canonical(kind: str) -> None:
    files = sorted(template(kind).glob("*.xml"))
    assert files
    for file in files:
        document, _ = codec.read(file.read_bytes(), str(file))
        assert document is not None
        assert codec.write(document) == file.read_bytes(), file


def test_without_a_template_it_is_the_empty_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "Robot nurse 2"
    folder.mkdir()
    monkeypatch.chdir(folder)
    assert main(["new", "."]) == 0
    assert sorted(os.listdir()) == ["robot-nurse-2.rbd.xml", "scenarios", "situ.toml"]
    assert os.listdir(tmp_path) == ["Robot nurse 2"]


def test_an_unknown_template_names_those_there_are(tmp_path: Path, capsys: Captured) -> None:
    assert main(["new", str(tmp_path / "a"), "--template", "recepton"]) == 2
    said = (
        "situ: no template 'recepton'; there are: conversation, empty, menu, reception, reminder\n"
    )
    assert capsys.readouterr().err == said
    assert not (tmp_path / "a").exists()


@pytest.mark.parametrize("is_file", [True, False])
def test_what_is_there_is_not_touched(tmp_path: Path, is_file: bool, capsys: Captured) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "b").write_text("mine")
    target = tmp_path / "a" / "b" if is_file else tmp_path / "a"
    assert main(["new", str(target)]) == 2
    said = f"situ: {target}: is there already and not empty; name a new folder\n"
    assert capsys.readouterr().err == said
    assert [one.name for one in tmp_path.rglob("*")] == ["a", "b"]
    assert (tmp_path / "a" / "b").read_text() == "mine"


@pytest.mark.parametrize("name", ["受付", "-", "42"])
def test_a_folder_whose_name_is_none_for_an_application_is_refused(
    name: str, tmp_path: Path, capsys: Captured
) -> None:
    assert main(["new", str(tmp_path / name)]) == 2
    assert "is no name for a project: use small letters" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_project_is_not_called_like_a_module_of_its_template(
    tmp_path: Path, capsys: Captured
) -> None:
    target = str(tmp_path / "follow-face")
    assert main(["new", target, "--template", "conversation"]) == 2
    assert "follow-face is a module of this template" in capsys.readouterr().err
    assert main(["new", target]) == 0


def test_a_folder_that_can_not_be_made_is_one_line_and_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(UsageError, match="can not be made"):
        begin(template("empty"), tmp_path / "file" / "a", "a")
    broken = tmp_path / "broken"
    (broken / "situ.toml").parent.mkdir()
    (broken / "situ.toml").write_text("[project]\napplications = []\n")
    (broken / ("x" * 200 + PLACEHOLDER)).write_text("")
    with pytest.raises(UsageError, match="can not be made"):
        begin(broken, tmp_path / "a", "a" * 100)
    assert sorted(one.name for one in tmp_path.iterdir()) == ["broken", "file"]


@given(st.text(max_size=20))
def test_a_projects_name_is_a_name_or_what_was_typed(title: str) -> None:
    made = project_name(title)
    assert made == title or re.fullmatch(r"[a-z][a-z0-9_-]*", made)
    assert project_name(made) == made
