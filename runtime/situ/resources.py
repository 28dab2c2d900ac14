"""Where the files that Situ ships lie: in a checkout, or in the installed package.

A checkout's own ``resources/`` and ``examples/`` come first, so that an editable
install never shows a stale copy.
"""

from __future__ import annotations

from pathlib import Path

from situ.errors import UsageError

_PACKAGE = Path(__file__).resolve().parent


def resource(*parts: str) -> Path:
    """The path of a file or folder under ``resources/``: ``resource("schema", "rbd.rng")``.

    Raises UsageError where it does not exist: the installation is incomplete.
    """
    path = _root("resources").joinpath(*parts)
    if not path.exists():
        raise UsageError(f"{path} is missing: the installation is incomplete, install situ again")
    return path


def examples() -> dict[str, Path]:
    """The shipped example projects: name to folder, sorted by name."""
    root = _root("examples")
    if not root.is_dir():
        return {}
    return {f.name: f for f in sorted(root.iterdir()) if (f / "situ.toml").is_file()}


def example(name: str) -> Path:
    """The folder of an example. Raises UsageError naming those that there are."""
    known = examples()
    if name not in known:
        raise UsageError(f"no example {name!r}; there are: {', '.join(known) or 'none'}")
    return known[name]


def tutorial(language: str = "en") -> Path:
    """The tutorial's page in a language, in English where there is none in it; its pictures lie
    in a folder beside it.

    Raises UsageError where it does not exist: the installation is incomplete.
    """
    path = _root("docs") / f"tutorial.{language}.md"
    if not path.exists():
        path = path.with_name("tutorial.md")
    if not path.exists():
        raise UsageError(f"{path} is missing: the installation is incomplete, install situ again")
    return path


def templates() -> dict[str, Path]:
    """What a new project can start from: name to folder, sorted by name."""
    return {folder.name: folder for folder in sorted(resource("templates").iterdir())}


def template(name: str) -> Path:
    """The folder of a template. Raises UsageError naming those that there are."""
    known = templates()
    if name not in known:
        raise UsageError(f"no template {name!r}; there are: {', '.join(known)}")
    return known[name]


def _root(kind: str) -> Path:
    checkout = _PACKAGE.parent.parent
    if _PACKAGE.parent.name == "runtime" and (checkout / "pyproject.toml").is_file():
        return checkout / kind
    return _PACKAGE / f"_{kind}"
