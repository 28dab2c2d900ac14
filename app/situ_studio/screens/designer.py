"""The screen designer: one state's screen in the whole middle, to scale, in its device.

It is the piece ``designer`` of the view *Screen* (``situ_studio.views.table``). What is at the
left of it, ``side``, the window shows in a panel of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QBuffer, QIODevice, QPoint, Qt, Signal
from PySide6.QtGui import QGuiApplication, QImage, QImageWriter, QKeyEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from situ.document import rbd
from situ.document.names import is_reserved, is_tag
from situ.document.problem import Problem
from situ.document.project import Project
from situ.errors import UsageError
from situ_studio.edits import places, words
from situ_studio.edits.edit import Place
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.screens import media_import, templates
from situ_studio.screens.designer_bar import DesignerBar
from situ_studio.screens.designer_sheet import DesignerSheet, files_in
from situ_studio.screens.designer_side import DesignerSide
from situ_studio.screens.device_ground import DeviceGround
from situ_studio.screens.devices import USUAL, Device
from situ_studio.screens.guiding import Guiding
from situ_studio.screens.layers import BACKGROUND
from situ_studio.screens.own_device import ask_device
from situ_studio.screens.own_templates import OwnTemplates
from situ_studio.screens.preview_window import PreviewWindow
from situ_studio.screens.rulers import WIDE
from situ_studio.screens.sampling import Sampling
from situ_studio.screens.state_screen import StateScreen
from situ_studio.screens.strip import StateStrip
from situ_studio.screens.walk import Walk
from situ_studio.widgets.breadcrumbs import Breadcrumbs
from situ_studio.widgets.layouts import rule
from situ_studio.wording.language import said

SAY = ("text", "button")
"""Components whose words come first."""


class Designer(QWidget):
    """project: as it is at the time of the call. The device and the sample values belong to this
    widget: they are no part of a document.
    """

    edited = Signal(object, str)
    selection_changed = Signal(tuple)
    status = Signal(str)
    filled_in = Signal(tuple)
    media_asked = Signal(tuple, str, object)
    file_asked = Signal(tuple, str, QPoint)
    menu_requested = Signal(tuple, QPoint)
    device_changed = Signal(object)
    """Another device is looked at."""
    template_asked = Signal(str)
    """The screen shall be kept as a template; the name that is proposed."""
    view_asked = Signal(str, tuple)
    """Another view of the document is wanted, at a place."""

    def __init__(
        self,
        theme: Theme,
        project: Callable[[], Project | None],
        media: Callable[[], Path | None],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setAccessibleName(self.tr("Screen designer"))
        self._theme = theme
        self._project = project
        self.device = USUAL
        self._own: OwnTemplates | None = None
        self.side = DesignerSide(theme, self)
        self.side.hide()
        self.destroyed.connect(self.side.deleteLater)
        self.bar = DesignerBar(theme)
        self.sheet = DesignerSheet(theme)
        self.setFocusProxy(self.sheet)
        self.ground = DeviceGround(theme, self.sheet)
        self.strip = StateStrip(theme, media)
        self.guiding = Guiding(self.sheet, self.ground, theme)
        self.shown = StateScreen(self.sheet, theme, media, self)
        self.sampling = Sampling(self.bar, theme, project, self)
        self.crumbs = _BareCrumbs(theme, self.ground)
        self.crumbs.setAccessibleName(self.tr("Where you are"))
        over = QVBoxLayout(self.ground)
        over.setContentsMargins(px(WIDE), px(WIDE), 0, 0)
        over.addWidget(self.crumbs)
        over.addStretch(1)
        self.preview: PreviewWindow | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        for part, stretch in (
            (self.bar, 0),
            (rule(), 0),
            (self.ground, 1),
            (rule(), 0),
            (self.strip, 0),
        ):
            column.addWidget(part, stretch)
        self._wire()
        self.show_device(USUAL)

    def _wire(self) -> None:
        shown, side, bar, sheet = self.shown, self.side, self.bar, self.sheet
        shown.edited.connect(self.edited)
        self.guiding.edited.connect(self.edited)
        shown.selection_changed.connect(self._show_layers)
        shown.selection_changed.connect(self.selection_changed)
        shown.status.connect(self.status)
        shown.filled_in.connect(self.filled_in)
        shown.media_asked.connect(self.media_asked)
        shown.file_asked.connect(self.file_asked)
        shown.menu_requested.connect(self.menu_requested)
        sheet.tag_dropped.connect(self._on_tag_dropped)
        sheet.files_dropped.connect(self._on_files)
        sheet.unshown_dropped.connect(lambda file: self._bring(Path(file)))
        self.ground.pressed.connect(lambda: sheet.choose(()))
        self.crumbs.asked.connect(self._on_crumb)
        self.strip.chosen.connect(self.go_to)
        side.components.pressed.connect(self._on_pressed)
        side.templates.chosen.connect(self._on_template)
        side.templates.removed.connect(self._remove_template)
        side.keep.clicked.connect(self._ask_to_keep)
        sheet.template_dropped.connect(self._on_template)
        self.strip.template_dropped.connect(self._on_template)
        side.layers.chosen.connect(sheet.choose)
        side.layers.background_chosen.connect(self._on_background)
        side.layers.moved.connect(self._on_layer_moved)
        side.layers.opened.connect(lambda id: self.filled_in.emit((*shown.place, "screen", id)))
        side.tags.pressed.connect(self.write_tag)
        bar.device_chosen.connect(self.show_device)
        bar.own_asked.connect(self._ask_device)
        bar.always_shown.connect(sheet.show_always)
        bar.preview_asked.connect(self.open_preview)
        self.sampling.changed.connect(self._show_values)

    def _on_pressed(self, name: str) -> None:
        """A component in free room; what it says is typed at once, where it stands."""
        place = self.shown.add(name)
        if place is None:
            return
        if name not in SAY or not self.sheet.writing.begin(place[-1]):
            self.filled_in.emit(place)

    # -- a piece of a view ---------------------------------------------------------------

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        every = (self.side, self.ground, self.strip, self.crumbs, self.shown, self.sampling)
        for one in (*every, self.guiding):
            one.set_theme(theme)

    def show_document(self, application: rbd.Application, problems: list[Problem]) -> None:
        """Takes a new value, of which ``select`` says what is shown."""
        self.shown.show_document(application, problems)

    def select(self, selected: tuple[Place, ...]) -> None:
        """Shows the screen of the first of these that has one, as it is now."""
        self.shown.go(selected)
        self._settle(selected)

    def select_all(self) -> None:
        self.sheet.select_all()

    def menu_corner(self) -> QPoint:
        """Where a context menu of what is selected stands, on the desktop."""
        return self.sheet.menu_corner()

    # -- bringing it up to date ----------------------------------------------------------

    def _settle(self, selected: tuple[Place, ...]) -> None:
        application, place = self.shown.application, self.shown.place
        if application is None:
            return
        here = words.state_words(application, place[1]) if len(place) > 1 else ""
        here = here or self.tr("In every state")
        self.crumbs.show_way((application.name, here, self.tr("Screen")))
        self.strip.show_state(application, place)
        self._show_values()
        self._show_layers(selected)
        self.guiding.show_document(application)

    def _show_layers(self, selected: tuple[Place, ...]) -> None:
        chosen = self.sheet.selected
        if selected[:1] == ((*self.shown.place, "screen"),):
            chosen = (BACKGROUND,)
        self.side.layers.show_screen(self.shown.screen, chosen, self.shown.problems)

    def _show_values(self) -> None:
        screen, above = self.shown.screen, self.shown.above
        self.shown.values = self.sampling.values(screen, above)
        self.shown.show()

    def show_device(self, device: Device) -> None:
        """The screen as it is on that device."""
        self.device = device
        self.sheet.look_at(device)
        self.ground.show_device(device)
        self.bar.show_device(device)
        self.device_changed.emit(device)

    def _ask_device(self) -> None:
        device = ask_device(self.device, self)
        if device is not None:
            self.show_device(device)

    def open_preview(self) -> None:
        """The screen as a person sees and uses it, in a window of its own."""
        application, place = self.shown.application, self.shown.place
        if application is None:
            return
        no = place[1] if len(place) > 1 else application.start_no or ""
        walk = Walk(application, no, self.sampling.known())
        self.preview = PreviewWindow(self._theme, self.device, walk, self.shown.media, self)
        self.preview.finished.connect(self._on_preview_closed)
        self.preview.open()

    def _on_preview_closed(self) -> None:
        self.preview = None

    # -- going to another state ----------------------------------------------------------

    def go_to(self, place: Place) -> None:
        """Selects a state, of which the screen is shown then."""
        self.selection_changed.emit((place,))
        self.select((place,))

    def _on_crumb(self, level: int) -> None:
        self.view_asked.emit("graph", self.shown.place if level else ())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        ways = {Qt.Key.Key_PageUp: -1, Qt.Key.Key_PageDown: 1}
        by = ways.get(Qt.Key(event.key()))
        if by is not None and event.modifiers() == Qt.KeyboardModifier.NoModifier:
            self.strip.step(by)
        else:
            super().keyPressEvent(event)

    # -- what the side tells -------------------------------------------------------------

    def _on_template(self, template: rbd.State, place: Place = ()) -> None:
        if place:
            self.go_to(place)
        application, place = self.shown.application, self.shown.place
        if application is None or not self.shown.may_add():
            return
        project = self._project()
        if self._own is not None and project is not None:
            try:
                template = self._own.brought(template, project)
            except UsageError as error:
                self.status.emit(said(str(error)))
                return
        had = self.shown.screen is not None and self.shown.screen.components
        after = templates.applied(application, place, template)
        where = words.place_words(application, place)
        told = self.tr("Template {0} for {1}").format(templates.title(template.name), where)
        self.edited.emit(after, told)
        self.go_to(place)
        self.sheet.setFocus()
        if had:
            self.status.emit(self.tr("The screen is another one now: Undo brings it back."))

    def use_templates(self, own: OwnTemplates) -> None:
        """Shows a person's own templates too, and keeps there what is saved as one."""
        self._own = own
        self.side.templates.show_own(own.all())

    def _ask_to_keep(self) -> None:
        screen = self.shown.screen
        if screen is None or not screen.components:
            self.status.emit(self.tr("There is nothing on this screen that could be kept."))
            return
        self.template_asked.emit(getattr(self.shown.part, "name", ""))

    def keep_template(self, name: str) -> None:
        """Keeps the screen that is shown as a template of that name; as ``OwnTemplates``."""
        project = self._project()
        if self._own is not None and self.shown.screen is not None and project is not None:
            file_of = partial(media_import.file_of, project)
            self._own.keep(name, self.shown.screen, file_of)
            self.side.templates.show_own(self._own.all())
            self.status.emit(self.tr("Template {0} is kept for all your projects.").format(name))

    def _remove_template(self, name: str) -> None:
        if self._own is not None:
            try:
                self._own.remove(name)
            except UsageError as error:
                self.status.emit(said(str(error)))
                return
            self.side.templates.show_own(self._own.all())
            self.status.emit(self.tr("Template {0} is removed.").format(name))

    def _on_background(self) -> None:
        """The screen itself, whose form has its background."""
        place = self.shown.place
        if self.shown.screen is not None:
            place = (*place, "screen")
        self.selection_changed.emit((place,))
        self.select((place,))

    def _on_layer_moved(self, id: str, to: int) -> None:
        screen = self.shown.screen
        if self.shown.application is None or screen is None:
            return
        start = next(i for i, one in enumerate(screen.components) if one.id == id)
        within = (*self.shown.place, "screen")
        after = places.move(self.shown.application, within, "components", start, to)
        self.edited.emit(after, self.tr("Reorder {0}").format(id))
        self.sheet.choose((id,))

    # -- tags ----------------------------------------------------------------------------

    def offer_tags(self, tags: tuple[str, ...]) -> None:
        """The tags of the project: what ``{`` completes, and as chips those that are its own."""
        self.sheet.offer_tags(tags)
        own = (tag for tag in tags if is_tag(tag) and not is_reserved(tag))
        self.side.tags.show_tags(tuple(own))

    def write_tag(self, tag: str) -> None:
        """Puts a reference at the end of the selected text, or makes a text of it."""
        chosen = self.sheet.selected
        self._write_tag(tag, chosen if len(chosen) == 1 else ())

    def _on_tag_dropped(self, tag: str, x: float, y: float) -> None:
        self._write_tag(tag, self.sheet.under(self.sheet.scale.point(x, y)), (x, y))

    def _write_tag(
        self, tag: str, ids: Sequence[str], at: tuple[float, float] | None = None
    ) -> None:
        """Into the first of these that has a text, else as a new text there, or in free room."""
        if self.shown.application is None:
            return
        every = (self.sheet.component(id) for id in ids)
        component = next((one for one in every if isinstance(one, rbd.Text | rbd.Button)), None)
        if component is None:
            self.shown.add("text", at, text=f"{{{tag}}}")
            return
        id = component.id
        gap = "" if not component.text or component.text[-1].isspace() else " "
        place = (*self.shown.place, "screen", id)
        after = places.change(self.shown.application, place, text=f"{component.text}{gap}{{{tag}}}")
        self.edited.emit(after, self.tr("Put {0} into {1}").format(tag, id))
        self.sheet.choose((id,))

    # -- pictures and movies -------------------------------------------------------------

    def paste(self) -> bool:
        """Puts the picture or the files of the clipboard onto the screen; whether it had some."""
        data = QGuiApplication.clipboard().mimeData()
        files = files_in(data)
        if files:
            self._on_files(files, 50, 50)
            return True
        picture = data.imageData() if data.hasImage() else None
        if not isinstance(picture, QImage) or picture.isNull():
            return False
        self._place("image", lambda project: _brought(project, picture), 50, 50)
        return True

    def _on_files(self, files: tuple[Path, ...], x: float, y: float) -> None:
        for at, file in enumerate(files):
            kind = media_import.kind_of(file) or "image"
            bring = partial(media_import.bring, source=file)
            self._place(kind, bring, x + 4 * at, y + 4 * at)

    def _bring(self, file: Path) -> None:
        self._on_files((file,), 50, 50)

    def _place(self, kind: str, bring: Callable[[Project], str], x: float, y: float) -> None:
        """A new picture or movie of a file that is brought into the project."""
        project = self._project()
        if project is None or not self.shown.may_add():
            return
        try:
            src = bring(project)
        except UsageError as error:
            self.status.emit(said(str(error)))
            return
        self.shown.add(kind, (x, y), src=src)


class _BareCrumbs(Breadcrumbs):
    """On the ground, which is seen behind it."""

    def set_theme(self, theme: Theme) -> None:
        super().set_theme(theme)
        bare = "Breadcrumbs, _BareCrumbs { background: transparent; border: none; }"
        self.setStyleSheet(self.styleSheet() + bare)


def _brought(project: Project, picture: QImage) -> str:
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, b"PNG").write(picture)
    data: Any = buffer.data()
    return media_import.bring_bytes(project, bytes(data.data()), "pasted.png")
