"""docs/semantics.md, *Deploy*: what still exists is kept, and what follows from the rest."""

from __future__ import annotations

import pytest
from tests.decide.test_deploy import ANN, HELLO, Run, event, state, texts

from situ.decide import inputs

AT = 'x="1" y="1" width="9" height="9"'


def screen(text: str, more: str = "") -> str:
    return f'<screen><components><text id="t" {AT}>{text}</text>{more}</components></screen>'


def timeout(seconds: float, more: str = 'next="2"') -> str:
    return f"<timeout {more}>{seconds}</timeout>"


def entered(run: Run) -> list[tuple[float, str]]:
    return run.trace.states()


# -- states ------------------------------------------------------------------


def test_an_application_stays_in_its_state_and_its_events_are_the_new_ones() -> None:
    old = texts(state("1", events=event("go", "2")) + state("2") + state("3"))
    new = texts(state("1", events=event("go", "3")) + state("2") + state("3"))
    run = Run(old).deploy(1, new)
    assert run.since(1) == []
    assert entered(run.at(2, inputs.Raise("go"))) == [(0, "1"), (2, "3")]


def test_where_its_state_is_gone_it_starts_again_with_a_warning() -> None:
    service = '<service name="s" url="http://x/" keep="true"/><launch program="p"/>'
    go = '<event name="go" next="2"/>'
    old = texts(state("1", events=go) + state("2", screen("A"), actions=HELLO + service))
    new = texts(state("7", screen("B")) + state("8", actions=service))
    run = Run(old).at(1, inputs.Raise("go")).deploy(2, new, force_after=0)
    assert run.since(2) == [
        "2 exit app 2 <deployed",
        "2 cancelled app speech - <exit",
        "2 mapping speech app null <cancelled",
        "2 cancelled app launch p <exit",
        "2 warning there is no state 2 any longer: app starts again <deployed",
        "2 enter app 7 <deployed",
        "2 abandon app [speech] <enter",
        "2 authority speech app - <abandon",
        "2 screen app 7 [t=B] <enter",
        "2 mapping screen app [t=B] <screen",
    ]
    assert run.look("application/app.state") == "7"
    # The service is of the new version too.
    assert run.at(3, inputs.Finish("service")).since(3)[0].startswith("3 finished app service s")


def test_a_kept_action_that_is_nowhere_any_longer_is_cancelled() -> None:
    service = '<service name="s" url="http://x/" keep="true"/>'
    old = texts(state("1", events=event("go", "2"), actions=service) + state("2"))
    for new in (texts(state("1", events=event("go", "2")) + state("2")), texts(state("7"))):
        run = Run(old).at(1, inputs.Raise("go")).deploy(2, new, force_after=0)
        assert "2 cancelled app service s <deployed" in run.since(2)


def test_states_of_parts_are_known_by_their_paths() -> None:
    part = '<state no="5"><flow src="p.rbd.xml"/></state>'
    inner = state("q", events=event("go", "r")) + state("r", events=event("go", "q"))
    old = texts(part, p=inner)
    run = Run(old).at(1, inputs.Raise("go")).deploy(2, texts(part + state("6"), p=inner))
    assert run.since(2) == []
    run.deploy(3, texts(part, p=state("q")))
    assert run.trace.lines("exit", "enter", since=3) == [
        "3 exit app 5/r <deployed",
        "3 exit app 5 <deployed",
        "3 enter app 5 <deployed",
        "3 enter app 5/q <enter",
    ]


def test_back_leads_to_the_states_that_are_there_still() -> None:
    ways = event("a", "1") + event("b", "2") + event("c", "3") + event("back", "#back")
    three = [state(no, events=ways) for no in "0123"]
    new = [text.replace(event("b", "2"), "") for text in (three[0], three[1], three[3])]
    run = Run(texts("".join(three)))
    for second, name in enumerate("abc", 1):
        run.at(second, inputs.Raise(name))
    run.deploy(4, texts("".join(new))).at(5, inputs.Raise("back"), inputs.Raise("back"))
    assert entered(run)[-2:] == [(5, "1"), (5, "0")]


