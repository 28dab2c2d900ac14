"""From screen to screen as presses lead: which state comes next, and what was written. No Qt.

This is no rehearsal: conditions are not judged, times do not run, and nothing but the screen is
done. Of several events of one name the first is taken.
"""

from __future__ import annotations

from situ.decide.intake import typed
from situ.decide.values import template
from situ.document import rbd
from situ_studio.edits import words
from situ_studio.screens import samples
from situ_studio.screens.shown import Values, board_of
from situ_studio.wording.language import tr

FAR = 200
"""Steps that can be gone back."""


class Walk:
    """Begins at a state of an application, with values of its own: nothing outside is changed.

    screen: what is seen; a state without a screen keeps the one before. said: what the last press
    did, in one line. above: the components that Always adds there.
    """

    def __init__(self, application: rbd.Application, no: str, values: Values) -> None:
        self.application = application
        self.values = values
        self.no = no
        self.said = ""
        self._before: list[tuple[str, rbd.Screen, Values]] = []
        self.screen = rbd.Screen()
        self._arrive(no)

    @property
    def state(self) -> rbd.State | None:
        return self.application.state(self.no)

    @property
    def above(self) -> tuple[rbd.Component, ...]:
        always = self.application.always_in(self.state) if self.state is not None else None
        return always.screen.components if always is not None and always.screen is not None else ()

    @property
    def seen(self) -> tuple[rbd.Component, ...]:
        """All that is on the screen, back to front."""
        return (*self.screen.components, *self.above)

    @property
    def shown(self) -> Values:
        """The values, with something for each name on the screen that has none."""
        return Values(samples.filled(self.values, self.screen, self.above), self.values.texts)

    @property
    def can_go_back(self) -> bool:
        return bool(self._before)

    def back(self) -> None:
        """Takes the last step back, with what was written since."""
        if self._before:
            self.no, self.screen, self.values = self._before.pop()
            self.said = words.state_words(self.application, self.no)

    # -- what a person does --------------------------------------------------------------

    def press(self, button: rbd.Button) -> None:
        """A press writes the button's value and raises its event."""
        before = self.values
        if button.tag:
            self._write(button.tag, template(button.value or "").value(board_of(self.values).look))
        self._use(button.event, button.tag, before)

    def type(self, field: rbd.Input, text: str) -> bool:
        """What stands in an input now; whether it is as much as it takes, and told at once.

        A number that is none is not written.
        """
        value = typed(field, text)
        if value is None:
            self.said = tr("{0} takes a number").format(field.id)
            return False
        if field.tag:
            self._write(field.tag, value)
            self.said = tr("{0} is written").format(field.tag)
        return field.max is not None and len(text) >= field.max

    def enter(self, field: rbd.Input) -> None:
        """What was typed is entered."""
        self._use(field.event, field.tag)

    def choose(self, list_: rbd.List, entry: object) -> None:
        """A row of a list is pressed."""
        before = self.values
        if list_.tag:
            self._write(list_.tag, entry)
        self._use(list_.event, list_.tag, before)

    def end(self, movie: rbd.Movie) -> None:
        """The movie ends, which does not play here."""
        self._use(movie.done, None)

    def fail(self, movie: rbd.Movie) -> None:
        """The movie can not be played, which nobody tries here either."""
        self._use(movie.failed, None)

    def leads(self, event: str | None) -> str:
        """Where an event would lead from here, in words."""
        found = self._expected(event) if event is not None else None
        if found is None:
            return tr("nothing happens")
        if found.next is None:
            return tr("stays here")
        return words.leads_to(self.application, found.next)

    def touch(self) -> None:
        """A touch on no component: the state's event goes before that of Always."""
        always = self.application.always_in(self.state) if self.state is not None else None
        above = always.screen.touched if always is not None and always.screen is not None else None
        event = self.screen.touched or above
        if event:
            self._use(event, None)

    def others(self) -> tuple[tuple[str, str], ...]:
        """What else leads on from here than what can be pressed: each event with where it leads;
        the time that runs out is "".
        """
        raised = ("event", "done", "failed")
        pressed = {getattr(one, name, None) for one in self.seen for name in raised}
        found: dict[str, str] = {}
        for one in self._events():
            if one.name and one.name not in pressed and one.next is not None:
                found.setdefault(one.name, words.leads_to(self.application, one.next))
        ends = self.state.timeout if self.state is not None else None
        if ends is not None and ends.next is not None:
            found[""] = words.leads_to(self.application, ends.next)
        return tuple(found.items())

    def go_on(self, event: str) -> None:
        """As if one of ``others`` had happened."""
        ends = self.state.timeout if self.state is not None else None
        if event:
            self._use(event, None)
        elif ends is not None:
            self._take(tr("The time"), ends.next, False)

    # -- what follows --------------------------------------------------------------------

    def _use(self, event: str | None, tag: str | None, before: Values | None = None) -> None:
        """before: the values to which a step back leads, where the press wrote some."""
        if event is None:
            self.said = tr("{0} is written").format(tag) if tag else tr("Nothing happens.")
            return
        found = self._expected(event)
        if found is None:
            self.said = tr("{0} is not expected here: nothing happens.").format(event)
            return
        self._take(event, found.next, found.when is not None, before)

    def _take(self, event: str, to: str | None, judged: bool, before: Values | None = None) -> None:
        if to == rbd.BACK:
            if not self._before:
                self.said = tr("{0} leads back, to where one came from").format(event)
                return
            self.no, self.screen, _ = self._before.pop()
        elif to not in (None, rbd.AGAIN):
            here = (self.no, self.screen, self.values if before is None else before)
            self._before = [*self._before, here][-FAR:]
            self._arrive(to)
        there = words.state_words(self.application, self.no)
        said = tr("{0} leads to {1}") if to is not None else tr("{0}: stays in {1}")
        self.said = said.format(event, there)
        state = self.state
        if state is None:
            self.said = tr("{0} leads to {1}, which is not there").format(event, self.no)
        elif state.flow is not None:
            said = tr("{0} leads to {1}: a part runs there, whose screens are in {2}")
            self.said = said.format(event, there, state.flow)
        elif judged:
            self.said = tr("{0} leads to {1}, if its condition holds").format(event, there)

    def _events(self) -> tuple[rbd.Event, ...]:
        """Those of the state, before those of Always."""
        state = self.state
        if state is None:
            return ()
        always = self.application.always_in(state)
        return (*state.events, *(always.events if always is not None else ()))

    def _expected(self, event: str) -> rbd.Event | None:
        return next((one for one in self._events() if one.name == event), None)

    def _arrive(self, no: str | None) -> None:
        self.no = no or ""
        state = self.state
        if state is not None and state.screen is not None:
            self.screen = state.screen

    def _write(self, tag: str, value: object) -> None:
        self.values = self.values.written(tag, value)
