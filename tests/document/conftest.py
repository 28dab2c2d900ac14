"""Documents for tests: the examples of formats.md, and any document that the table allows."""

from __future__ import annotations

import re
from collections.abc import Callable
from random import Random
from typing import Any

import pytest

from situ.document import datatypes as types
from situ.document.aside import EDITOR, Aside
from situ.document.condition import TESTS, Test
from situ.document.datatypes import WHITE, Type
from situ.document.elements import ROOTS, TEST, TIMEOUT
from situ.document.grammar import Element

RBD = """\
<application name="reception" start="1">
  <always>
    <screen><components><button id="home" x="2" y="2" width="16" height="12" event="clickHome">\
Home</button></components></screen>
    <expectedevents><event name="clickHome" next="1"><clear tag="user.**"/></event>\
<event name="clickRepeat"><repeat/></event></expectedevents>
  </always>
  <state no="1" name="start">
    <timeout next="1">30</timeout>
    <screen background="lobby.png" touched="screenTouched">
      <components>
        <text   id="hello"    x="10" y="10" width="80" height="20" size="9">Hello {user.name}</text>
        <button id="continue" x="35" y="75" width="30" height="15" event="go">CONTINUE</button>
        <image  id="nurse"    x="60" y="30" width="30" height="40" src="nurse.png"/>
        <movie  id="intro"    x="10" y="30" width="45" height="40" src="intro.webm" done="shown"/>
        <input  id="initial"  x="10" y="50" width="20" height="10" tag="user.initial" kind="text" \
max="1" event="entered"/>
        <list   id="names"    x="10" y="30" width="80" height="40" items="patients" \
label="{item.name}, room {item.room}" tag="patient" event="chosen"/>
      </components>
    </screen>
    <backgroundactions>
      <speech>Hello {user.name}</speech>
      <robot resource="base" command="goto" done="arrived" failed="blocked">\
<param name="place">lobby</param></robot>
      <service name="findPatientsByInitials" method="POST" url="{services.records}/find" \
done="returned" failed="offline">
        <param name="x">{user.initial}</param>
        <result tag="patients" path="names"/>
      </service>
      <message topic="nurse/call"><param name="room">{patient.room}</param></message>
      <launch program="brain-game" done="gameClosed"><param name="level">2</param></launch>
      <sound src="chime.ogg"/>
      <set tag="visits">3</set>
    </backgroundactions>
    <expectedevents>
      <event name="go" next="2"><say>continue</say><say>go on</say></event>
      <event name="returned" next="5"><when><data tag="patients.0" exists="true"/></when></event>
      <event name="returned" next="6"/>
      <event next="9"><when><data tag="human.distance" below="1.5"/></when></event>
    </expectedevents>
  </state>
  <!-- states 2, 5, 6 and 9 left out here -->
</application>
"""

SPDS = """\
<spds name="conversation">
  <observe>
    <data tag="face.visible" type="boolean"/>
    <data tag="sound.slap"   type="number" unit="deg"/>
    <data tag="person.calling" type="boolean"/> <data tag="transfer.phase" type="text"/>
  </observe>
  <modules>
    <module name="chase-face" resources="head"/>
    <module name="converse"   resources="speech screen"/>
    <module name="transfer"   resources="base head"/>
  </modules>
  <situation name="invited" limit="90">
    <condition><data tag="person.calling" is="true" within="5"/></condition>
    <until><data tag="transfer.phase" in='["arrived", "failed"]' within="5"/></until>
    <module name="transfer" priority="90"/>
  </situation>
  <situation name="sound" extends="conversation" dwell="1.5">
    <condition><any><data tag="sound.slap" exists="true" for="1"/><none>\
<data tag="face.visible" is="true"/></none></any></condition>
    <module name="chase-face" priority="none"/>
  </situation>
  <situation name="conversation">
    <module name="chase-face" priority="20"/>
    <module name="converse"   priority="30"/>
  </situation>
</spds>
"""

MODULES = """\
<modules>
  <module name="face-detector" resources="">
    <description>Finds the nearest face in the left camera.</description>
    <requires data="camera.left"/>
    <requires module="camera"/>
    <provides data="face.visible" type="boolean"/>
    <provides data="face.direction" type="number" unit="deg"/>
  </module>
</modules>
"""


@pytest.fixture(params=[RBD, SPDS, MODULES], ids=["rbd", "spds", "modules"])
def example(request: pytest.FixtureRequest) -> bytes:
    """Each of the three documents, nearly as formats.md shows it, not yet canonical."""
    text: str = request.param
    return text.encode()


@pytest.fixture
def rbd() -> Callable[[str], bytes]:
    """An application of the states given as XML."""
    return lambda states: f'<application name="a">{states}</application>'.encode()


# -- any document ------------------------------------------------------------

_ODD = ["", "a", "&<>\"'", "{{}}", "  a\n\tb \r", "\u00a0", "日本 ✓", "]]>", "\U0001f916", "--"]
_FRAGMENTS = [
    "<!-- a comment -->",
    "<!--two\n   lines-->",
    "<?tool says so?>",
    '<ed:note xmlns:ed="urn:situ:editor" x="1">a &amp; b</ed:note>',
    '<x:y xmlns:x="urn:other"><x:z a="&gt;"/></x:y>',
    '<other xmlns="urn:third"/>',
]
_FOREIGN = [f"{{{EDITOR}}}x", "{urn:other}a", "{urn:fourth}b"]


