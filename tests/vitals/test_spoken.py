"""What the robot of examples/vitals says is said in its language by the voice that it has unless
another is chosen: espeak-ng spells each letter that it can not read, in English, by its kind.

So the readings of texts/ja.po turn whatever is not kana or a number into kana, and particles into
what they sound like.
"""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Iterator

import pytest
from tests.vitals.days import VITALS

from situ.document.project import Project
from situ.document.rbd import Speech
from situ.document.ready import load_ready
from situ.document.texts import read_out
from ward_records.__main__ import CONTACTS, INVENTED, MEDICINE
from ward_records.names import said as names_said

NAMES = [(name, kana) for _, name, _, kana in INVENTED]
NAMES += [(name, kana) for *_, name, kana in CONTACTS]
CALLED = {"begins": "14:00", "days": "3"}
"""What a reference is filled with, by its last word; another one with a number or a text."""


@pytest.fixture(scope="module")
def project() -> Project:
    return load_ready(VITALS)


def is_japanese(text: str) -> bool:
    return re.search("[\u3040-\u30ff\u4e00-\u9fff]", text) is not None


def speeches(project: Project) -> Iterator[str]:
    for application in (*project.applications.values(), *project.parts.values()):
        for state in application.states:
            for action in state.actions:
                if isinstance(action, Speech):
                    yield action.text


def filled(text: str, name: str, what: str) -> str:
    known = {**CALLED, "said": name, "what": what}
    return re.sub(r"\{[\w.-]*?(\w+)\}", lambda found: known.get(found[1], "128"), text)


def of_media(language: str) -> Iterator[str]:
    """Questions, answers, titles and stories, which speeches take up."""
    for file in ("quiz", "shelf"):
        found = json.loads((VITALS / "media" / f"{file}.{language}.json").read_text("utf-8"))
        left = [found]
        while left:
            one = left.pop()
            if isinstance(one, dict):
                left += [each for key, each in one.items() if key not in ("kind", "src")]
            elif isinstance(one, list):
                left += one
            elif isinstance(one, str):
                yield one


def said(espeak: str, voice: str, lines: list[str]) -> str:
    """How the voice says them, in IPA."""
    command = [espeak, "-v", voice, "-q", "--ipa", "--stdin"]
    given = "\n\n".join(lines).encode()
    return subprocess.run(command, input=given, capture_output=True, check=True).stdout.decode()


def test_all_that_is_said_in_japanese_is_said_as_japanese(project: Project, espeak: str) -> None:
    names = [names_said(*both, "ja") for both in NAMES if is_japanese(both[0])]
    what = next(what for *_, what in MEDICINE if is_japanese(what))
    japanese = project.texts["ja"]
    texts = [japanese.get(text, text) for text in speeches(project)]
    written = [
        *dict.fromkeys(filled(text, name, what) for text in texts for name in names),
        *of_media("ja"),
        *(f"{days}日前のことでした。" for days in range(2, 8)),
    ]
    assert len(written) > 150
    read = [read_out(text, project.readings["ja"], "ja") for text in written]
    left = {text: spelt for text in read if (spelt := re.findall("[\u3005\u4e00-\u9fff]+", text))}
    assert left == {}
    # Of another language it says so.
    assert "(en)" not in said(espeak, "ja", read)
    assert "(en)" in said(espeak, "ja", written[:1])


@pytest.mark.parametrize(
    ("written", "kana"),
    [
        ("5問のうち、", "ごもんのうち、"),
        ("3日前のことでした", "みっかまえのことでした"),
        ("5分ほどお待ちください", "ごふんほどおまちください"),
        ("アリの足は6本です", "アリのあしわろっぽんです"),
    ],
)
def test_what_is_counted_is_counted_in_japanese(project: Project, written: str, kana: str) -> None:
    assert read_out(written, project.readings["ja"], "ja") == kana


def test_a_number_is_said_as_a_japanese_one(espeak: str) -> None:
    # Hyaku, ni, and no hundred.
    spelt = said(espeak, "ja", ["うえが128です"])
    assert ("çˌäkɯ" in spelt, "nˌi" in spelt, "(en)" in spelt) == (True, True, False)


def test_what_was_measured_is_said_with_its_point(espeak: str) -> None:
    # Go ten roku; as it is written, 56.
    assert "tˈe̞ɴ" in said(espeak, "ja", [read_out("けっとうちわ5.6です", {}, "ja")])
    assert "tˈe̞ɴ" not in said(espeak, "ja", ["けっとうちわ5.6です"])


def test_names_are_said_in_english_too(project: Project, espeak: str) -> None:
    """Those in kanji as their kana says, in Latin letters."""
    names = [names_said(*both, "en") for both in NAMES]
    assert "Kimura Haru" in names
    texts = [text for text in speeches(project) if ".said}" in text]
    lines = [filled(text, name, "tea") for text in texts for name in names]
    assert len(lines) > 20
    # "Chinese letter", "Japanese letter".
    assert "lˌɛtə" not in said(espeak, "en", lines)
    assert "lˌɛtə" in said(espeak, "en", ["Hello 木村はる."])
