"""Where the studio finds its icons, fonts and other files."""

from __future__ import annotations

from pathlib import Path


def resource(name: str) -> Path:
    """The path of ``resources/<name>``: the checkout's if this is one, else the package's.

    Raises FileNotFoundError naming the file that is missing.
    """
    here = Path(__file__).resolve()
    for base in (here.parents[2] / "resources", here.parents[1] / "situ" / "resources"):
        found = base / name
        if found.exists():
            return found
    raise FileNotFoundError(f"{name} is missing from Situ's resources; install Situ again")