class Maker:
    """Makes any document that the table allows, from one random seed.

    The seed is what hypothesis draws: drawing each part would take it seconds a document.
    """

    def __init__(self, seed: int) -> None:
        self._random = Random(seed)

    def document(self) -> Any:
        return self.value(self._random.choice(ROOTS), 0)

    def value(self, element: Element, depth: int) -> Any:
        aside = self._aside(element)
        if element is TEST:
            times = [self._maybe(lambda: self._held(types.SECONDS)) for _ in range(2)]
            test = self._random.choice(TESTS)
            return Test(self._held(types.NAME), test, self._text(), times[0], times[1], aside)
        found: dict[str, Any] = {"aside": aside}
        self._fill(element, found, depth)
        assert element.make is not None
        return element.make(**found)

    def _fill(self, element: Element, found: dict[str, Any], depth: int) -> None:
        random = self._random
        either = [one for one in element.attributes if one.alternative]
        chosen = random.choice(either) if either else None
        for one in element.attributes:
            if one.required or one is chosen or (not one.alternative and random.random() < 0.5):
                found[one.field] = self._held(one.type)
        if element.text is not None:
            field, kind = element.text
            held = self._held(kind)
            found[field] = held.strip(WHITE) or "a" if isinstance(held, str) else held
        for slot in element.slots:
            if not slot.field:
                self._maybe(lambda s=slot: self._fill(s.elements[0], found, depth))  # type: ignore[misc]
            elif not slot.many:
                held = self._maybe(lambda s=slot: self.value(s.elements[0], depth + 1))  # type: ignore[misc]
                found[slot.field] = held
            else:
                kinds = slot.elements[:1] if depth > 5 else slot.elements
                chosen_kinds = random.choices(kinds, k=random.randrange(4))
                found[slot.field] = tuple(self.value(kind, depth + 1) for kind in chosen_kinds)

    def _maybe(self, make: Callable[[], Any]) -> Any:
        return make() if self._random.random() < 0.6 else None

    def _aside(self, element: Element) -> Aside:
        random, root = self._random, element in ROOTS
        fragments = _FRAGMENTS[:1] if root else _FRAGMENTS
        # The schema can have nothing but comments inside a number.
        inner = _FRAGMENTS[:3] if element is TIMEOUT else _FRAGMENTS
        keys = random.sample(_FOREIGN, random.choice([0, 0, 1, 2]))
        return Aside(
            before=tuple(random.choices(fragments, k=random.choice([0, 0, 1, 2]))),
            inside=tuple(random.choices(inner, k=random.choice([0, 0, 0, 1]))),
            after=tuple(random.choices(fragments, k=random.randrange(2))) if root else (),
            attributes=tuple((key, self._text()) for key in keys),
        )

    def _text(self) -> str:
        random = self._random
        if random.random() < 0.5:
            return "".join(random.choices(_ODD, k=2))
        codes = (random.choice([0x20, 0x60, 0x3040, 0x1F600]) + random.randrange(32) for _ in "abc")
        return "".join(map(chr, codes)).replace("\x7f", "")

    def _number(self) -> float:
        random = self._random
        return random.choice(
            [float(random.randrange(-100, 100)), random.uniform(-1e6, 1e6), random.random() / 1e9]
        )

    def _held(self, kind: Type) -> Any:
        random = self._random
        if kind is types.TEXT:
            return self._text()
        if kind is types.SOME:
            return self._text() + "x"
        if kind in (types.NUMBER, types.SIZE, types.SECONDS):
            number = self._number()
            return number if kind is types.NUMBER else abs(number) or 1.0
        if kind is types.COUNT:
            return random.randrange(1, 10**6)
        if kind is types.PRIORITY:
            return random.choice([None, random.randrange(-100, 10**6)])
        if kind is types.BOOLEAN:
            return random.random() < 0.5
        if kind is types.RESOURCES:
            return tuple(random.sample(["head", "base", "left-arm"], random.randrange(4)))
        for known, words in _WORDS:
            if kind is known:
                return random.choice(words)
        # What is left is one of a few words.
        return random.choice(re.findall(r"<value>(.*?)</value>", kind.schema))


_WORDS = (
    (types.TAG, ["a", "user.name", "a-b.c_1", "module/a/head"]),
    (types.NAME, ["a", "a.0.B", "service/x.ok"]),
    (types.PATTERN, ["a", "a.*", "**", "a.**.b", "robot/*"]),
    (types.TOKEN, ["1", "5/q", "start", "ä"]),
    (types.TARGET, ["1", "#again", "#back", "5/q"]),
    (types.TITLE, ["m", "chase-face", "Name mit ä", "日本"]),
)


@pytest.fixture(scope="session")
def make_document() -> Callable[[int], Any]:
    """Any document at all, by a seed."""
    return lambda seed: Maker(seed).document()
