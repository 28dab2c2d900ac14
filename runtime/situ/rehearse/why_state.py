"""Why an application did not enter a state, or did not take a transition (formats.md, *RBD*)."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from itertools import pairwise

from situ.decide.intake import NOT_UNDERSTOOD
from situ.decide.program import name_of
from situ.document import words
from situ.document.project import Project
from situ.document.rbd import AGAIN, BACK, RESUMED, TIMED_OUT, Movie
from situ.rehearse.past import Past
from situ.rehearse.reason import Reason, not_held
from situ.rehearse.recording import Fields
from situ.rehearse.stays import Attempt, Stay
from situ.rehearse.telling import moment
from situ.rehearse.ways import Way, entered, frames, leads_to, name_of_state, way_words, ways
from situ.rehearse.why_held import why_suspended


class Stuck:
    """One application at one moment: its stays up to then, and the robot as it was then."""

    def __init__(self, past: Past, found: list[Stay], application: str, at: float) -> None:
        self._past = past
        self._project = past.project
        self._application = application
        self._at = at
        self._asked: set[str] = set()
        self.stays = found

    def now(self) -> list[Stay]:
        """The stays that were at the moment, in order: several where it went on in it."""
        found = [stay for stay in self.stays if stay.at(self._at)]
        # A trace may have been cut off between a transition and the state it led to.
        return found or self.stays[-1:]

    def why_not_entered(self, target: str) -> list[Reason]:
        """What kept the application from entering ``target`` at the moment."""
        if not self.stays:
            return [self.not_started()]
        found = [one for stay in self.now() for one in self._not_led(stay, target)]
        return found or self._no_way(self.now()[-1], target)

    def _not_led(self, stay: Stay, target: str) -> list[Reason]:
        found: list[Reason] = []
        for way in self._ways(stay):
            if self._leads(stay, way, target):
                found += self.why_not_taken(stay, way)
        return found

    def why_not_in(self, state: str) -> list[Reason]:
        """Why the application was elsewhere than in ``state``; empty where it was there."""
        if any(stay.is_in(state) for stay in self.now()):
            return []
        below = self.why_not_entered(state)
        if below[0].code in ("no-way", "elsewhere"):
            return below  # which says where it was
        stay = self.now()[-1]
        since = moment(stay.entered["t"])
        said = f"{self._application} was in {self._state(stay.state)} since {since}"
        seq = stay.entered["seq"]
        return [Reason(code="elsewhere", text=said, seq=seq, below=tuple(below))]

    def not_started(self) -> Reason:
        """Before its first state."""
        return Reason(code="elsewhere", text=f"{self._application} had not started yet")

    def _ways(self, stay: Stay) -> list[Way]:
        return ways(self._project, self._application, stay.state)

    def _leads(self, stay: Stay, way: Way, target: str) -> bool:
        if way.to == BACK:
            back = stay.backs.get(way.before)
            came = any(attempt.event["name"] == way.exit for attempt in stay.attempts)
            return back == target or (back is None and came)
        return leads_to(self._project, self._application, way, stay.state, target)

    def _state(self, no: str) -> str:
        return name_of_state(self._project, self._application, no)

    # -- one way -------------------------------------------------------------

    def why_not_taken(self, stay: Stay, way: Way) -> list[Reason]:
        """What kept a way out of a stay from being taken; a way that was taken leads on."""
        if way.to == BACK and stay.backs.get(way.before) is None:
            what = "the timeout" if way.event is None else way_words(way)
            said = f"{what} leads back, and there was nothing to go back to"
            return [Reason(code="back", text=said, seq=stay.entered["seq"])]
        if way.timeout is not None:
            return [self._timeout(stay, way)]
        event = way.event
        assert event is not None
        if event.name is None:
            return [self._unnamed(stay, way)]
        tries = [a for a in stay.attempts if a.event["name"] == event.name]
        if not tries:
            return [self.did_not_come(stay, event.name)]
        return [self._attempt(tries[-1], way)]

    def _attempt(self, attempt: Attempt, way: Way) -> Reason:
        """An event came and this way was not taken for it."""
        event = attempt.event
        came = f"{event['name']} came at {moment(event['t'])}"
        if attempt.suspended is not None:
            said = f"{came}, but {self.since(attempt.suspended)}"
            return self.suspended(said, attempt.suspended, attempt.blocked)
        for tried in attempt.tried:
            if tried.way.place == way.place and tried.way.file == way.file:
                if tried.passed:
                    said = f"{came} and was taken"
                    return Reason(code="note", text=said, seq=event["seq"])
                failed, values = not_held(tried.guard)
                said = f"{came}, but its guard did not hold: {'; '.join(failed)}"
                return Reason(code="guard", text=said, seq=event["seq"], values=values)
        taken = attempt.taken
        assert taken is not None
        said = f"{came}, and an event before this one took it: {self._led(taken)}"
        return Reason(code="earlier", text=said, seq=event["seq"])

    def _led(self, way: Way) -> str:
        if way.to is None:
            return f"{way_words(way)} stays"
        if way.to == BACK:
            return f"{way_words(way)} leads to back"
        to = "the same state" if way.to == AGAIN else self._state(way.to)
        return f"{way_words(way)} leads to {to}"

    def _unnamed(self, stay: Stay, way: Way) -> Reason:
        tried = next(t for t in stay.unnamed if (t.way.file, t.way.place) == (way.file, way.place))
        if not tried.passed:
            failed, values = not_held(tried.guard)
            text = f"the guard of its unnamed event did not hold: {'; '.join(failed)}"
            return Reason(code="guard", text=text, values=values)
        if stay.suspended is not None:
            said = f"its unnamed event could be taken, but {self.since(stay.suspended)}"
            return self.suspended(said, stay.suspended)
        if stay.left is None:
            said = "its unnamed event could be taken, but a livelock had ended the moment"
            return Reason(code="livelock", text=said)
        said = f"its unnamed event could be taken, but by then {self._application} was leaving"
        return Reason(code="earlier", text=said, seq=stay.left["seq"])

    def since(self, suspend: Fields) -> str:
        """That the application is suspended, since when and by what."""
        return (
            f"{self._application} was suspended since {moment(suspend['t'])}: "
            f"it did not hold {words.listed(suspend['missing'])}"
        )

    def suspended(
        self, said: str, suspend: Fields, blocked: tuple[Reason, ...] | None = None
    ) -> Reason:
        """A suspension as a reason; said: in words, with ``since``."""
        if blocked is None:
            blocked = why_suspended(self._past, self._application, suspend)
        return Reason(code="suspended", text=said, seq=suspend["seq"], below=blocked)

    def _timeout(self, stay: Stay, way: Way) -> Reason:
        assert way.timeout is not None
        length = way.timeout.seconds
        began = stay.resumed if stay.resumed is not None else stay.entered
        said = f"its timeout of {words.seconds(length)} had not run out"
        if stay.suspended is not None:
            still = f"{said}; it stands still, since {self.since(stay.suspended)}"
            return self.suspended(still, stay.suspended)
        if way.timeout.idle:
            said = f"{said}; it counts anew from the end of speech and from every touch"
        elif stay.left is None and stay.resumed is None:
            passed = round(self._at - began["t"], 6)
            # More has where it counted anew, or after the end of what is recorded.
            if passed <= length:
                said = f"{said}: {words.seconds(passed)} had passed"
        return Reason(code="timeout", text=said, seq=began["seq"])

    # -- events that did not come ---------------------------------------------

    def did_not_come(self, stay: Stay, name: str) -> Reason:
        said = (
            f"event {name} did not come while {self._application} was in "
            f"{self._state(stay.state)}, since {moment(stay.entered['t'])}"
        )
        below = []
        if name not in self._asked:
            # Two events may raise each other.
            self._asked.add(name)
            below = self._sources(stay, name)
            self._asked.discard(name)
        if stay.suspended is not None:
            besides = f"besides, {self.since(stay.suspended)}"
            below.append(self.suspended(besides, stay.suspended))
        return Reason(code="input", text=said, seq=stay.entered["seq"], below=tuple(below))

    def _sources(self, stay: Stay, name: str) -> list[Reason]:
        """What would have raised an event in this state."""
        found = [Reason(code="input", text=said) for said in self._raisers(stay, name)]
        phrases: list[str] = []
        for way in self._ways(stay):
            if way.event is None:
                continue
            if way.event.name == name:
                phrases += [say.text for say in way.event.says]
            for action in way.event.actions:
                if name in (action.done, action.failed):
                    said = f"{words.whole_action(action)} of {way_words(way)} raises it"
                    below = tuple(self.why_not_taken(stay, way))
                    found.append(Reason(code="input", text=said, below=below))
        if name == TIMED_OUT:
            found += [self._timeout(stay, w) for w in self._ways(stay) if w.timeout is not None]
        found += self._ends(stay, name)
        if phrases:
            said = f"it is what is heard as {words.listed(map(words.quoted, phrases), 'or')}"
            found.append(Reason(code="input", text=said))
        if not found:
            found.append(Reason(code="input", text=_ORIGINS.get(name, _OUTSIDE)))
        return found

    def _ends(self, stay: Stay, name: str) -> Iterator[Reason]:
        """The end states of the parts around that would tell an event, and what kept them away."""
        for frame, inside in pairwise(frames(self._project, self._application, stay.state)):
            expected = [way.exit for way in self._ways(stay) if way.before == frame.before]
            for end in inside.application.states:
                own = f"done.{end.no}"
                if not end.is_end or name not in (own, "done") or (name != own and own in expected):
                    continue
                no = inside.before + end.no
                said = f"it comes when the part enters its end state {self._state(no)}"
                below = self._not_led(stay, no) or self._no_way(stay, no)
                yield Reason(code="input", text=said, below=tuple(below))

    def _raisers(self, stay: Stay, name: str) -> Iterator[str]:
        """Components and actions of the state that raise an event."""
        for frame in frames(self._project, self._application, stay.state):
            always = frame.application.always if frame.state.always else None
            for screen in (frame.state.screen, always.screen if always is not None else None):
                if screen is None:
                    continue
                if screen.touched == name:
                    yield "a touch of the screen raises it"
                for one in screen.components:
                    if name in (getattr(one, "event", None), getattr(one, "done", None)):
                        verb = "its end" if isinstance(one, Movie) else "a person's use of it"
                        yield f"{words.component(one)} of its screen raises it by {verb}"
                    elif name == getattr(one, "failed", None):
                        yield f"{words.component(one)} of its screen raises it if it can not play"
            for action in frame.state.actions:
                for event, well in ((action.done, "well"), (action.failed, "badly")):
                    if event == name:
                        fate = _fate(stay, action.element, name_of(action))
                        yield f"{words.whole_action(action)} raises it when it ends {well}: {fate}"

    # -- far away --------------------------------------------------------------

    def _no_way(self, stay: Stay, target: str) -> list[Reason]:
        """Nothing leads there from here: the nearest way, and why not even its first step."""
        project, application = self._project, self._application
        here = self._state(stay.state)
        if not frames(project, application, target):
            return [Reason(code="no-way", text=f"{application} has no state {target}")]
        path = _path(project, application, stay.state, target)
        start = f"{application} was in {here} since {moment(stay.entered['t'])}"
        if not path:
            said = f"{start}, and no way leads from there to {self._state(target)}"
            return [Reason(code="no-way", text=said, seq=stay.entered["seq"])]
        steps = [f"{way.exit} → {self._state(to)}" for way, to in path]
        said = f"{start}; the nearest way to {self._state(target)}: {', '.join(steps)}"
        below = tuple(self.why_not_taken(stay, path[0][0]))
        return [Reason(code="no-way", text=said, seq=stay.entered["seq"], below=below)]


_OUTSIDE = "it comes from outside: from a module, a message, or the blackboard"
_ORIGINS = {
    RESUMED: "it comes when a suspension ends",
    NOT_UNDERSTOOD: "it comes when something is heard that is none of the phrases",
}


def _fate(stay: Stay, element: str, name: str | None) -> str:
    """What became of an action in a stay."""
    fate = "it had not begun"
    for event in stay.events:
        if event["kind"] not in ("action", "finished", "cancelled"):
            continue
        if (event["action"], event["name"]) == (element, name):
            at = moment(event["t"])
            fate = {
                "action": f"it has been running since {at}",
                "finished": f"it ended {'well' if event.get('ok') else 'badly'} at {at}",
                "cancelled": f"it was cancelled at {at}",
            }[event["kind"]]
    return fate


def _path(project: Project, application: str, start: str, target: str) -> list[tuple[Way, str]]:
    """The fewest ways from one state into another, each with where it leads; back not followed."""
    came: dict[str, tuple[str, Way]] = {}
    waiting = deque([start])
    while waiting:
        here = waiting.popleft()
        if here in came and f"{here}/".startswith(f"{target}/"):
            break
        for way in ways(project, application, here):
            to = entered(project, application, way)
            if to is not None and to != start and to not in came:
                came[to] = (here, way)
                waiting.append(to)
    else:
        return []
    found: list[tuple[Way, str]] = []
    while here in came:
        before, way = came[here]
        found.append((way, here))
        here = before
    return found[::-1]
