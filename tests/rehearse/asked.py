"""What ``why`` is asked about in several files: a door, a laboratory, and how it answers."""

from __future__ import annotations

import re
from typing import Any

from situ.document.project import Project
from situ.rehearse.reason import Answer, lines
from situ.rehearse.recording import Recording
from situ.rehearse.why import why_not

DOOR = """<application name="door">
<always><expectedevents><event name="home" next="1"/></expectedevents></always>
<state no="1" name="shut" always="false">
  <timeout next="3">30</timeout>
  <screen><components>
    <button id="open" x="1" y="1" width="9" height="9" event="open">Open</button>
  </components></screen>
  <backgroundactions><service name="find" url="http://x/" done="found" failed="lost"/>
  </backgroundactions>
  <expectedevents>
    <event name="open" next="3"><when><data tag="fire" is="true"/></when></event>
    <event name="open" next="2"><say>open up</say><when>
      <data tag="key" above="3"/>
      <none><data tag="alarm" exists="true" within="5"/></none>
      <any><data tag="day" is="mon" for="2"/><data tag="day" is="{open.day}"/></any>
    </when></event>
    <event name="found" next="2"/>
    <event next="4"><when><data tag="distance" below="1.5"/></when></event>
    <event name="returned"><set tag="x" done="raised">1</set></event>
    <event name="raised" next="2"/>
    <event name="undo" next="#back"/>
  </expectedevents>
</state>
<state no="2" name="open"><expectedevents>
  <event name="go" next="4"/><event name="undo" next="#back"/></expectedevents></state>
<state no="3" name="burning"><expectedevents><event name="go" next="1"/></expectedevents></state>
<state no="4" name="inside"><expectedevents><event name="undo" next="#back"/></expectedevents>
</state>
<state no="5" name="nowhere"/>
</application>"""

SCRIPT = """<spds name="s">
<modules><module name="arm" resources="base hand"/><module name="app" resources="base speech"/>
<module name="other" resources="base"/></modules>
<situation name="hot" limit="5"><condition><data tag="heat" above="40"/></condition>
<until><data tag="cooled" is="true"/></until><module name="arm" priority="90"/></situation>
<situation name="held" dwell="10"><condition><data tag="hold" is="true"/></condition>
<module name="arm" priority="90"/><module name="app" priority="10"/></situation>
<situation name="dark"><condition><data tag="light" below="5"/></condition></situation>
<situation name="calm"><module name="app" priority="10"/><module name="arm" priority="5"/>
<module name="other" priority="10"/></situation>
</spds>"""

APP = """<application name="app">
<state no="1"><backgroundactions>
<robot resource="base" command="wait" done="rested"/></backgroundactions>
<expectedevents><event name="go" next="2"/></expectedevents></state>
<state no="2"><backgroundactions>
  <speech wait="true">First</speech><speech>Hello {name}</speech><set tag="a">1</set>
  <robot resource="base" command="turn" optional="true"/></backgroundactions></state>
</application>"""

BUSY = """<application name="busy">
<state no="1"><screen touched="poked"><components>
<movie id="film" x="1" y="1" width="9" height="9" src="f.webm" done="seen" failed="dark"/>
</components></screen>
<backgroundactions>
  <speech>One</speech><sound src="two.ogg"/><service name="s" url="http://x/" wait="true"/>
  <launch program="game" done="played"/></backgroundactions>
<timeout>5</timeout>
<expectedevents>
  <event name="poked"><when><data tag="a" is="1"/></when><message topic="hello">hi</message></event>
  <event name="timeout" next="2"/><event name="seen" next="2"/><event name="played" next="2"/>
  <event name="resumed" next="2"/><event name="notunderstood" next="2"/><event name="a"><set
  tag="x" done="b">1</set></event><event name="b"><set tag="x" done="a">1</set></event>
  <event next="3"><when><data tag="loop" is="1"/></when></event>
</expectedevents></state>
<state no="2"><backgroundactions><speech>Hello</speech></backgroundactions><expectedevents>
  <event name="b"><launch program="game"/></event></expectedevents></state>
<state no="3"><timeout next="2" idle="true">5</timeout><expectedevents><event next="1"><when>
<data tag="loop" is="1"/></when></event><event name="go"/><event name="go" next="2"/>
</expectedevents></state>
</application>"""

CLOCK = """<application name="app"><state no="1"><expectedevents>
<event name="go" next="2"><when><data tag="clock.time" above="09:00"/></when></event>
</expectedevents></state><state no="2"/></application>"""


def shown(answer: Answer) -> str:
    """The reasons as lines, without the numbers of the events."""
    return re.sub(r"  \(#\d+\)", "", "\n".join(lines(answer.reasons)))


def answered(project: Project, recording: Recording, at: float, kind: str, **wanted: Any) -> str:
    return shown(why_not(project, recording, {"kind": kind, **wanted}, at))
