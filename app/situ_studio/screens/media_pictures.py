"""Pictures of a project as a screen shows them: read and scaled once while the file is the same."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QImageReader, QPixmap

from situ_studio.screens.kept_pictures import KeptPictures

MOST = 128 * 2**20
"""Bytes of pictures that are kept: some photographs as they are, and all of a screen scaled."""


class Picture(NamedTuple):
    """A file that is a picture; changed: when it was written last, in ns."""

    path: str
    changed: int

    def whole(self) -> QPixmap:
        """All its px, upright; null where the file is no picture."""
        return _kept.get(self, lambda: _read(self))

    def at(self, size: QSize) -> QPixmap:
        """It in that many px; as it is where it has fewer."""
        whole = self.whole()
        if size.isEmpty() or whole.width() <= size.width():
            return whole
        of = (self, size.width(), size.height())
        return _kept.get(of, lambda: _scaled(whole, size))


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


_kept = KeptPictures(MOST)


def _read(picture: Picture) -> QPixmap:
    reader = QImageReader(picture.path)
    reader.setAutoTransform(True)
    return QPixmap.fromImageReader(reader)


def _scaled(whole: QPixmap, size: QSize) -> QPixmap:
    way = Qt.TransformationMode.SmoothTransformation
    return whole.scaled(size, Qt.AspectRatioMode.IgnoreAspectRatio, way)