def test_what_waits_in_a_paused_application_is_judged_by_the_new_version() -> None:
    old = texts(state("1", timeout(3), event("go", "2")) + state("2") + state("3"))
    new = texts(state("1", timeout(3), event("go", "3")) + state("2") + state("3"))
    run = Run(old).at(1, inputs.Pause(ANN), inputs.Raise("go")).deploy(2, new)
    assert run.since(2) == []
    assert entered(run.at(9, inputs.Resume(ANN))) == [(0, "1"), (9, "3")]


def test_what_waits_for_it_waits_over_a_new_start() -> None:
    run = Run(texts(state("1"))).at(1, inputs.Pause(ANN), inputs.Raise("go"))
    run.deploy(2, texts(state("7", events=event("go", "8")) + state("8")))
    assert entered(run.at(3, inputs.Resume(ANN))) == [(0, "1"), (2, "7"), (3, "8")]


def test_a_suspended_application_that_starts_again_is_suspended_still() -> None:
    old, new = (texts(state(no, screen("A")), PAUSING) for no in "17")
    run = Run(old).at(1, BUSY).deploy(2, new).at(3, CALM)
    assert run.trace.lines("suspend", "resume", "screen", since=2) == [
        "3 resume app [] <authority",
        "3 screen app 7 [t=A] <resume",
    ]


def test_a_movie_ends_with_its_state() -> None:
    movie = f'<screen><components><movie id="m" {AT} src="a.webm"/></components></screen>'
    run = Run(texts(state("1", movie))).deploy(2, texts(state("7")), force_after=0)
    assert "2 cancelled app movie m <deployed" in run.since(2)


def test_a_state_may_have_another_name() -> None:
    run = Run(texts(state("1"))).deploy(1, texts(state("1").replace('no="1"', 'no="1" name="b"')))
    assert run.look("application/app.name") == "b"


def test_a_paused_application_that_starts_again_stays_paused() -> None:
    run = Run(texts(state("1"))).at(1, inputs.Pause(ANN))
    run.deploy(2, texts(state("2", timeout(3, 'next="3"')) + state("3")))
    assert entered(run.at(20, inputs.Resume(ANN)).at(22)) == [(0, "1"), (2, "2")]
    assert entered(run.at(23))[-1] == (23, "3")
    actions = '<service name="s" url="http://x/" wait="true"/><launch program="p"/>'
    run = Run(texts(state("1"))).at(1, inputs.Pause(ANN))
    run.deploy(2, texts(state("2", actions=actions))).at(3, inputs.Finish("service"))
    assert run.trace.of("action", action="launch") == []
    assert run.at(4, inputs.Resume(ANN)).trace.one("action", action="launch")["t"] == 4


# -- the timeout -------------------------------------------------------------


@pytest.mark.parametrize(("new", "due"), [(4, 4), (20, 20), (0.5, 3)])
def test_a_timeout_counts_on_from_the_entry_under_the_new_length(new: float, due: float) -> None:
    run = Run(texts(state("1", timeout(10)) + state("2")))
    run.deploy(3, texts(state("1", timeout(new)) + state("2")))
    assert entered(run.at(30)) == [(0, "1"), (due, "2")]
    assert run.trace.cause(run.trace.one("transition")) == run.trace.of("enter")[0]


def test_a_new_timeout_counts_from_the_deploy_and_one_that_is_gone_no_longer() -> None:
    with_it, without = texts(state("1", timeout(5)) + state("2")), texts(state("1") + state("2"))
    run = Run(without).deploy(3, with_it)
    assert run.trace.cause(run.at(30).trace.one("transition")) == run.trace.one("deployed")
    assert entered(run) == [(0, "1"), (8, "2")]
    assert entered(Run(with_it).deploy(3, without).at(30)) == [(0, "1")]


PAUSING = """<modules><module name="app" resources="screen speech"/></modules>
<situation name="busy"><condition><data tag="busy" is="true"/></condition></situation>
<situation name="calm"><module name="app" priority="1"/></situation>"""
BUSY, CALM = inputs.Set({"busy": True}, "m"), inputs.Set({"busy": False}, "m")


