"""What the machine itself must have: libraries and programs, and the Debian package of each.

Imports only the standard library, and nothing of Situ: ``packaging/system_check.py``
loads this file before anything is installed.
"""

from __future__ import annotations

import ctypes
import os
import shutil
from collections.abc import Iterable
from typing import NamedTuple

PATH = os.environ.get("PATH", os.defpath) + ":/usr/sbin"
"""Where programs are looked for: Debian has servers where people's shells do not look."""


class Need(NamedTuple):
    """A shared library (``libEGL.so.1``) or a program, and the package that has it."""

    file: str
    package: str

    def met(self) -> bool:
        """Whether the library can be loaded, or the program is in the path."""
        if ".so." not in self.file:
            return shutil.which(self.file, path=PATH) is not None
        try:
            ctypes.CDLL(self.file)
        except OSError:
            return False
        return True


# What the wheels of PySide6 take from the system (as ldd shows for Qt's libraries and plugins).
_QT = (
    Need("libEGL.so.1", "libegl1"),
    Need("libGL.so.1", "libgl1"),
    Need("libX11.so.6", "libx11-6"),
    Need("libxkbcommon.so.0", "libxkbcommon0"),
    Need("libdbus-1.so.3", "libdbus-1-3"),
    Need("libfontconfig.so.1", "libfontconfig1"),
    Need("libfreetype.so.6", "libfreetype6"),
    Need("libglib-2.0.so.0", "libglib2.0-0"),
)
_X11 = (
    Need("libX11-xcb.so.1", "libx11-xcb1"),
    Need("libxkbcommon-x11.so.0", "libxkbcommon-x11-0"),
    Need("libxcb-cursor.so.0", "libxcb-cursor0"),
    Need("libxcb-icccm.so.4", "libxcb-icccm4"),
    Need("libxcb-image.so.0", "libxcb-image0"),
    Need("libxcb-keysyms.so.1", "libxcb-keysyms1"),
    Need("libxcb-randr.so.0", "libxcb-randr0"),
    Need("libxcb-render.so.0", "libxcb-render0"),
    Need("libxcb-render-util.so.0", "libxcb-render-util0"),
    Need("libxcb-shape.so.0", "libxcb-shape0"),
    Need("libxcb-shm.so.0", "libxcb-shm0"),
    Need("libxcb-sync.so.1", "libxcb-sync1"),
    Need("libxcb-util.so.1", "libxcb-util1"),
    Need("libxcb-xfixes.so.0", "libxcb-xfixes0"),
    Need("libxcb-xkb.so.1", "libxcb-xkb1"),
)
_WAYLAND = (
    Need("libwayland-client.so.0", "libwayland-client0"),
    Need("libwayland-cursor.so.0", "libwayland-cursor0"),
)

SPEECH = Need("espeak-ng", "espeak-ng")
BROWSER = Need("chromium", "chromium")
BROKER = Need("mosquitto", "mosquitto")
NETWORKS = Need("ip", "iproute2")


def editor(*, x11: bool = False, wayland: bool = False) -> tuple[Need, ...]:
    """What the editor needs: offscreen, and more where it opens a window on a display."""
    return _QT + (_X11 if x11 else ()) + (_WAYLAND if wayland else ())


def missing(needs: Iterable[Need]) -> list[Need]:
    """Those of ``needs`` that this machine lacks, in their order."""
    return [need for need in needs if not need.met()]


def install(needs: Iterable[Need]) -> str:
    """The command that installs them on Debian and Ubuntu."""
    return "sudo apt-get install " + " ".join(dict.fromkeys(need.package for need in needs))
