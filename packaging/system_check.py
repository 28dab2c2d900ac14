"""Says what the machine lacks for a make target, or installs it where the user is root.

``python3 packaging/system_check.py venv|demo|test`` runs before anything is installed, so
it needs only the standard library; the Makefile has found a Python that is new enough.
Exit status 0: go on; 2: one line says what is missing.
"""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
from pathlib import Path

_LIBRARIES = Path(__file__).resolve().parent.parent / "runtime" / "situ" / "system_libraries.py"

# Loaded by its path: the package beside it wants to be installed first.
_spec = importlib.util.spec_from_file_location("system_libraries", _LIBRARIES)
assert _spec is not None
assert _spec.loader is not None
system = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(system)


def main(target: str) -> int:
    """``target``: venv (only what makes the virtual environment), demo or test."""
    packages = _venv()
    headless = os.environ.get("SITU_HEADLESS") == "1" or target == "test"
    needed = system.missing(
        ()
        if target == "venv"
        else system.editor(
            x11=bool(os.environ.get("DISPLAY")) and not headless,
            wayland=bool(os.environ.get("WAYLAND_DISPLAY")) and not headless,
        )
    )
    programs = (system.BROWSER, system.SPEECH, system.BROKER, system.NETWORKS)
    wished = system.missing(programs if target == "test" else ())
    if os.environ.get("CI") == "true":
        needed, wished = needed + wished, []
    packages += [need.package for need in needed]
    if _may_install() and (packages or wished):
        _install(packages + [need.package for need in wished])
        packages = _venv() + [need.package for need in system.missing(needed)]
        wished = system.missing(wished)
    if packages:
        return _refuse(f"missing; install with: sudo apt-get install {' '.join(packages)}")
    if wished:
        names = ", ".join(need.file for need in wished)
        print(f"{names} not found: the tests that need it are skipped ({system.install(wished)})")
    return 0


def _venv() -> list[str]:
    """Debian takes venv and ensurepip out of Python, into a package of their own."""
    if importlib.util.find_spec("venv") and importlib.util.find_spec("ensurepip"):
        return []
    return [f"python{sys.version_info.major}.{sys.version_info.minor}-venv"]


def _may_install() -> bool:
    return os.geteuid() == 0 and shutil.which("apt-get") is not None


def _install(packages: list[str]) -> None:
    print(f"installing with apt-get: {' '.join(packages)}", flush=True)
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    for step in (["update"], ["install", "-y", "--no-install-recommends", *packages]):
        done = subprocess.run(
            ["apt-get", "-qq", *step], env=quiet, check=False, capture_output=True, text=True
        )
        if done.returncode:
            lines = done.stderr.strip().splitlines() or ["no reason given"]
            print(f"apt-get {step[0]}: {lines[-1]}", file=sys.stderr)


def _refuse(message: str) -> int:
    print(f"situ: {message}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else "demo"))