@pytest.mark.parametrize(("old", "new", "due"), [(10, 4, 23), (10, 0.5, 20), (None, 4, 24)])
def test_the_timeout_of_a_suspended_application_stands_still(
    old: float | None, new: float, due: float
) -> None:
    def files(seconds: float | None) -> dict[str, str]:
        counts = "" if seconds is None else timeout(seconds)
        return texts(state("1", counts + screen("A")) + state("2"), PAUSING)

    run = Run(files(old)).at(1, BUSY).deploy(5, files(new)).at(20, CALM).at(40)
    assert entered(run) == [(0, "1"), (due, "2")]


def test_a_timeout_that_comes_to_be_idle_or_no_longer_is_counts_so() -> None:
    def files(more: str) -> dict[str, str]:
        return texts(state("1", timeout(10, f'next="2" {more}'), actions=HELLO) + state("2"))

    idle, plain = files('idle="true"'), files("")
    run = Run(idle).deploy(4, plain, force_after=0)
    assert entered(run.at(30)) == [(0, "1"), (14, "2")]
    run = Run(plain).deploy(4, idle, force_after=0).at(20, inputs.Finish("speech"))
    assert entered(run.at(40)) == [(0, "1"), (30, "2")]


# -- screen ------------------------------------------------------------------


def test_a_state_that_is_the_same_is_not_shown_again() -> None:
    movie = f'<movie id="m" {AT} src="a.webm"/>'
    one = state("1", screen("A", movie), event("go", "2"), HELLO)
    always = f"<always>{screen('{x}')}</always>".replace('id="t"', 'id="u"')
    old = texts(always + one + state("2"))
    new = texts(always + one + state("2", screen("B")) + state("3"), toml="[tags]\ny = 1\n")
    run = Run(old).deploy(1, new, force_after=0)
    assert run.since(1) == ["1 data y 1 project v1 <deployed"]
    assert run.at(2, inputs.Set({"x": 5}, "m")).trace.lines("screen", since=2) == [
        "2 screen app 1 [t=A m=a.webm u=5] <data"
    ]


def test_a_screen_that_is_another_is_shown() -> None:
    run = Run(texts(state("1", screen("A")))).deploy(1, texts(state("1", screen("B"))))
    assert run.since(1) == [
        "1 screen app 1 [t=B] <deployed",
        "1 mapping screen app [t=B] <screen",
    ]
    run.deploy(2, texts(state("1", "<screen/>")))
    assert run.since(2) == [
        "2 abandon app [screen] <deployed",
        "2 authority screen app - <deployed",
        "2 mapping screen - null <authority",
        "2 screen app 1 [] <deployed",
    ]
    run.deploy(3, texts(state("1", screen("C"))))
    assert run.since(3, "mapping", "authority") == [
        "3 acquire app [screen] <deployed",
        "3 screen app 1 [t=C] <deployed",
    ]


def test_a_screen_that_is_kept_stays_while_its_state_has_it() -> None:
    shown = state("1", screen("A"), event("go", "2"))
    old = texts(shown + state("2"))
    for new, traced in [
        (texts(shown + state("2") + state("3")), []),
        (texts(shown.replace(">A<", ">B<") + state("2")), ["2 screen app 2 [t=B] <deployed"]),
        (texts(state("1") + state("2")), ["2 screen app 2 [] <deployed"]),
        (texts(state("2")), ["2 screen app 2 [] <deployed"]),
    ]:
        run = Run(old).at(1, inputs.Raise("go")).deploy(2, new)
        assert run.trace.lines("screen", since=2) == traced


def test_other_translations_are_shown_at_once() -> None:
    toml = '[tags]\nlanguage = "ja"\n'
    one = texts(state("1", screen("A")), toml=toml)
    one["situ.toml"] = one["situ.toml"].replace("[project]", '[project]\nlanguages = ["en", "ja"]')
    po = 'msgid ""\nmsgstr "Content-Type: text/plain; charset=UTF-8\\n"\n\nmsgid "A"\nmsgstr "{}"\n'
    run = Run({**one, "texts/ja.po": po.format("い")})
    run.deploy(1, {**one, "texts/ja.po": po.format("ろ")})
    assert run.trace.lines("screen", since=1) == ["1 screen app 1 [t=ろ] <deployed"]


def test_a_suspended_application_shows_the_new_screen_when_it_goes_on() -> None:
    old, new = (texts(state("1", screen(text)), PAUSING) for text in "AB")
    run = Run(old).at(1, BUSY).deploy(2, new)
    assert run.since(2) == []
    assert run.at(3, CALM).trace.lines("screen", since=3) == ["3 screen app 1 [t=B] <resume"]


