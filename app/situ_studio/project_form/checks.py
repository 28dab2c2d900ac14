"""What may be typed into the project form: the value, or a ValueError in a sentence."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from situ.document import names
from situ.document.projectfile import BROKER, FILTER
from situ_studio.wording.language import tr


def tag(text: str) -> str:
    """The tag that was typed; ValueError, in a sentence, where it is none."""
    if not names.is_tag(text):
        raise ValueError(tr("A tag is words of a to z, 0 to 9, _ and - with dots between."))
    if names.is_reserved(text):
        raise ValueError(tr("{0} is written by the robot itself only.").format(text))
    return text


def pattern(text: str) -> str:
    """The tag or pattern that was typed; ValueError where it is none."""
    if not names.is_pattern(text):
        raise ValueError(tr("Write a tag, with * for one word and ** for any number of words."))
    return text


def named(text: str) -> str:
    if not text:
        raise ValueError(tr("This can not be left empty."))
    return text


def inside(text: str) -> str:
    if text.startswith("/") or ".." in text.split("/") or "\\" in text:
        raise ValueError(tr("A folder inside the project's own: no .. and no / at its beginning."))
    return text


def broker(text: str) -> str:
    if text and not BROKER.fullmatch(text):
        raise ValueError(tr("Write mqtt://HOST or mqtts://HOST; a password stays on the robot."))
    return text


def topic(text: str) -> str:
    if not text or not FILTER.fullmatch(text):
        raise ValueError(tr("A topic: + stands for one whole level, # for all that follow."))
    return text


def free(name: str, taken: Sequence[str] | Mapping[str, Any]) -> str:
    """The name, with a number where it is taken."""
    found, number = name, 2
    while found in taken:
        found, number = f"{name}{number}", number + 1
    return found


def once(check: Callable[[str], str], taken: Callable[[], Sequence[str]]) -> Callable[[str], str]:
    """A check that refuses what is there already."""

    def checked(text: str) -> str:
        found = check(text)
        if found in taken():
            raise ValueError(tr("{0} is there already.").format(found))
        return found

    return checked
