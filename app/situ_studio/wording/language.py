"""The language of the studio: English, or one that ``resources/i18n`` has texts for.

QObjects say ``self.tr("…")``; everything else says ``tr("…")``. The texts of tables are
translated where they are shown, those of the runtime by ``said``. packaging/texts.py gathers all.
"""

from __future__ import annotations

import functools

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QObject, QTranslator

from situ.resources import resource
from situ_studio.wording.runtime_words import RuntimeWords, templates

LANGUAGES = {"en": "English", "ja": "日本語"}
"""By their codes, each as its speakers call it."""
SYSTEM = "system"


def tr(text: str) -> str:
    """A text of the studio in the user's language; lupdate finds it where it is said."""
    return QCoreApplication.translate("", text)


def translated(text: str) -> str:
    """A text of the table of kinds in the user's language."""
    return QCoreApplication.translate("kinds", text) if text else ""


def say(template: str) -> str:
    """A template of ``situ.document.words`` in the user's language."""
    return QCoreApplication.translate("runtime", template)


def said(text: str) -> str:
    """A text of ``situ.document`` (a problem, a mend, a difference) in the user's language."""
    return _runtime().said(text)


def count(number: int, one: str, many: str) -> str:
    """``{0} state`` for one, ``{0} states`` for several: a language says it in its own order."""
    return (one if number == 1 else many).format(number)


@functools.cache
def _runtime() -> RuntimeWords:
    return RuntimeWords(templates(), lambda text: QCoreApplication.translate("runtime", text))


def language_of(choice: str, wanted: list[str] | None = None) -> str:
    """The code of the language that is spoken where ``choice`` was chosen.

    choice: a code of ``LANGUAGES`` or ``SYSTEM``. wanted: what the system's user reads, best
    first, as QLocale.uiLanguages gives it.
    """
    if choice in LANGUAGES:
        return choice
    for one in QLocale.system().uiLanguages() if wanted is None else wanted:
        code = one.partition("-")[0]
        if code in LANGUAGES:
            return code
    return "en"


def spoken() -> str:
    """The code of the language that the studio speaks now."""
    return language_of(QLocale().name().partition("_")[0], [])


class Speaking(QObject):
    """What makes the application speak a language: the translators that are installed.

    One for the application; ``use`` says which language new texts are in. Whoever shows texts
    already must show them anew.
    """

    def __init__(self, application: QCoreApplication) -> None:
        super().__init__(application)
        self._application = application
        self._translators: list[QTranslator] = []
        self.code = "en"

    def use(self, code: str) -> None:
        """Raises UsageError where the language's texts are not there."""
        files = []
        if code != "en":
            files = [
                f"{QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)}/qtbase_{code}.qm",
                str(resource("i18n", f"studio_{code}.qm")),
            ]
        for translator in self._translators:
            self._application.removeTranslator(translator)
        self._translators = []
        for file in files:
            translator = QTranslator()
            if translator.load(file):
                self._application.installTranslator(translator)
                self._translators.append(translator)
        self.code = code
        QLocale.setDefault(QLocale(code))
        _runtime.cache_clear()
