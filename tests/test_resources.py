"""Shipped files: from a checkout, and from an installed wheel."""

from __future__ import annotations

import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from situ import resources
from situ.errors import UsageError

ROOT = Path(__file__).resolve().parent.parent


def test_a_checkout_shows_its_own_resources() -> None:
    assert resources.resource("icons") == ROOT / "resources" / "icons"


def test_a_missing_resource_says_what_to_do() -> None:
    with pytest.raises(UsageError, match="install situ again"):
        resources.resource("no-such-folder")


def test_an_unknown_example_names_those_there_are() -> None:
    with pytest.raises(UsageError, match="reception"):
        resources.example("no-such-example")


def test_an_installed_wheel_carries_resources_and_examples(tmp_path: Path) -> None:
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path)],
        cwd=ROOT,
        check=True,
        capture_output=True,
    )
    (wheel,) = tmp_path.glob("situ-*.whl")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path / "site")
    script = (
        "from situ.resources import resource, examples, templates, tutorial; import situ_studio;"
        "print(resource('icons')); print(*examples().values(), *templates().values(), sep='\\n');"
        "print(tutorial(), len(list(tutorial().with_suffix('').rglob('*.png'))));"
        "print(tutorial('ja').name)"
    )
    shown = subprocess.run(
        [sys.executable, "-I", "-c", f"import sys; sys.path.insert(0, 'site'); {script}"],
        cwd=tmp_path,
        check=True,
        capture_output=True,
        text=True,
    ).stdout.splitlines()
    package = tmp_path / "site" / "situ"
    assert shown[0] == str(package / "_resources" / "icons")
    pictures = len(list((ROOT / "docs" / "tutorial").rglob("*.png")))
    assert shown.pop() == "tutorial.ja.md"
    assert shown.pop() == f"{package / '_docs' / 'tutorial.md'} {pictures}"
    assert shown[1:] == [
        *(str(package / "_examples" / name) for name in resources.examples()),
        *(str(package / "_resources" / "templates" / name) for name in resources.templates()),
    ]
