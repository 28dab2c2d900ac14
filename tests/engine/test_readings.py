"""A voice says words as their readings say; what is shown stays as it is written."""

from __future__ import annotations

import asyncio
from typing import Any

from situ.decide.effects import Map
from situ.document.project import Project
from situ.engine.voices.text import Said, Spoken


class Heard:
    """A voice that keeps what it was told to say; each takes no time."""

    missing = None

    def __init__(self) -> None:
        self.said: list[tuple[str, str]] = []

    async def speak(self, said: Said, audible: bool) -> Spoken:
        self.said.append((said.text, said.lang))
        return Spoken(0.0)


def test_a_voice_says_words_as_their_readings_in_that_language_say(situation: Any) -> None:
    voice = Heard()

    async def scenario() -> None:
        async with situation.side(voice=voice) as side:
            root = str(situation.media.parent)
            readings = {"ja": {"山田": "やまだ"}, "en": {"Dr.": "Doctor"}}
            # A version that was just deployed brings its own.
            side.performer.turn_to(Project(root=root, name="t", media="media", readings=readings))
            for action, lang, text in ((1, "ja", "山田さん、Dr."), (2, "en", "Dr. 山田")):
                side.performer.perform(
                    Map("speech", "reception", {"text": text, "lang": lang}, (action,))
                )
                assert (await side.answers.finish(action)).ok

    asyncio.run(scenario())
    assert voice.said == [("やまださん、Dr.", "ja"), ("Doctor 山田", "en")]