def test_a_state_entered_suspended_begins_as_the_new_version_has_it() -> None:
    old, new = (texts(state("1", timeout(5) + screen(t)) + state("2"), PAUSING) for t in "AB")
    run = Run({**old, "situ.toml": old["situ.toml"] + "[tags]\nbusy = true\n"})
    run.deploy(2, new).at(3, CALM).at(30)
    assert run.trace.lines("screen") == ["3 screen app 1 [t=B] <resume"]
    assert entered(run)[-1] == (8, "2")


# -- actions -----------------------------------------------------------------


def says(*told: str, more: str = "") -> dict[str, str]:
    speeches = "".join(f'<speech wait="true">{one}</speech>' for one in told)
    return texts(state("1", events=event("go", "2"), actions=speeches + more) + state("2"))


def spoken(run: Run, since: float = 0) -> list[str]:
    return [e["text"] for e in run.trace.of("action", action="speech") if e["t"] >= since]


def test_an_action_that_the_state_still_has_goes_on_where_it_is_forced() -> None:
    run = Run(says("A", "B")).deploy(1, says("A", "C", "D"), force_after=0)
    assert run.since(1) == []
    run.at(2, inputs.Finish("speech")).at(3, inputs.Finish("speech"))
    assert spoken(run) == ["A", "C", "D"]


def test_one_that_it_has_no_longer_is_cancelled_and_what_waited_begins() -> None:
    run = Run(says("A", "B")).deploy(1, says("X", "B"), force_after=0)
    assert run.since(1, "mapping")[0] == "1 cancelled app speech - <deployed"
    assert spoken(run) == ["A", "X"]


def test_where_all_had_begun_nothing_begins_that_is_new() -> None:
    run = Run(says()).deploy(1, says("A", "B"))
    assert run.since(1, "acquire", "authority") == []
    run = Run(texts(state("1", actions=HELLO)))
    run.deploy(1, texts(state("1", actions=HELLO + '<launch program="p"/>')), force_after=0)
    assert run.trace.of("action", action="launch") == []


def test_speeches_that_wait_for_their_turn_are_taken_over_or_dropped() -> None:
    def files(*told: str) -> dict[str, str]:
        return texts(state("1", actions="".join(f"<speech>{one}</speech>" for one in told)))

    run = Run(files("A", "B", "C")).deploy(1, files("A", "C"), force_after=0)
    run.at(2, inputs.Finish("speech")).at(3, inputs.Finish("speech"))
    assert spoken(run) == ["A", "C"]
    run = Run(files("A", "B")).deploy(1, files("B"), force_after=0)
    assert spoken(run, since=1) == ["B"]


def test_what_an_event_began_goes_on_or_ends_too() -> None:
    service = '<service name="{}" url="http://x/" wait="true"/>'

    def files(*names: str) -> dict[str, str]:
        actions = "".join(map(service.format, names))
        return texts(state("1", events=f'<event name="go">{actions}</event>'))

    run = Run(files("a", "b")).at(1, inputs.Raise("go")).deploy(2, files("a"), force_after=0)
    assert run.since(2) == []
    assert run.at(3, inputs.Finish("service")).since(3, "data") == [
        "3 finished app service a ok null <-"
    ]
    run = Run(files("a", "b")).at(1, inputs.Raise("go"))
    run.deploy(2, files("a", "b", "c"), force_after=0)
    assert run.since(2) == []
    assert run.at(3, inputs.Finish("service")).trace.one("action", name="b")["t"] == 3
    run = Run(files("a", "b")).at(1, inputs.Raise("go")).deploy(2, files("b"), force_after=0)
    assert run.since(2)[0] == "2 cancelled app service a <deployed"
    assert run.trace.one("action", name="b")["t"] == 2


def test_what_was_cut_off_by_a_suspension_begins_again_where_it_is_there_still() -> None:
    def files(told: str) -> dict[str, str]:
        return texts(state("1", actions=f"<speech>{told}</speech>"), PAUSING)

    assert spoken(Run(files("A")).at(1, BUSY).deploy(2, files("A")).at(3, CALM)) == ["A", "A"]
    assert spoken(Run(files("A")).at(1, BUSY).deploy(2, files("B")).at(3, CALM)) == ["A"]


