"""The QApplication: needs no window, so that processes beside the studio start quickly."""

from __future__ import annotations

import gc

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QIcon
from PySide6.QtWidgets import QApplication

from situ.resources import resource
from situ_studio.looks.theme import load_fonts


def application() -> QApplication:
    """The QApplication, made at the first call, with our typeface and style."""
    there = QApplication.instance()
    if isinstance(there, QApplication):
        return there
    # Fractions of the desktop's scale are taken as they are: the canvas is sharp at any.
    QGuiApplication.setHighDpiScaleFactorRoundingPolicy(
        Qt.HighDpiScaleFactorRoundingPolicy.PassThrough
    )
    made = QApplication(["situ-studio"])
    made.setApplicationName("Situ Studio")
    made.setOrganizationName("Situ")
    made.setDesktopFileName("situ-studio")
    # One style everywhere: the sheet's measures are made for it.
    made.setStyle("Fusion")
    made.setWindowIcon(QIcon(str(resource("icons", "situ.svg"))))
    load_fonts()
    # What was imported stays until the end: Python's full collections, each of which would pause
    # a window's frame for it, look at what windows made only.
    gc.freeze()
    return made
