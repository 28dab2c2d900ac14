"""Pictures of a project as a screen shows them: read and scaled once while the file is the same."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QImageReader, QPixmap


class Picture(NamedTuple):
    """A file that is a picture; changed: when it was written last, in ns."""

    path: str
    changed: int

    def whole(self) -> QPixmap:
        """All its px, upright; null where the file is no picture."""
        return _read(self)

    def at(self, size: QSize) -> QPixmap:
        """It in that many px; as it is where it has fewer."""
        whole = self.whole()
        if size.isEmpty() or whole.width() <= size.width():
            return whole
        return _scaled(self, size.width(), size.height())


def picture(media: Path | None, name: str) -> Picture | None:
    """The picture ``name`` of the media folder; None where there is none."""
    if media is None or not name:
        return None
    path = media / name
    try:
        found = Picture(str(path), path.stat().st_mtime_ns)
    except (OSError, ValueError):
        return None
    return None if found.whole().isNull() else found


@lru_cache(maxsize=32)
def _read(picture: Picture) -> QPixmap:
    reader = QImageReader(picture.path)
    reader.setAutoTransform(True)
    return QPixmap.fromImageReader(reader)


@lru_cache(maxsize=64)
def _scaled(picture: Picture, width: int, height: int) -> QPixmap:
    way = Qt.TransformationMode.SmoothTransformation
    whole = picture.whole()
    return whole.scaled(width, height, Qt.AspectRatioMode.IgnoreAspectRatio, way)
