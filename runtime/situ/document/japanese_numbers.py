"""Numbers in a Japanese text as a voice shall say them.

espeak-ng leaves out a decimal point, spells a percent sign in English and says the two numbers of
a time of day one after the other; other voices say what stands here as it is meant, too.
"""

from __future__ import annotations

import re

# As a Japanese keyboard types them.
_WIDE = str.maketrans("０１２３４５６７８９", "0123456789")
_GROUPED = re.compile(r"(?<![\d.．,，])\d{1,3}(?:[,，]\d{3})+(?![\d,，])")
_TIME = re.compile(r"(?<![\d:：.])([01]?\d|2[0-3])[:：]([0-5]\d)(?![\d:：])")
_DECIMAL = re.compile(r"(?<![\d.．])(\d+)[.．](\d+)(?![.．]?\d)")
# No blank stands between a particle and a number: 気温は-5度.
_MINUS = re.compile(r"(?<![^\W\u3041-\u3096])(?<![.,:)-])[-\u2212\uff0d](?=\d)")
_PERCENT = re.compile(r"(?<=\d)\s*[%％]")

_HOURS = ("れい", "いち", "に", "さん", "よ", "ご", "ろく", "しち", "はち", "く")
_MINUTES = (
    *("", "いっぷん", "にふん", "さんぷん", "よんぷん"),
    *("ごふん", "ろっぷん", "ななふん", "はっぷん", "きゅうふん"),
)
_TENS = ("", "じゅう", "にじゅう", "さんじゅう", "よんじゅう", "ごじゅう")


def say_numbers(text: str) -> str:
    """5.6 as ごてんろく is said, with what stands behind the point digit by digit; 14:30 as a time
    of day, 1,234 as one number, a minus and a percent sign by their names. What has two points,
    as 1.2.3, is no number, and stays as it is."""
    text = _GROUPED.sub(lambda found: re.sub("[,，]", "", found[0]), text.translate(_WIDE))
    text = _TIME.sub(_time, text)
    text = _DECIMAL.sub(lambda found: f"{found[1]}てん{' '.join(found[2])}", text)
    return _PERCENT.sub("パーセント", _MINUS.sub("マイナス", text))


def _time(found: re.Match[str]) -> str:
    hour, minute = int(found[1]), int(found[2])
    said = _TENS[hour // 10] + (_HOURS[hour % 10] if hour % 10 or not hour else "") + "じ"
    if minute and minute % 10 == 0:
        return f"{said}{_TENS[minute // 10].removesuffix('う')}っぷん"
    return f"{said}{_TENS[minute // 10]}{_MINUTES[minute % 10]}"
