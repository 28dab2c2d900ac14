"""What the machine lacks is named with the package that has it."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

from situ import cli, system_libraries
from situ.system_libraries import Need

ROOT = Path(__file__).resolve().parent.parent

ABSENT = Need("libsitu-no-such-library.so.1", "libsitu1")
NO_PROGRAM = Need("situ-no-such-program", "situ-program")
THERE = Need("libc.so.6", "libc6")


@pytest.fixture
def system_check(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """``packaging/system_check.py``, on a machine where nothing may be installed."""
    spec = importlib.util.spec_from_file_location(
        "system_check", ROOT / "packaging" / "system_check.py"
    )
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    monkeypatch.setattr(module, "_may_install", lambda: False)
    monkeypatch.delenv("CI", raising=False)
    return module


def test_only_what_is_missing_is_named() -> None:
    assert system_libraries.missing([THERE, ABSENT, NO_PROGRAM]) == [ABSENT, NO_PROGRAM]
    assert system_libraries.install([ABSENT, NO_PROGRAM]) == (
        "sudo apt-get install libsitu1 situ-program"
    )


def test_a_display_needs_more_than_none() -> None:
    offscreen = system_libraries.editor()
    assert Need("libEGL.so.1", "libegl1") in offscreen
    assert Need("libxcb-cursor.so.0", "libxcb-cursor0") not in offscreen
    assert Need("libxcb-cursor.so.0", "libxcb-cursor0") in system_libraries.editor(x11=True)


def test_the_editor_without_qt_names_the_extra(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    assert cli.main(["studio"]) == 2
    assert "pip install 'situ[studio]'" in capsys.readouterr().err


def test_the_editor_without_a_library_names_its_package(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(system_libraries, "editor", lambda **_: (THERE, ABSENT))
    assert cli.main(["studio"]) == 2
    told = capsys.readouterr().err
    assert told == (
        "situ: the editor needs libsitu-no-such-library.so.1: sudo apt-get install libsitu1\n"
    )


def test_a_make_target_without_a_library_stops_with_its_package(
    system_check: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(system_check.system, "editor", lambda **_: (THERE, ABSENT))
    assert system_check.main("demo") == 2
    assert capsys.readouterr().err == "situ: missing; install with: sudo apt-get install libsitu1\n"


def test_missing_programs_only_skip_tests_but_not_in_ci(
    system_check: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(system_check.system, "editor", lambda **_: ())
    monkeypatch.setattr(system_check.system, "BROWSER", NO_PROGRAM)
    assert system_check.main("test") == 0
    assert "situ-no-such-program not found" in capsys.readouterr().out
    monkeypatch.setenv("CI", "true")
    assert system_check.main("test") == 2


def test_a_python_without_venv_names_its_package(
    system_check: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    there = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name: None if name == "ensurepip" else there(name)
    )
    assert system_check.main("venv") == 2
    assert "-venv" in capsys.readouterr().err
