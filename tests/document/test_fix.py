"""``situ check --fix``: what it mends, what it leaves, and that nothing is ever lost by it."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from situ import cli
from situ.document import fix as fixing
from situ.document.check import check
from situ.document.fix import fix
from situ.document.problem import Problem
from situ.document.project import Project

SCRIPT = """\
<spds name="ward" xmlns:ed="urn:situ:editor">
  <observe>
    <!-- the camera -->
    <data tag="face.visible"/>
    <data tag="face.visible"/>
  </observe>
  <modules>
    <module name="greeter" resources="head head"/>
    <module name="greeter" resources="head"/>
  </modules>
  <situation name="visit" ed:x="10" ed:y="20.5">
    <condition>
      <data tag="face.visible" is="true"/>
    </condition>
    <module name="greeter" priority="1"/>
    <module name="greeter" priority="1"/>
  </situation>
  <situation name="day"/>
</spds>
"""
MENDED = """\
<?xml version="1.0" encoding="UTF-8"?>
<spds name="ward" xmlns:ed="urn:situ:editor">
  <observe>
    <!-- the camera -->
    <data tag="face.visible"/>
  </observe>
  <modules>
    <module name="greeter" resources="head"/>
  </modules>
  <situation name="visit" ed:x="10" ed:y="20.5">
    <condition>
      <data tag="face.visible" is="true"/>
    </condition>
    <module name="greeter" priority="1"/>
  </situation>
  <situation name="day"/>
</spds>
"""
APPLICATION = """\
<application   name="reception">
  <state no="1">
    <timeout next="7">5</timeout>
  </state>
</application>
"""


@pytest.fixture
def ward(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project with safe mends in its script and an error in its application."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "situ.toml").write_text(
        '[project]\napplications = ["a.rbd.xml"]\nspds = "w.spds.xml"\n'
    )
    (tmp_path / "w.spds.xml").write_text(SCRIPT)
    (tmp_path / "a.rbd.xml").write_text(APPLICATION)
    return tmp_path


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    status = cli.main(["check", *arguments])
    captured = capsys.readouterr()
    return status, captured.out, captured.err


def test_what_is_safe_is_mended_and_written_and_the_rest_is_left(
    ward: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    status, out, err = run(capsys, "--fix", ".")
    assert (ward / "w.spds.xml").read_text() == MENDED
    lines = out.splitlines()
    mended = [line for line in lines if " mended " in line]
    assert "w.spds.xml:5:5: mended double-data Take this one out" in mended
    assert len(mended) == 4
    assert lines[: len(mended)] == mended
    assert any(line.startswith("a.rbd.xml:3:5: error dangling-next ") for line in lines)
    assert (status, err) == (1, "")


def test_a_mend_that_makes_room_for_another_is_followed_by_it(ward: Path) -> None:
    # "head head" is no longer another declaration once it says "head".
    done = [problem.code for problem in fix(ward).mended]
    assert sorted(done) == ["bad-value", "double-data", "double-module", "double-module"]


def test_mends_that_make_room_for_ever_new_ones_come_to_an_end(
    ward: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(fixing, "ROUNDS", 1)
    first = fix(ward)
    assert len(first.mended) == 3
    assert len(fix(ward).mended) == 1
    assert fix(ward).mended == []


def test_a_second_run_changes_nothing(ward: Path) -> None:
    first = fix(ward)
    before = {path: (path.read_bytes(), path.stat().st_mtime_ns) for path in ward.iterdir()}
    second = fix(ward)
    assert second.mended == []
    assert second.left == first.left
    assert before == {p: (p.read_bytes(), p.stat().st_mtime_ns) for p in ward.iterdir()}


def test_a_file_without_a_mend_is_not_written_though_it_is_not_canonical(ward: Path) -> None:
    fix(ward)
    assert (ward / "a.rbd.xml").read_text() == APPLICATION


def test_without_the_option_nothing_is_written(
    ward: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run(capsys, ".")
    assert (ward / "w.spds.xml").read_text() == SCRIPT


def test_a_file_that_could_not_be_read_wholly_is_left_as_it_is(ward: Path) -> None:
    damaged = SCRIPT.replace('<situation name="day"/>', '<situation name="day" nonsense="1"/>')
    (ward / "w.spds.xml").write_text(damaged)
    found = fix(ward)
    assert found.mended == []
    assert "unknown-attribute" in {problem.code for problem in found.left}
    assert (ward / "w.spds.xml").read_text() == damaged


def test_a_project_that_cannot_be_read_is_told_like_without_the_option(
    ward: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (ward / "situ.toml").write_text("[project\n")
    status, out, _ = run(capsys, "--fix", ".")
    assert status == 1
    assert "malformed-toml" in out


def test_a_read_only_file_is_one_line_and_stays(
    ward: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    os.chmod(ward / "w.spds.xml", 0o444)
    status, out, err = run(capsys, "--fix", ".")
    assert status == 2
    (line,) = err.splitlines()
    assert line.startswith("situ: w.spds.xml: is read-only: ")
    assert " mended " not in out
    assert " double-data " in out
    assert (ward / "w.spds.xml").read_text() == SCRIPT
    assert not list(ward.glob(".*"))


@pytest.mark.parametrize("now", [SCRIPT.replace("the camera", "the other camera"), None])
def test_a_file_that_changed_meanwhile_is_one_line_and_stays(
    ward: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    now: str | None,
) -> None:
    def check_slowly(project: Project) -> list[Problem]:
        """While the project is searched somebody else saves, or removes, the file."""
        if now is None:
            (ward / "w.spds.xml").unlink(missing_ok=True)
        else:
            (ward / "w.spds.xml").write_text(now)
        return check(project)

    monkeypatch.setattr(fixing, "check", check_slowly)
    status, out, err = run(capsys, "--fix", ".")
    assert status == 2
    assert "w.spds.xml: changed while it was being mended" in err
    assert " mended " not in out
    assert ((ward / "w.spds.xml").read_text() if now else None) == now


def test_a_write_that_fails_leaves_the_old_file(
    ward: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    status, _, err = run(capsys, "--fix", ".")
    assert status == 2
    assert "No space left on device" in err
    assert (ward / "w.spds.xml").read_text() == SCRIPT
    assert not list(ward.glob(".*"))


def test_json_tells_what_was_mended_and_what_is_left(
    ward: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    _, out, _ = run(capsys, "--fix", "--json", ".")
    told = json.loads(out)
    keys = ["file", "line", "column", "severity", "code", "message", "mended"]
    assert all(list(one) == keys for one in told)
    assert {one["code"] for one in told if one["mended"]} == {
        "bad-value",
        "double-data",
        "double-module",
    }
    assert "dangling-next" in {one["code"] for one in told if not one["mended"]}
    _, out, _ = run(capsys, "--json", ".")
    assert all(list(one) == keys[:-1] for one in json.loads(out))


def test_a_single_file_is_mended_too(ward: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, out, _ = run(capsys, "--fix", "w.spds.xml")
    assert status == 0
    assert (ward / "w.spds.xml").read_text() == MENDED
    assert "w.spds.xml:5:5: mended double-data" in out
