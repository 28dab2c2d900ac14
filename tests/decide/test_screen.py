"""formats.md, *Screen*."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from tests.decide.conftest import Play, Trace

AT = 'x="10" y="20" width="30" height="40"'
RESOURCES = ("acquire", "abandon", "authority", "mapping")


def screen(components: str = "", **attributes: str) -> str:
    more = "".join(f' {key}="{value}"' for key, value in attributes.items())
    return f"<screen{more}><components>{components}</components></screen>"


def state(no: str, inside: str, events: str = "") -> str:
    return f'<state no="{no}">{inside}<expectedevents>{events}</expectedevents></state>'


def components(trace: Trace) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = trace.of("screen")[-1]["components"]
    return found


# -- components --------------------------------------------------------------


def test_components_have_their_place_and_looks(play: Play) -> None:
    text = f'<text id="a" {AT} size="9.5" align="center" color="#fff" fill="#000">Hi</text>'
    trace = play(state("1", screen(text)), [])
    assert components(trace) == [
        {
            "type": "text", "id": "a", "x": 10, "y": 20, "width": 30, "height": 40,
            "size": 9.5, "align": "center", "color": "#fff", "fill": "#000", "text": "Hi",
        }
    ]  # fmt: skip


def test_components_are_in_document_order(play: Play) -> None:
    shown = screen(f'<button id="b" {AT}>B</button><text id="a" {AT}>A</text>')
    assert play(state("1", shown), []).lines("screen") == ["0 screen app 1 [b=B a=A] <enter"]


def test_references_in_a_screen_are_filled_in(play: Play) -> None:
    shown = screen(
        f'<text id="a" {AT}>Hello {{user.name}}</text><image id="b" {AT} src="{{pic}}.png"/>'
        f'<button id="c" {AT}>{{n}}</button>',
        background="{pic}-wall.png",
    )
    trace = play(state("1", shown), [], tags={"user.name": "Ann", "pic": "nurse", "n": 2.0})
    assert trace.lines("screen") == ["0 screen app 1 [a=Hello Ann b=nurse.png c=2] <enter"]
    assert trace.one("screen")["background"] == "nurse-wall.png"


def test_a_missing_value_on_a_screen_is_nothing_with_a_warning(play: Play) -> None:
    trace = play(state("1", screen(f'<text id="a" {AT}>Hello {{user.name}}!</text>')), [])
    assert trace.lines("screen", "warning") == [
        "0 warning user.name has no value <enter",
        "0 screen app 1 [a=Hello !] <enter",
    ]


# -- touches -----------------------------------------------------------------


def test_touched_is_the_event_of_a_touch_on_no_component(play: Play) -> None:
    trace = play(state("1", screen(touched="woken")), [{"at": 1, "touch": True}])
    assert trace.lines("event") == ["1 event app woken <-"]


def test_a_touch_means_nothing_where_no_event_is_named(play: Play) -> None:
    trace = play(state("1", screen(f'<text id="a" {AT}>A</text>')), [{"at": 1, "touch": True}])
    assert trace.lines(since=1) == []


def test_a_touch_is_the_states_before_it_is_that_of_always(play: Play) -> None:
    always = f"<always>{screen(touched='shared')}</always>"
    rbd = always + state("1", screen(touched="own"), '<event name="own" next="2"/>')
    trace = play(rbd + state("2", ""), [{"at": 1, "touch": True}])
    assert trace.lines("event") == ["1 event app own <-"]
    trace = play(always + state("1", ""), [{"at": 1, "touch": True}])
    assert trace.lines("event") == ["1 event app shared <-"]


def test_clicks_go_to_the_application_that_holds_the_screen(play: Play) -> None:
    one = f'<application name="{{}}">{state("1", screen(touched="woken"))}</application>'
    spds = """<modules><module name="a" resources="screen"/><module name="b" resources="screen"/>
              </modules><situation name="s"><module name="a" priority="1"/>
              <module name="b" priority="2"/></situation>"""
    trace = play([one.format("a"), one.format("b")], [{"at": 1, "touch": True}], spds=spds)
    assert trace.lines(since=1) == [
        "1 event b woken <-",
        "1 ignored b woken unexpected <event",
    ]


# -- buttons -----------------------------------------------------------------


def test_a_button_raises_its_event(play: Play) -> None:
    shown = screen(f'<button id="go" {AT} event="clickGo">GO</button>')
    rbd = state("1", shown, '<event name="clickGo" next="2"/>') + state("2", "<screen/>")
    trace = play(rbd, [{"at": 1, "use": {"component": "go"}}])
    assert trace.lines("event", "transition") == [
        "1 event app clickGo <-",
        "1 transition app 1 2 clickGo <event",
    ]


@pytest.mark.parametrize(
    ("value", "written"),
    [("3", 3), ("three", "three"), ("{n}", [1]), ('{"a": "{n}"}', {"a": "[1]"}), ("", "")],
)
def test_a_button_may_also_set_a_tag_read_like_a_set(
    play: Play, value: str, written: object
) -> None:
    button = f"<button id='go' {AT} event='e' tag='x' value='{value}'>GO</button>"
    rbd = state("1", screen(button))
    trace = play(rbd, [{"at": 1, "use": {"component": "go"}}], tags={"n": [1]})
    assert trace.values("x") == [written]
    assert [e["kind"] for e in trace if e["t"] == 1] == ["data", "event", "ignored"]
    assert trace.of("data", tag="x")[0]["writer"] == "screen"


def test_a_button_that_sets_what_is_missing_deletes_with_a_warning(play: Play) -> None:
    button = f'<button id="b" {AT} tag="x" value="{{gone}}">B</button>'
    use = {"at": 1, "use": {"component": "b"}}
    trace = play(state("1", screen(button)), [use], tags={"x": 1})
    assert trace.values("x") == [1, None]
    assert trace.lines("warning") == ["1 warning gone has no value <-"]


def test_a_button_without_event_only_sets(play: Play) -> None:
    rbd = state("1", screen(f'<button id="go" {AT} tag="x" value="1">GO</button>'))
    trace = play(rbd, [{"at": 1, "use": {"component": "go"}}])
    assert trace.lines(since=1) == ["1 data x 1 screen v1 <-"]


# -- inputs ------------------------------------------------------------------


def field(kind: str = "text", more: str = "") -> str:
    return screen(f'<input id="in" {AT} tag="x" kind="{kind}" {more}/>')


@pytest.mark.parametrize("kind", ["text", "date", "pin"])
def test_an_input_writes_a_string_that_is_never_read_as_json(play: Play, kind: str) -> None:
    rbd = state("1", field(kind, 'event="entered"'))
    trace = play(rbd, [{"at": 1, "use": {"component": "in", "value": "12"}}])
    assert trace.lines("data", "event") == [
        '1 data x "12" screen v1 <-',
        "1 event app entered <-",
    ]


def test_a_number_input_writes_a_number(play: Play) -> None:
    trace = play(
        state("1", field("number")), [{"at": 1, "use": {"component": "in", "value": "12.5"}}]
    )
    assert trace.values("x") == [12.5]


@pytest.mark.parametrize("typed", ["twelve", "", "true", "[1]", '"1"'])
def test_a_number_input_takes_nothing_but_numbers(play: Play, typed: str) -> None:
    rbd = state("1", field("number", 'event="entered"'))
    trace = play(rbd, [{"at": 1, "use": {"component": "in", "value": typed}}])
    assert [e["kind"] for e in trace if e["t"] == 1] == ["warning"]


def test_an_input_shows_its_tags_value_and_follows_it(play: Play) -> None:
    trace = play(state("1", field()), [{"at": 1, "set": {"x": "b"}}], tags={"x": "a"})
    assert trace.lines("screen") == ["0 screen app 1 [in=a] <enter", "1 screen app 1 [in=b] <data"]


def test_an_input_takes_no_more_characters_than_max(play: Play) -> None:
    rbd = state("1", field("text", 'max="2" event="entered"'))
    trace = play(rbd, [{"at": 1, "use": {"component": "in", "value": "abc"}}])
    assert trace.values("x") == ["ab"]
    assert trace.lines("event") == ["1 event app entered <-"]


def test_enter_alone_raises_the_event_of_an_input(play: Play) -> None:
    rbd = state("1", field("text", 'event="entered"'))
    trace = play(rbd, [{"at": 1, "use": {"component": "in"}}], tags={"x": "a"})
    assert trace.lines("event", "data", since=1) == ["1 event app entered <-"]


# -- lists -------------------------------------------------------------------

PATIENTS = [{"name": "Ann", "room": 7}, {"name": "Bo", "room": 8.0}]
LIST = f"""<list id="names" {AT} items="patients" label="{{item.name}}, room {{item.room}} {{w}}"
           tag="patient" event="chosen"/>"""


def test_a_list_shows_its_items_by_label(play: Play) -> None:
    trace = play(state("1", screen(LIST)), [], tags={"patients": PATIENTS, "w": "!"})
    assert components(trace)[0]["items"] == [
        {"label": "Ann, room 7 !", "value": PATIENTS[0]},
        {"label": "Bo, room 8 !", "value": PATIENTS[1]},
    ]


def test_a_list_without_label_shows_its_items_themselves(play: Play) -> None:
    plain = f'<list id="names" {AT} items="names"/>'
    trace = play(state("1", screen(plain)), [], tags={"names": ["Ann", 2]})
    assert [item["label"] for item in components(trace)[0]["items"]] == ["Ann", "2"]


def test_the_chosen_item_goes_whole_to_the_tag_then_comes_the_event(play: Play) -> None:
    chosen = {"name": "Ann", "room": 7}
    trace = play(
        state("1", screen(LIST)),
        [{"at": 1, "use": {"component": "names", "value": chosen}}],
        tags={"patients": PATIENTS, "w": "!"},
    )
    assert trace.lines(since=1) == [
        '1 data patient {"name":"Ann","room":7} screen v1 <-',
        "1 event app chosen <-",
        "1 ignored app chosen unexpected <event",
    ]


def test_a_list_follows_its_items(play: Play) -> None:
    lines = [{"at": 1, "set": {"patients": [{"name": "Cy", "room": 9}]}}]
    trace = play(state("1", screen(LIST)), lines, tags={"w": "!"})
    assert [c["components"][0]["items"] for c in trace.of("screen")] == [
        [],
        [{"label": "Cy, room 9 !", "value": {"name": "Cy", "room": 9}}],
    ]


def test_what_is_not_shown_can_not_be_used(play: Play) -> None:
    rbd = state("1", screen(f'<text id="a" {AT}>A</text>'))
    for name in ("nothing", "a"):
        trace = play(rbd, [{"at": 1, "use": {"component": name}}])
        assert [e["kind"] for e in trace if e["t"] == 1] == ["warning"]
    trace = play(state("1", ""), [{"at": 1, "use": {"component": "a"}}])
    assert [e["kind"] for e in trace if e["t"] == 1] == ["warning"]


# -- what stays --------------------------------------------------------------

HELLO = screen(f'<text id="hello" {AT}>Hello</text>')
GO = '<event name="go" next="2"/>'


def test_an_empty_screen_clears_and_gives_the_resource_back(play: Play) -> None:
    trace = play(state("1", HELLO, GO) + state("2", "<screen/>"), [{"at": 1, "event": "go"}])
    assert trace.lines(since=1)[3:] == [
        "1 enter app 2 <transition",
        "1 abandon app [screen] <enter",
        "1 authority screen app - <abandon",
        "1 mapping screen - null <authority",
        "1 screen app 2 [] <enter",
    ]


def test_an_empty_screen_keeps_that_of_always(play: Play) -> None:
    home = screen(f'<button id="home" {AT}>Home</button>')
    rbd = f"<always>{home}</always>" + state("1", HELLO, GO) + state("2", "<screen/>")
    trace = play(rbd, [{"at": 1, "event": "go"}])
    assert trace.lines(since=1)[3:] == [
        "1 enter app 2 <transition",
        "1 screen app 2 [home=Home] <enter",
        "1 mapping screen app [home=Home] <screen",
    ]


def test_a_state_without_screen_keeps_what_was_shown_and_the_resource(play: Play) -> None:
    trace = play(state("1", HELLO, GO) + state("2", ""), [{"at": 1, "event": "go"}])
    assert trace.lines(since=1)[3:] == ["1 enter app 2 <transition"]


def test_a_kept_screen_can_be_used(play: Play) -> None:
    shown = screen(f'<button id="b" {AT} event="pressed">B</button>')
    rbd = state("1", shown, GO) + state("2", "")
    trace = play(rbd, [{"at": 1, "event": "go"}, {"at": 2, "use": {"component": "b"}}])
    assert trace.lines("event", since=2) == ["2 event app pressed <-"]


def test_a_kept_screen_is_shown_again_after_a_suspension(play: Play) -> None:
    rbd = state("1", HELLO, GO) + state("2", "")
    lines = [
        {"at": 1, "event": "go"},
        {"at": 2, "set": {"busy": True}},
        {"at": 3, "set": {"busy": False}},
    ]
    trace = play(rbd, lines, pauses="screen")
    assert trace.lines("screen", "suspend", "resume") == [
        "0 screen app 1 [hello=Hello] <enter",
        "2 suspend app [screen] <authority",
        "3 resume app [] <authority",
        "3 screen app 2 [hello=Hello] <resume",
    ]


def test_a_kept_screen_is_shown_again_where_resumed_leads_on(play: Play) -> None:
    rbd = state("1", HELLO, '<event name="resumed" next="2"/>') + state("2", "")
    lines = [{"at": 1, "set": {"busy": True}}, {"at": 2, "set": {"busy": False}}]
    trace = play(rbd, lines, pauses="screen")
    assert trace.lines("screen", "enter")[-2:] == [
        "2 enter app 2 <transition",
        "2 screen app 2 [hello=Hello] <enter",
    ]


def test_a_screen_that_was_never_shown_is_not_kept(play: Play) -> None:
    other = screen(f'<text id="other" {AT}>Other</text>')
    rbd = (
        state("1", HELLO, GO)
        + state(
            "2",
            f'{other}<backgroundactions><robot resource="head" command="nod"/></backgroundactions>',
            '<event name="resumed" next="3"/>',
        )
        + state("3", "")
    )
    lines = [
        {"at": 1, "acquire": {"module": "m", "resources": ["head"]}},
        {"at": 2, "event": "go"},
        {"at": 3, "abandon": {"module": "m", "resources": ["head"]}},
    ]
    spds = """<modules><module name="app" resources="screen head"/>
              <module name="m" resources="head"/></modules>
              <situation name="s"><module name="m" priority="2"/>
              <module name="app" priority="1"/></situation>"""
    trace = play(rbd, lines, spds=spds)
    assert trace.lines("screen", "suspend", "resume", "enter") == [
        "0 enter app 1 <-",
        "0 screen app 1 [hello=Hello] <enter",
        "2 enter app 2 <transition",
        "2 suspend app [head screen] <authority",
        "3 resume app [] <authority",
        "3 enter app 3 <transition",
        "3 screen app 3 [hello=Hello] <enter",
    ]


# -- live texts --------------------------------------------------------------

LIVE = state("1", screen(f'<text id="a" {AT}>{{n}} and {{m}}</text>'))


def test_a_text_with_references_follows_later_changes(play: Play) -> None:
    trace = play(LIVE, [{"at": 1, "set": {"n": 2}}], tags={"n": 1, "m": 1})
    assert trace.lines(since=1) == [
        "1 data n 2 scenario v2 <-",
        "1 screen app 1 [a=2 and 1] <data",
        "1 mapping screen app [a=2 and 1] <screen",
    ]


def test_a_live_screen_is_shown_once_a_step(play: Play) -> None:
    trace = play(LIVE, [{"at": 1, "set": {"n": 2, "m": 3}}], tags={"n": 1, "m": 1})
    assert trace.lines("screen", since=1) == ["1 screen app 1 [a=2 and 3] <data"]


def test_a_live_screen_warns_of_what_has_come_to_be_missing(play: Play) -> None:
    lines = [{"at": 1, "set": {"n": None}}, {"at": 2, "set": {"m": 2}}]
    assert play(LIVE, lines, tags={"n": 1, "m": 1}).lines("warning", "screen", since=1) == [
        "1 warning n has no value <data",
        "1 screen app 1 [a= and 1] <data",
        "2 screen app 1 [a= and 2] <data",
    ]


def test_a_live_screen_comes_at_the_end_of_the_step(play: Play) -> None:
    rbd = state(
        "1",
        screen(f'<text id="a" {AT}>{{n}}</text>'),
        '<event name="go"><set tag="n">2</set><message topic="t" done="sent"/></event>',
    )
    trace = play(rbd, [{"at": 1, "event": "go"}], tags={"n": 1})
    assert [e["kind"] for e in trace if e["t"] == 1] == [
        "event", "action", "data", "finished", "action", "finished", "event", "ignored",
        "screen", "mapping",
    ]  # fmt: skip


def test_a_screen_that_shows_the_same_is_not_shown_again(play: Play) -> None:
    lines = [{"at": 1, "set": {"n": 1}}, {"at": 2, "set": {"other": 1}}]
    trace = play(LIVE, lines, tags={"n": 1, "m": 1})
    assert trace.lines("screen", since=1) == []


def test_a_kept_screen_follows_too_and_names_the_state_then_current(play: Play) -> None:
    rbd = state("1", screen(f'<text id="a" {AT}>{{n}}</text>'), GO) + state("2", "")
    trace = play(rbd, [{"at": 1, "event": "go"}, {"at": 2, "set": {"n": 2}}], tags={"n": 1})
    assert trace.lines("screen", since=2) == ["2 screen app 2 [a=2] <data"]


def test_fields_of_a_value_are_followed_too(play: Play) -> None:
    rbd = state("1", screen(f'<text id="a" {AT}>{{user.name}}</text>'))
    trace = play(rbd, [{"at": 1, "set": {"user": {"name": "Bo"}}}], tags={"user": {"name": "Ann"}})
    assert trace.lines("screen") == ["0 screen app 1 [a=Ann] <enter", "1 screen app 1 [a=Bo] <data"]


def test_a_suspended_application_shows_no_live_text(play: Play) -> None:
    lines = [{"at": 1, "set": {"busy": True}}, {"at": 2, "set": {"n": 2}}]
    trace = play(LIVE, lines, tags={"n": 1, "m": 1}, pauses="screen")
    assert trace.lines("screen", since=1) == []


def test_a_screen_follows_the_language(play: Play) -> None:
    rbd = state("1", screen(f'<text id="a" {AT}>Hello</text>'))
    trace = play(
        rbd,
        [{"at": 1, "set": {"language": "ja"}}],
        languages=("en", "ja"),
        texts={"ja": {"Hello": "こんにちは"}},
    )
    assert trace.lines("screen") == [
        "0 screen app 1 [a=Hello] <enter",
        "1 screen app 1 [a=こんにちは] <data",
    ]


# -- movies ------------------------------------------------------------------

MOVIE = screen(f'<movie id="intro" {AT} src="intro.webm" done="movieDone"/>')


def test_a_movie_is_an_action_of_its_screen(play: Play) -> None:
    trace = play(state("1", MOVIE), [{"at": 5, "finish": {"action": "movie", "name": "intro"}}])
    assert trace.lines(but=RESOURCES) == [
        "0 enter app 1 <-",
        "0 screen app 1 [intro=intro.webm] <enter",
        '0 action app 1 movie intro src="intro.webm" <screen',
        "5 finished app movie intro ok null <-",
        "5 event app movieDone <finished",
        "5 ignored app movieDone unexpected <event",
    ]


def test_a_movie_that_can_not_be_played_raises_its_failed(play: Play) -> None:
    film = screen(f'<movie id="intro" {AT} src="intro.webm" done="over" failed="noFilm"/>')
    away = '<event name="noFilm" next="2"/>'
    end = {"finish": {"action": "movie", "name": "intro", "ok": False, "error": "not a film"}}
    trace = play(state("1", film, away) + state("2", ""), [{"at": 5, **end}])
    assert trace.lines("finished", "event", "enter", since=5) == [
        '5 finished app movie intro failed "not a film" <-',
        "5 event app noFilm <finished",
        "5 enter app 2 <transition",
    ]


def test_a_movie_goes_on_while_its_screen_is_kept(play: Play) -> None:
    trace = play(state("1", MOVIE, GO) + state("2", ""), [{"at": 1, "event": "go"}])
    assert trace.lines("cancelled") == []


@pytest.mark.parametrize("after", ["<screen/>", HELLO])
def test_a_movie_ends_with_its_screen(play: Play, after: str) -> None:
    trace = play(state("1", MOVIE, GO) + state("2", after), [{"at": 1, "event": "go"}])
    assert trace.lines("cancelled", "enter", since=1) == [
        "1 enter app 2 <transition",
        "1 cancelled app movie intro <enter",
    ]


def test_a_movie_cut_off_by_a_suspension_begins_again(play: Play) -> None:
    lines = [{"at": 1, "set": {"busy": True}}, {"at": 2, "set": {"busy": False}}]
    trace = play(state("1", MOVIE), lines, pauses="screen")
    assert trace.lines("action", "cancelled") == [
        '0 action app 1 movie intro src="intro.webm" <screen',
        "1 cancelled app movie intro <suspend",
        '2 action app 1 movie intro src="intro.webm" <screen',
    ]


def test_a_movie_that_ended_is_not_played_again_after_a_suspension(play: Play) -> None:
    lines = [
        {"at": 1, "finish": {"action": "movie"}},
        {"at": 2, "set": {"busy": True}},
        {"at": 3, "set": {"busy": False}},
    ]
    trace = play(state("1", MOVIE), lines, pauses="screen")
    assert len(trace.of("screen")) == 2
    assert trace.lines("action", since=1) == []


def test_a_movie_plays_again_when_its_state_is_entered_anew(play: Play) -> None:
    rbd = state("1", MOVIE, '<event name="more" next="#again"/>')
    lines = [{"at": 1, "finish": {"action": "movie"}}, {"at": 2, "event": "more"}]
    assert len(play(rbd, lines).of("action")) == 2
