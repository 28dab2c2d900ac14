"""Which sample values a designer shows: what the project knows, and what a person picked."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, Signal

from situ.decide.values import in_text
from situ.document import rbd
from situ.document.project import Project
from situ_studio.looks.theme import Theme
from situ_studio.screens import samples
from situ_studio.screens.designer_bar import DesignerBar
from situ_studio.screens.sample_popup import SamplePopup
from situ_studio.screens.samples import LANGUAGE
from situ_studio.screens.shown import Texts, Values


class Sampling(QObject):
    """What is picked is kept here, never in a document. Scenarios are read again where they have
    changed on disk.
    """

    changed = Signal()

    def __init__(
        self,
        bar: DesignerBar,
        theme: Theme,
        project: Callable[[], Project | None],
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._bar = bar
        self._theme = theme
        self._project = project
        self._used = True
        self._picked: dict[str, Any] = {}
        self._names: tuple[str, ...] = ()
        self._columns: dict[str, tuple[str, ...]] = {}
        self._known: dict[str, tuple[Any, ...]] = {}
        self._of: tuple[Any, ...] | None = None
        bar.samples_asked.connect(self.open)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme

    def values(self, screen: rbd.Screen | None, above: tuple[rbd.Component, ...]) -> Values | None:
        """What this screen is shown with; None where texts stay as they are written."""
        self._names = samples.wanted(screen, above)
        self._columns = samples.columns(screen, above)
        values = self._values()
        self._tell(values)
        if not self._used:
            return None
        return Values(samples.filled(values, screen, above), self._texts())

    def known(self) -> Values:
        """All values that are known or picked, whatever this screen shows."""
        return Values(self._values() if self._used else {}, self._texts())

    def _texts(self) -> Texts:
        project = self._project()
        return project.texts if project is not None else {}

    def open(self) -> None:
        """Shows the values of the screen's names, to be picked or typed."""
        popup = SamplePopup(self._theme, self._bar)
        popup.picked.connect(self._on_picked)
        popup.shown.connect(self._on_used)
        known = self._all()
        languages = (LANGUAGE,) if LANGUAGE in known else ()
        names = tuple(dict.fromkeys((*self._names, *languages)))
        popup.show_values(self._used, names, known, self._values(), self._columns)
        popup.open_below(self._bar.samples)

    def _all(self) -> dict[str, tuple[Any, ...]]:
        project = self._project()
        if project is None:
            return self._known
        of = (project.root, samples.version(project), project.tags, project.languages)
        if self._of != of:
            self._of = of
            self._known = samples.gather(project)
            if len(project.languages) > 1:
                spoken = dict.fromkeys((*self._known.get(LANGUAGE, ()), *project.languages))
                self._known[LANGUAGE] = tuple(spoken)
        return self._known

    def _values(self) -> dict[str, Any]:
        return samples.chosen(self._all(), self._picked)

    def _tell(self, values: dict[str, Any]) -> None:
        said = [
            f"{name} = {self._said(value)}"
            for name in self._names
            if (value := samples.value_of(values, name)) is not None
        ]
        self._bar.show_samples(said[0] if said and self._used else "")

    def _said(self, value: Any) -> str:
        if isinstance(value, list):
            return self.tr("{0} entries").format(len(value))
        return in_text(value)

    def _on_picked(self, name: str, value: object) -> None:
        if value is None:
            self._picked.pop(name, None)
        else:
            self._picked[name] = value
        self.changed.emit()

    def _on_used(self, used: bool) -> None:
        self._used = used
        self.changed.emit()
