"""The file in which modules say what they need and provide, for a project that has none."""

from __future__ import annotations

from pathlib import Path

from situ.document.beside import Toml
from situ.document.folder import PROJECT_FILE
from situ.document.modules import Modules
from situ.document.project import Project
from situ.document.toml_writing import put
from situ_studio.edits.edit import Written

FILE = "modules.xml"


def can_begin(project: Project) -> bool:
    """Whether there is none yet, a project file that can name one, and no other file called so."""
    lies = (Path(project.root) / FILE).exists()
    return project.toml is not None and project.modules_file is None and not lies


def begun(toml: Toml) -> dict[str, Written]:
    """The files that change, each with what is in it then; that which stays first."""
    return {PROJECT_FILE: put(toml, "project", "modules", FILE), FILE: Modules()}
