"""The shape of the repository is fixed, so that everybody finds their way (architecture)."""

from __future__ import annotations

import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

TOP = {
    ".ci", ".gitignore", ".pre-commit-config.yaml", "CHANGELOG.md", "LICENSE", "Makefile",
    "README.md", "app", "constraints.txt", "docs", "examples", "packaging", "pyproject.toml",
    "resources", "runtime", "tests",
}  # fmt: skip
DRAWERS = {"utils", "util", "helpers", "helper", "misc", "common", "manager", "managers"}


def tracked() -> list[Path]:
    listed = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True
    )
    return [Path(name) for name in listed.stdout.split("\0") if name]


def test_the_top_level_is_fixed() -> None:
    assert {path.parts[0] for path in tracked()} == TOP


def test_no_drawers() -> None:
    assert not [path for path in tracked() if {part.split(".")[0] for part in path.parts} & DRAWERS]


def test_the_constraints_pin_every_dependency_and_name_no_index() -> None:
    lines = (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
    pins = [line for line in lines if line and not line.startswith("#")]
    assert all("==" in pin and "://" not in pin and "/" not in pin for pin in pins)
    assert pins == sorted(pins, key=str.lower)
