"""Makes the picture of an application: what each card says of its state. Pure; no Qt."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import chain
from typing import NamedTuple

from msgspec.structs import replace

from situ.document import rbd, words
from situ.document.problem import Problem
from situ.document.rbd import Application, Event, State, Timeout
from situ_studio import kinds
from situ_studio.canvas.picture import ALWAYS, TIMEOUT, Card, Exit, Kind, Link, Picture
from situ_studio.canvas.problem_marks import NONE, Marks, changed, marks_of
from situ_studio.edits.edit import Place
from situ_studio.edits.exchanged import exchanged
from situ_studio.edits.words import condition_words
from situ_studio.wording.language import say, tr


class _Made(NamedTuple):
    """A card with what it was made from. laid: its place where the value has none."""

    targets: frozenset[str]
    laid: tuple[float, float] | None
    card: Card
    links: dict[tuple[str, ...], Link]


class Projector:
    """Makes pictures of successive documents; cards that did not change are the same value.

    What it costs is next to nothing for a value that is the very same as before.
    """

    def __init__(self) -> None:
        self._made: dict[str, _Made] = {}
        self._values: dict[str, State | rbd.Always] = {}
        self._picture = Picture({}, {}, {})
        self._around: tuple[object, ...] = ()
        self._application: Application | None = None
        self._uids: tuple[str, ...] = ()
        self._known: frozenset[str] = frozenset()

    def picture(
        self,
        application: Application,
        problems: Sequence[Problem] = (),
        places: Mapping[str, tuple[float, float]] | None = None,
    ) -> Picture:
        """places: uid to position, for cards whose state has none."""
        parts = exchanged(self._application, application)
        if parts is None:
            values = dict(identified(application))
            known = frozenset([state.no for state in application.states])
            uids = tuple(values)
        else:
            uids, known = self._uids, self._known
            values = {**self._values, **{uids[one.at]: one.new for one in parts}}
        around = (
            application.start_no,
            _chips(application),
            marks_of(problems),
            dict(places or {}),
            known,
        )
        if parts is not None and around == self._around:
            stale = [uids[one.at] for one in parts]
        else:
            stale = self._stale(values, *around)
        made = {uid: self._make(uid, values[uid], *around) for uid in stale}
        if parts is None:
            every = {**self._made, **made}
            self._made = {uid: every[uid] for uid in values}
            self._picture = self._drawn()
        else:
            self._picture = self._redrawn(made)
            self._made.update(made)
        self._application, self._uids, self._known = application, uids, known
        self._values, self._around = values, around
        return self._picture

    def _stale(
        self,
        values: Mapping[str, State | rbd.Always],
        start: str | None,
        chips: tuple[str, ...],
        marks: Marks,
        places: Mapping[str, tuple[float, float]],
        known: frozenset[str],
    ) -> list[str]:
        """The uids whose card may be another one now."""
        if not self._around:
            return list(values)
        before, hung, was, _, there = self._around
        assert isinstance(there, frozenset)
        assert isinstance(was, Mapping)
        marked = changed(was, marks)
        # Numbers that are there now and were not, or the other way round.
        other = frozenset([*(known ^ there)])
        begins = {start, before} if start != before else set()

        def same(uid: str, kept: _Made) -> bool:
            card = kept.card
            return (
                other.isdisjoint(kept.targets)
                and not (hung != chips and card.no)
                and card.no not in begins
                and card.place not in marked
                and (kept.laid is None or places.get(uid) == kept.laid)
            )

        return [
            uid
            for uid, value in values.items()
            if self._values.get(uid) is not value or not same(uid, self._made[uid])
        ]

    def _make(
        self,
        uid: str,
        value: State | rbd.Always,
        start: str | None,
        chips: tuple[str, ...],
        marks: Marks,
        places: Mapping[str, tuple[float, float]],
        known: frozenset[str],
    ) -> _Made:
        laid = None
        position = value.aside.position
        if position is None:
            position = laid = places.get(uid, (0.0, 0.0))
        card = _card(uid, value, position, known, start, chips, marks)
        kept = self._made.get(uid)
        if kept is not None and kept.card == card:
            return _Made(frozenset(targets(value)), laid, kept.card, kept.links)
        return _Made(frozenset(targets(value)), laid, card, _links(card))

    def _redrawn(self, made: Mapping[str, _Made]) -> Picture:
        """The picture with some cards made anew; links have no order that counts."""
        cards, links = dict(self._picture.cards), dict(self._picture.links)
        for uid, one in made.items():
            cards[uid] = one.card
            for id in self._made[uid].links.keys() - one.links.keys():
                del links[id]
            links.update(one.links)
        return Picture(cards=cards, links=links, uids=self._picture.uids)

    def _drawn(self) -> Picture:
        cards, links, uids = {}, {}, dict[Place, str]()
        for uid, one in self._made.items():
            cards[uid] = one.card
            links.update(one.links)
            uids.setdefault(one.card.place, uid)
        return Picture(cards=cards, links=links, uids=uids)


def _card(
    uid: str,
    value: State | rbd.Always,
    position: tuple[float, float],
    known: frozenset[str],
    start: str | None,
    chips: tuple[str, ...],
    marks: Marks,
) -> Card:
    x, y = position
    place = ("state", value.no) if isinstance(value, State) else (ALWAYS,)
    exits = _exits(value.events, value.timeout, known, marks, place)
    wrong = marks.get(place, NONE)
    if not isinstance(value, State):
        return Card(
            uid=uid,
            place=place,
            kind="always",
            no="",
            name=tr("In every state"),
            x=x,
            y=y,
            line=tr("is part of every state"),
            line_icon="always",
            screen=value.screen,
            exits=exits,
            mark=wrong.sign,
            wrong=wrong,
        )
    kind: Kind = "state"
    if value.no == start:
        kind = "start"
    elif value.flow is not None:
        kind = "part"
    elif ends(value):
        kind = "end"
    line, icon = _line(value)
    return Card(
        uid=uid,
        place=place,
        kind=kind,
        no=value.no,
        name=value.name or tr("state {0}").format(value.no),
        x=x,
        y=y,
        line=line,
        line_icon=icon,
        icons=tuple(dict.fromkeys(_icon(a) for a in value.actions)),
        screen=value.screen,
        exits=exits,
        chips=chips if value.always else (),
        mark=wrong.sign,
        wrong=wrong,
    )


def _exits(
    events: Sequence[Event],
    timeout: Timeout | None,
    known: frozenset[str] | set[str],
    marks: Marks,
    place: Place,
) -> tuple[Exit, ...]:
    made = []
    for index, event in enumerate(events):
        made.append(
            _leading(
                Exit(
                    id=str(index),
                    label=_label(event),
                    phrase=event.says[0].text if event.says else "",
                    guard=condition_words(event.when) if event.name else "",
                    next=event.next,
                    mark=marks.get((*place, "event", str(index)), NONE),
                ),
                known,
            )
        )
    if timeout is not None:
        exit = Exit(
            id=TIMEOUT,
            label=words.seconds(timeout.seconds, say),
            next=timeout.next,
            seconds=timeout.seconds,
            mark=marks.get((*place, TIMEOUT), NONE),
        )
        made.append(_leading(exit, known))
    return tuple(made)


def _leading(exit: Exit, known: frozenset[str] | set[str]) -> Exit:
    """With what stands at the port where no pipe can."""
    if exit.next is None or exit.next in known:
        return exit
    missing = exit.next not in (rbd.BACK, rbd.AGAIN)
    return replace(exit, short=exit.next, missing=missing)


def _label(event: Event) -> str:
    if event.name:
        return event.name
    if event.when is not None:
        return tr("if {0}").format(condition_words(event.when))
    return tr("at once")


def _line(state: State) -> tuple[str, str]:
    if state.flow is not None:
        return state.flow, "part"
    for action in state.actions:
        if isinstance(action, rbd.Speech):
            return action.text, "speech"
    for action in state.actions:
        return words.action(action), _icon(action)
    for component in state.screen.components if state.screen else ():
        if isinstance(component, rbd.Text):
            return component.text, "text"
    return "", ""


def _icon(action: rbd.Action) -> str:
    kind = kinds.kind_of(action)
    assert kind is not None
    return kind.icon


def ends(state: State) -> bool:
    """Whether nothing of its own leaves the state (formats.md, *States*)."""
    return not any(e.next for e in state.events) and not (state.timeout and state.timeout.next)


def _chips(application: Application) -> tuple[str, ...]:
    """What each event of ``always`` is called: by its button, else its phrase, else its name."""
    always = application.always
    if always is None:
        return ()
    buttons = {
        c.event: c.text
        for c in (always.screen.components if always.screen else ())
        if isinstance(c, rbd.Button) and c.event and c.text and "{" not in c.text
    }
    made = []
    for event in always.events:
        phrase = event.says[0].text if event.says else ""
        made.append(buttons.get(event.name or "") or phrase or _label(event))
    return tuple(made)


def _links(card: Card) -> dict[tuple[str, ...], Link]:
    """The card's pipes. The first card with a number has it as its uid."""
    made = (
        Link(
            source=card.uid,
            exit=leaving.id,
            target=leaving.next,
            label=leaving.label,
            guard=tr("if {0}").format(leaving.guard) if leaving.guard else "",
        )
        for leaving in card.exits
        if leaving.next is not None and not leaving.short
    )
    return {link.id: link for link in made}


def identified(application: Application) -> Iterable[tuple[str, State | rbd.Always]]:
    """Every card's uid with its value: ``always`` first, then the states; doubled numbers apart."""
    first: list[tuple[str, State | rbd.Always]] = []
    if application.always is not None:
        first.append((f"{ALWAYS} ", application.always))
    numbers = [state.no for state in application.states]
    if len(set(numbers)) == len(numbers):
        return chain(first, zip(numbers, application.states, strict=True))
    seen: dict[str, int] = {}
    apart: list[tuple[str, State]] = []
    for state in application.states:
        count = seen[state.no] = seen.get(state.no, 0) + 1
        apart.append((state.no if count == 1 else f"{state.no}  {count}", state))
    return chain(first, apart)


def targets(value: State | rbd.Always) -> list[str]:
    """Every ``next`` of the value, its timeout's last."""
    found = [e.next for e in value.events if e.next is not None]
    if value.timeout is not None and value.timeout.next is not None:
        found.append(value.timeout.next)
    return found
