"""Qt's print preview, whose buttons can be reached by Tab, and whose fields have names."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible
from PySide6.QtPrintSupport import QPrintPreviewDialog, QPrintPreviewWidget
from PySide6.QtWidgets import QComboBox, QGraphicsView, QLineEdit, QToolButton

from situ_studio.assistive.heard_as import hear_as
from situ_studio.widgets.named_box import label_unseen
from situ_studio.wording.language import tr

EXTENSION = "qt_toolbar_ext_button"
"""Of a toolbar that has not room for all."""


def reach_by_keys(dialog: QPrintPreviewDialog) -> None:
    """Before it is shown."""
    for button in dialog.findChildren(QToolButton):
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        if button.objectName() == EXTENSION:
            button.setAccessibleName(tr("More"))
    for shown in dialog.findChildren(QPrintPreviewWidget):
        for pages in shown.findChildren(QGraphicsView):
            pages.setAccessibleName(tr("Pages"))
            hear_as(pages, QAccessible.Role.Canvas)
            shown.setFocusProxy(pages)
    for size in dialog.findChildren(QComboBox):
        size.setAccessibleName(tr("Size"))
        label_unseen(size, tr("Size"))
    for page in dialog.findChildren(QLineEdit):
        if not isinstance(page.parentWidget(), QComboBox):
            page.setAccessibleName(tr("Page"))
