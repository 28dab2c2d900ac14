"""Documents of any size for the benchmarks: the same bytes for the same arguments.

They are canonical: what ``codec.write`` makes of them are these bytes again. Nothing is wrong
with them; ``check`` only says of a thousand menus that it gave up its search for livelocks.
"""

from __future__ import annotations

_HEAD = """\
<?xml version="1.0" encoding="UTF-8"?>
<application name="{name}" start="1"{space}>
"""

_ALWAYS = """\
  <always>
    <screen>
      <components>
        <button id="home" x="2" y="2" width="16" height="12" event="clickHome">Home</button>
      </components>
    </screen>
    <expectedevents>
      <event name="clickHome" next="1">
        <clear tag="user.**"/>
      </event>
      <event name="clickRepeat">
        <repeat/>
      </event>
    </expectedevents>
  </always>
"""

_STATE = """\
  <state no="{no}" name="question {no}" ed:x="{x}" ed:y="{y}">
    <screen>
      <components>
        <text id="ask" x="10" y="18" width="80" height="20">Question {no}, {{user.name}}?</text>
        <button id="yes" x="10" y="75" width="30" height="15" event="yes">Yes</button>
      </components>
    </screen>
    <backgroundactions>
      <speech>This is question {no}.</speech>
    </backgroundactions>
    <expectedevents>
      <event name="yes" next="{aside}">
        <when>
          <data tag="score" {test}/>
        </when>
      </event>
      <event name="yes" next="{next}"/>
    </expectedevents>
  </state>
"""

_MENU = """\
  <state no="{no}" name="menu {no}">
    <timeout next="1">{seconds}</timeout>
    <expectedevents>
      <event name="first" next="{first}"/>
      <event name="second" next="{second}">
        <when>
          <data tag="level" atleast="{level}"/>
        </when>
      </event>
      <event name="second" next="{back}"/>
      <event next="{first}">
        <when>
          <data tag="hurry" is="{depth}" within="{seconds}"/>
        </when>
      </event>
    </expectedevents>
  </state>
"""

_HOLDER = """\
  <state no="{no}">
    <flow src="part{part}.rbd.xml"/>
    <expectedevents>
      <event name="done" next="{next}"/>
    </expectedevents>
  </state>
"""

_TESTS = ('above="{0}"', 'is="{0}"', 'atmost="{0}"', 'in="[{0}, {1}]"', 'below="{1}" for="0.5"')


def dialogue(states: int, name: str = "dialogue") -> bytes:
    """An application as people make them, about 600 bytes a state: questions one after the
    other with guards, ``always`` beside each, positions on the canvas.
    """
    return _whole(name, _questions(states, "1"), ' xmlns:ed="urn:situ:editor"')


def menus(states: int, name: str = "menus") -> bytes:
    """A tree of menus with timeouts, ways back, and events without a name that follow on data."""
    made = []
    for no in range(1, states + 1):
        first, second = (one if one <= states else 1 for one in (2 * no, 2 * no + 1))
        made.append(
            _MENU.format(
                no=no,
                seconds=no % 9 + 1,
                level=no % 5,
                depth=no.bit_length(),
                first=first,
                second=second,
                back="#back" if no > 1 else "#again",
            )
        )
    return _whole(name, made)


def parts(count: int, states: int) -> dict[str, bytes]:
    """File to content: an application of ``count`` parts, one after the other, with ``states``
    states each and an end.
    """
    space = ' xmlns:ed="urn:situ:editor"'
    end = f'  <state no="{states + 1}" final="true"/>\n'
    holders = [_HOLDER.format(no=no, part=no, next=no % count + 1) for no in range(1, count + 1)]
    files = {"whole.rbd.xml": _whole("whole", holders)}
    for no in range(1, count + 1):
        inside = [*_questions(states, str(states + 1)), end]
        files[f"part{no}.rbd.xml"] = _whole(f"part{no}", inside, space)
    return files


def _questions(states: int, last: str) -> list[str]:
    return [
        _STATE.format(
            no=no,
            x=no % 40 * 220,
            y=no // 40 * 130,
            test=_TESTS[no % len(_TESTS)].format(no % 17, no % 7 + 20),
            next=no + 1 if no < states else last,
            aside=(no + 7) % states + 1,
        )
        for no in range(1, states + 1)
    ]


def _whole(name: str, states: list[str], space: str = "") -> bytes:
    head = _HEAD.format(name=name, space=space)
    return "".join([head, _ALWAYS, *states, "</application>\n"]).encode()