def test_a_new_event_without_name_that_holds_is_taken_at_once() -> None:
    waits = '<event next="{}"><when><data tag="x" is="1"/></when></event>'
    old = texts(state("1") + state("2"), toml="[tags]\nx = 1\n")
    new = texts(state("1", events=waits.format("2")) + state("2"))
    run = Run(old).deploy(1, new)
    assert run.trace.lines("transition") == ["1 transition app 1 2 - <deployed"]
    kept = waits.format("2").replace("1", "2", 1).replace('is="1"', 'is="2"')
    run = Run(texts(state("1", events=kept) + state("2")))
    run.at(1, inputs.Pause(ANN), inputs.Set({"x": 2}, "m"))
    run.deploy(2, texts(state("1", events=kept) + state("2") + state("3")))
    assert entered(run.at(3, inputs.Resume(ANN)))[-1] == (3, "2")


# -- resources ---------------------------------------------------------------


def test_a_state_that_uses_something_else_asks_for_it() -> None:
    old, new = (
        texts(state("1", actions=HELLO)),
        texts(state("1", actions='<robot resource="arm" command="wave"/>')),
    )
    run = Run(old).at(1, inputs.Finish()).deploy(2, new)
    assert run.since(2) == [
        "2 acquire app [arm] <deployed",
        "2 authority arm - app <deployed",
        "2 authority speech app - <deployed",
    ]


def contested(rbd: str) -> dict[str, str]:
    """``m`` comes before the application."""
    declared = '<module name="app" resources="speech"/><module name="m" resources="speech"/>'
    given = '<module name="app" priority="1"/><module name="m" priority="2"/>'
    return texts(rbd, f'<modules>{declared}</modules><situation name="s">{given}</situation>')


def test_one_that_can_not_have_it_is_suspended() -> None:
    quiet, speaks = contested(state("1")), contested(state("1", actions=HELLO))
    run = Run(quiet).at(1, inputs.Acquire("m", ("speech",))).deploy(2, speaks)
    assert run.since(2) == [
        "2 acquire app [speech] <deployed",
        "2 suspend app [speech] <acquire",
    ]
    run.deploy(3, quiet)
    assert run.since(3) == [
        "3 abandon app [speech] <deployed",
        "3 resume app [] <abandon",
        "3 event app resumed <resume",
    ]


def test_who_it_needs_and_who_is_absent_is_warned_of() -> None:
    needs = '<module name="app" resources="speech"><requires module="voice"/></module>'
    run = Run(texts(state("1"), modules=needs))
    run.deploy(1, texts(state("1", actions=HELLO), modules=needs))
    assert "1 warning app needs voice, which is absent <acquire" in run.since(1)


# -- applications ------------------------------------------------------------


def named(name: str, inside: str) -> str:
    return f'<application name="{name}">{inside}</application>'


TWO = """<modules><module name="a" resources="screen speech"/>
<module name="b" resources="screen speech"/></modules>
<situation name="s"><module name="a" priority="1"/><module name="b" priority="2"/></situation>"""


def test_new_applications_start_and_those_that_are_gone_end() -> None:
    service = '<service name="s" url="http://x/" keep="true"/>'
    a = named("a", state("1", screen("A")))
    b = named("b", state("1", screen("B"), actions=HELLO + service))
    run = Run(texts([a, b], TWO)).deploy(1, texts([a], TWO), force_after=0)
    assert run.since(1) == [
        "1 exit b 1 <deployed",
        "1 cancelled b speech - <exit",
        "1 mapping speech b null <cancelled",
        "1 cancelled b service s <deployed",
        "1 abandon b [screen speech] <deployed",
        "1 authority screen b a <deployed",
        "1 mapping screen a null <authority",
        "1 authority speech b - <deployed",
        "1 resume a [] <authority^1",
        "1 event a resumed <resume",
        "1 screen a 1 [t=A] <resume",
        "1 mapping screen a [t=A] <screen",
    ]
    assert run.look("application/b") is None
    run.deploy(2, texts([b, a], TWO))
    assert run.trace.lines("enter", "suspend", since=2) == [
        "2 enter b 1 <deployed",
        "2 suspend a [screen] <authority^1",
    ]


