"""The nurse's page in the language that her browser asks for: English or Japanese."""

from __future__ import annotations

from contextvars import ContextVar

from ward_records.errors import Unfit
from ward_records.japanese import JAPANESE

LANGUAGES = ("en", "ja")

_spoken: ContextVar[str] = ContextVar("language of the page", default="en")


def wanted(accept: str) -> str:
    """The first of ``LANGUAGES`` in the order that a header ``Accept-Language`` asks for."""
    asked: list[tuple[float, int, str]] = []
    for part in accept.split(","):
        language, _, weight = part.partition(";")
        try:
            quality = float(weight.strip().removeprefix("q=") or 1)
        except ValueError:
            continue
        asked.append((-quality, len(asked), language.strip().lower().partition("-")[0]))
    for refusal, _, language in sorted(asked):
        if language in LANGUAGES and refusal < 0:
            return language
    return LANGUAGES[0]


def speak(language: str) -> None:
    """Of the request that is answered now: each has a context of its own."""
    _spoken.set(language)


def spoken() -> str:
    return _spoken.get()


def say(text: str) -> str:
    """The text in the language of the request; as it is where it has no translation."""
    return JAPANESE.get(text, text) if spoken() == "ja" else text


def why(unfit: Unfit) -> str:
    """What is wrong with what was given, in the language of the request."""
    return say(unfit.text).format(*(say(str(one)) for one in unfit.values))
