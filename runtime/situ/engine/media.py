"""The project's media folder: what the screen shows, what sounds, what services read."""

from __future__ import annotations

import re
from pathlib import Path
from urllib.parse import quote

from situ.document.project import Project

_WEB = re.compile(r"https?://", re.IGNORECASE)


class MediaFolder:
    """The folder that ``media`` names in ``situ.toml``; without one, the project's own."""

    def __init__(self, project: Project) -> None:
        self.turn_to(project)

    def turn_to(self, project: Project) -> None:
        """From here on the files of this project."""
        home = Path(project.root).resolve()
        self.root = (home / (project.media or "")).resolve()
        self._inside = self.root.is_relative_to(home)

    def find(self, path: str) -> Path | None:
        """The file at ``path`` inside the folder; None where it is missing or lies outside.

        Links are followed, so one that leads out of the folder finds nothing.
        """
        if not self._inside or not path or "\x00" in path or "\\" in path:
            return None
        try:
            file = (self.root / path).resolve()
            inside = file.is_relative_to(self.root) and file.is_file()
        except (OSError, RuntimeError):
            return None
        return file if inside else None

    @staticmethod
    def address(src: str) -> str:
        """Where a page finds a picture, movie or sound: web addresses as they are."""
        return src if _WEB.match(src) else "/media/" + quote(src.lstrip("/"), safe="/")
