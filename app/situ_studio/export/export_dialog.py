"""What of a drawing goes into a picture, and how large a PNG becomes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Literal

from msgspec import Struct
from PySide6.QtCore import QRectF
from PySide6.QtWidgets import (
    QDialog,
    QFormLayout,
    QLabel,
    QVBoxLayout,
)

from situ_studio.export import picture
from situ_studio.panels.fields import Choice
from situ_studio.panels.stepped import Stepped
from situ_studio.widgets.dialog_buttons import add_buttons

if TYPE_CHECKING:
    from situ_studio.window.frame import Frame

What = Literal["whole", "selection", "seen"]


class Export(Struct, frozen=True):
    """A person's choice. scale: px of a PNG for one of the drawing."""

    what: What
    scale: float


class ExportDialog(QDialog):
    """Asks what of a drawing is wanted. ``chosen``: the answer as it stands.

    name: of the file; only of a PNG is the scale asked. areas: of what can be chosen, in px of
    the drawing, in the order in which it is offered.
    """

    def __init__(self, name: str, areas: Mapping[What, QRectF], parent: Frame) -> None:
        super().__init__(parent)
        self._areas = areas
        words = {
            "whole": self.tr("Everything"),
            "selection": self.tr("The selection"),
            "seen": self.tr("What is seen"),
        }
        self._pixels = picture.format_of(name) == "png"
        self.setWindowTitle(self.tr("Export {0}").format(name))
        column = QVBoxLayout(self)
        form = QFormLayout()
        self.what = Choice(parent.theme)
        self.what.setSizeAdjustPolicy(Choice.SizeAdjustPolicy.AdjustToContents)
        for what in areas:
            self.what.addItem(words[what], what)
        form.addRow(self.tr("Of the drawing"), self.what)
        self.scale = Stepped()
        self.scale.setRange(25, 800)
        self.scale.setSingleStep(25)
        self.scale.setSuffix(" %")
        self.scale.setValue(round(100 * picture.SCALE))
        self.size_ = QLabel()
        if self._pixels:
            form.addRow(self.tr("Scale"), self.scale)
            form.addRow(self.tr("Size"), self.size_)
        column.addLayout(form)
        self.export = add_buttons(self, column, self.tr("Export"), self.accept)
        self.what.currentIndexChanged.connect(self._settle)
        self.scale.valueChanged.connect(self._settle)
        self._settle()

    @property
    def chosen(self) -> Export:
        return Export(self.what.currentData(), self.scale.value() / 100)

    def _settle(self) -> None:
        """How large it becomes, and whether that is not too large."""
        if not self._pixels:
            return
        wide, high = picture.pixels(self._areas[self.chosen.what], self.chosen.scale)
        fits = wide * high <= picture.MOST_PIXELS
        text = self.tr("{0} × {1} px") if fits else self.tr("{0} × {1} px: too large")
        self.size_.setText(text.format(wide, high))
        self.export.setEnabled(fits)
