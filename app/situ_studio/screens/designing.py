"""The window's part of the screen designer: its panel at the left."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.errors import UsageError
from situ_studio.edits.edit import Place
from situ_studio.screens.devices import USUAL
from situ_studio.screens.own_templates import OwnTemplates
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.screens.designer import Designer
    from situ_studio.views.document_view import DocumentView
    from situ_studio.window.main_window import MainWindow

PANEL = "designer"
"""The dock of what can be put on a screen, and the piece of the view to which it belongs."""
VIEW = "screen"
"""The view that has that piece."""


class DesigningSide(QObject):
    """While a designer is seen, its panel stands where project, outline and palette stood."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._unfolds: bool | None = None
        """Whether what is below is unfolded again afterwards; None while no designer is seen."""
        self._templates = OwnTemplates(Path(window.settings.fileName()).parent)
        window.docks[PANEL].toggleViewAction().setVisible(False)
        window.inspector.screen_asked.connect(self.open)
        window.inspector.align_asked.connect(lambda edge: window.commands.align(edge))

    @property
    def designer(self) -> Designer | None:
        """The designer of the current document, while it is shown."""
        return _designer(self._window.current_view)

    @property
    def seen(self) -> Designer | None:
        """The same, else that of the group of tabs beside: its panel stays while one works in
        the current group.
        """
        other = self._window.sides.other
        return self.designer or (_designer(other.current_view) if other is not None else None)

    def settle(self) -> None:
        """Shows the panel of the designer that is seen, or what stood there before."""
        here, designer, stack = self.designer, self.seen, self._window.designer_stack
        self._window.inspector.look_at(here.device if here is not None else USUAL)
        if designer is None:
            self.leave()
            return
        if stack.currentWidget() is not designer.side:
            # Beside another document a template may have been kept or removed meanwhile.
            designer.use_templates(self._templates)
        if stack.indexOf(designer.side) < 0:
            stack.addWidget(designer.side)
            designer.view_asked.connect(self._show)
            designer.template_asked.connect(partial(self._keep, designer))
            designer.device_changed.connect(self._window.inspector.look_at)
        stack.setCurrentWidget(designer.side)
        if self._unfolds is None:
            # The screen gets the room; a person opens the panel again where it is wanted.
            self._unfolds = not self._window.bottom.is_folded
            self._window.bottom.set_folded(True)
            self._window.left_place.want(PANEL, True)

    def _keep(self, designer: Designer, usual: str) -> None:
        """Asks what the template shall be called."""
        title, label = self.tr("Save this screen as a template"), self.tr("Name")
        name = self._window.dialogs.name(title, label, usual)
        if name is None:
            return
        try:
            designer.keep_template(name)
        except UsageError as error:
            self._window.say(said(str(error)))

    def leave(self) -> None:
        """The panels are where they are without a designer."""
        unfolds, self._unfolds = self._unfolds, None
        if unfolds is not None:
            self._window.left_place.want(PANEL, False)
            if unfolds:
                self._window.bottom.set_folded(False)

    def open(self, place: Place) -> None:
        """Shows the screen of a state to be drawn, with what stands at the place selected."""
        self._show(VIEW, place)

    def _show(self, mode: str, place: Place) -> None:
        self._window.show_mode(mode)
        self._window.select(place)


def _designer(view: DocumentView | None) -> Designer | None:
    shown: Designer | None = None
    if view is not None and view.mode == PANEL:
        shown = view.piece(PANEL)
    return shown
