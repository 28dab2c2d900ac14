"""Pictures kept for the next frame, so many bytes of them."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable

from PySide6.QtGui import QPixmap


class KeptPictures:
    """At most ``most`` bytes in all, or the last one alone; what was not asked for longest goes."""

    def __init__(self, most: int) -> None:
        self.bytes = 0
        self._most = most
        self._kept: OrderedDict[Hashable, QPixmap] = OrderedDict()

    def get(self, of: Hashable, make: Callable[[], QPixmap]) -> QPixmap:
        """The picture of that, made where it is not there."""
        kept = self._kept.get(of)
        if kept is not None:
            self._kept.move_to_end(of)
            return kept
        made = self._kept[of] = make()
        self.bytes += _size(made)
        while self.bytes > self._most and len(self._kept) > 1:
            _, gone = self._kept.popitem(last=False)
            self.bytes -= _size(gone)
        return made


def _size(picture: QPixmap) -> int:
    """Bytes; also what is no picture takes some."""
    return 256 + picture.width() * picture.height() * picture.depth() // 8
