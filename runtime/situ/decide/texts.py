"""Texts in the language of the tag ``language``."""

from __future__ import annotations

from collections.abc import Callable

from situ.decide.board import Board
from situ.document.project import Project
from situ.document.texts_shown import has_words

Translator = Callable[[str, list[str] | None], str]
"""(text as written, sentences about what is missing or None) -> the text to use."""


def translator(project: Project, board: Board, lang: str | None = None) -> Translator:
    """Translates by ``texts/LANG.po`` into ``lang``, else into the tag ``language``.

    A missing translation falls back on the text as written, which is in the first
    of the project's languages, and is told (formats.md, *A project*); but for a text in which
    there is no word.
    """

    def translate(text: str, missing: list[str] | None) -> str:
        language = lang if lang is not None else board.look("language")
        if not isinstance(language, str) or not text.strip():
            return text
        found = project.texts.get(language, {}).get(text)
        if found:
            return found
        written_in = project.languages[:1]
        told = lang is None and written_in and language not in written_in and has_words(text)
        if missing is not None and told:
            missing.append(f"no text in {language} for “{text}”")
        return text

    return translate