def test_timers_go_with_their_applications_when_their_order_changes() -> None:
    service = '<service name="s" url="http://x/"/>'
    a, b = (
        named(name, state("1", timeout(seconds), actions=service) + state("2"))
        for name, seconds in (("a", 9), ("b", 7))
    )
    run = Run(texts([a, b], TWO), auto_finish=3)
    run.deploy(1, texts([b, a], TWO), force_after=0).at(20)
    told = [(e["t"], e["kind"], e["application"]) for e in run.trace.of("finished", "transition")]
    assert told == [
        (3, "finished", "a"),
        (3, "finished", "b"),
        (7, "transition", "b"),
        (9, "transition", "a"),
    ]


# -- data --------------------------------------------------------------------


def test_tags_of_the_project_are_set_where_they_never_were() -> None:
    old = texts(state("1"), toml="[tags]\na = 1\nb = 1\n")
    run = Run(old).at(1, inputs.Set({"a": 5, "b": None, "c": 1}, "m"))
    run.deploy(2, texts(state("1"), toml="[tags]\na = 2\nb = 2\nc = 2\nd = 2\n"))
    assert run.since(2) == ["2 data d 2 project v1 <deployed"]


def test_what_is_heard_is_by_the_new_version() -> None:
    says_ = '<event name="go" next="2"><say>{}</say></event>'
    old = texts(state("1", events=says_.format("go")) + state("2"))
    run = Run(old).deploy(1, texts(state("1", events=says_.format("on")) + state("2")))
    assert run.look("listen") == ["on"]
    run.at(2, inputs.Set({"heard": {"text": "on"}}, "m"))
    assert entered(run)[-1] == (2, "2")
    run = Run(old).deploy(1, texts(state("1") + state("2")))
    assert run.look("listen") == []


def test_chance_goes_on() -> None:
    take = '<take from="l" tag="x" order="random"/>'
    old = texts(
        state("1", events=f'<event name="go">{take}</event>'),
        toml=f"[tags]\nl = {list(range(50))}\n",
    )
    runs = [Run(old, seed=3), Run(old, seed=3)]
    runs[1].deploy(0.5, {**old, "robot.local.toml": ""})
    for run in runs:
        for second in range(1, 9):
            run.at(second, inputs.Raise("go"))
    assert runs[0].trace.values("x") == runs[1].trace.values("x")


# -- the debugger ------------------------------------------------------------


def test_breakpoints_that_fit_no_longer_are_taken_away() -> None:
    calm = '<situation name="s"><module name="app" priority="1"/></situation>'
    declared = '<modules><module name="app" resources="screen"/></modules>'
    last = '<situation name="t"/>'
    condition = '<condition><data tag="x" is="1"/></condition>'
    both = declared + calm.replace('name="s">', f'name="s">{condition}', 1) + last
    run = Run(texts(state("1") + state("2"), both))
    run.at(1, inputs.Break(ANN, state="1", when='<data tag="x" is="1"/>'))
    run.at(1, inputs.Break(ANN, state="2"), inputs.Break(ANN, situation="s"))
    run.at(2, inputs.Goto(ANN, "2"))
    assert run.look("debugger.paused") == {"app": 2}
    run.deploy(3, texts(state("1") + state("3"), declared + calm.replace('"s"', '"t"')))
    kept = [one["id"] for one in run.look("debugger.breakpoints")]
    assert kept == [1]
    told = run.trace.of("data", tag="debugger.breakpoints")[-1]
    assert run.trace.cause(told) == run.trace.one("deployed")
    assert run.look("debugger.paused") == {"app": None}
    run.deploy(
        4, texts([named("b", state("1"))], declared.replace("app", "b") + calm.replace("app", "b"))
    )
    assert (run.look("debugger.breakpoints"), run.look("debugger.paused")) == ([], {})


def test_breakpoints_that_fit_stay() -> None:
    run = Run(texts(state("1", events=event("go", "2")) + state("2")))
    run.at(1, inputs.Break(ANN, state="2"))
    run.deploy(2, texts(state("1", events=event("on", "2")) + state("2")))
    assert run.since(2) == []
    assert run.at(3, inputs.Raise("on")).trace.one("paused")["breakpoint"] == 1
