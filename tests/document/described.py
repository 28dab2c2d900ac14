"""Documents in few words, and what tells them apart as lines."""

from __future__ import annotations

from typing import Any

from situ.document import codec
from situ.document.diff import compare


def read_document(text: str, name: str = "a") -> Any:
    document, problems = codec.read(text.encode(), name)
    assert not problems
    return document


def application(states: str) -> str:
    return f'<application name="a">{states}</application>'


PILLS = """<state no="1" name="Take pills"><timeout next="2">{seconds}</timeout>
<backgroundactions><speech>{text}</speech></backgroundactions>
<expectedevents>{events}</expectedevents></state><state no="2" name="done"/>"""

EVENTS = """<event name="yes" next="2"/><event name="no" next="1"><when>
<data tag="a" above="1"/><data tag="b" exists="true"/></when></event>"""


def pills(seconds: str = "30", text: str = "Now", events: str = EVENTS) -> str:
    return application(PILLS.format(seconds=seconds, text=text, events=events))


SCRIPT = """<spds name="s"><modules><module name="m" resources="head"/></modules>
<situation name="a"><condition><data tag="x" is="1"/></condition><module name="m" priority="9"/>
</situation>
<situation name="b" extends="a"><condition><data tag="y" is="1"/></condition></situation>
<situation name="c"><module name="m" priority="1"/></situation></spds>"""


def differences(before: str, after: str) -> list[str]:
    return [change.text for change in compare(read_document(before), read_document(after))]
