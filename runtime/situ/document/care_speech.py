"""Care with what is said: cut off, not to be heard again, in a voice that there is not."""

from __future__ import annotations

from situ.document import names, words
from situ.document import projectfile_mends as mends
from situ.document.analysis_data import actions, placed_actions, screens
from situ.document.analysis_search import Search
from situ.document.care_every import repeat
from situ.document.care_mend import puts
from situ.document.care_ways import expected, few, may_be_part, serves
from situ.document.datatypes import shown
from situ.document.projectfile import CODE
from situ.document.rbd import (
    AGAIN,
    TIMED_OUT,
    Application,
    Button,
    Repeat,
    Set,
    Speech,
    State,
)
from situ.document.spoken import estimate
from situ.document.values import read

_VOICES = """
af am an ar as az ba be bg bn bpy bs ca chr cmn cs cv cy da de el en eo es et eu fa fi fr ga gd
gn grc gu hak haw he hi hr ht hu hy hyw ia id io is it ja jbo ka kk kl kn ko kok ku ky la lb
lfn lt ltg lv mi mk ml mr ms mt my nb nci ne nl no nog om or pa pap piqd pl pt py qdb qu quc
qya ro ru rup sd shn si sjn sk sl smj sq sr sv sw ta te th tk tn tr tt ug uk ur uz vi yue zh
"""
VOICES = frozenset(_VOICES.split())
"""The languages that espeak-ng 1.51 speaks, without their countries; ``situ run`` speaks by it."""

LANGUAGE = "language"
"""The tag that screens and speeches obey."""


# -- a speech that its timeout cuts off ------------------------------------------


def cut_off(search: Search, file: str, application: Application) -> None:
    """``speech-over-timeout``: what a state says takes longer than until its timeout leaves it.

    The length is that of ``situ.document.spoken``, at the rate that ``[tags]`` gives, without
    the values of references and without sounds: never more than it will be; of several
    languages, the longest. A timeout with ``idle`` waits for the end of the speech. One without
    ``next`` leaves where the first event ``timeout`` that is taken surely has a ``next``.
    """
    for state in application.states:
        timeout = serves(application, state)
        if timeout is None or timeout.idle:
            continue
        if timeout.next is None and not _leaves_by_event(application, state):
            continue
        length, at = _length(search, state)
        if length <= timeout.seconds:
            continue
        where = ("state", state.no) if state.timeout is not None else ("always",)
        whose = "the timeout" if state.timeout is not None else "the timeout of every state"
        message = (
            f"This takes about {round(length)} s to say, but {whose} leaves the state after "
            f"{words.seconds(timeout.seconds)}: give it more time, or let it count "
            "only when idle, which is from the end of the speech"
        )
        said = "Let the timeout count from the end of the speech"
        mend = puts(search, file, (*where, "timeout"), timeout, said, idle=True)
        place = ("state", state.no, "action", str(at))
        search.warn(file, "speech-over-timeout", message, state.actions[at].aside, place, mend)


def _leaves_by_event(application: Application, state: State) -> bool:
    for event in expected(application, state):
        if event.name == TIMED_OUT:
            if event.next is None:
                return False
            if event.when is None:
                return True
    return False


def _length(search: Search, state: State) -> tuple[float, int]:
    """Seconds of all that a state says, and the position of its last speech."""
    rate = search.project.tags.get("speech.rate", 100)
    usable = isinstance(rate, (int, float)) and not isinstance(rate, bool) and 25 <= rate <= 250
    longest, last = 0.0, -1
    for language in ("", *search.project.texts):
        length = 0.0
        for index, action in enumerate(state.actions):
            if isinstance(action, Speech):
                last = index
                translated = search.project.texts.get(action.lang or language, {})
                said = literal(translated.get(action.text, action.text))
                length += estimate(said, rate if usable else 100) if said else 0
        longest = max(longest, length)
    return longest, last


def literal(text: str) -> str:
    """A text without the values of its references: the least that there can be of it."""
    return "".join(piece for piece, _ in names.split(text)).strip()


# -- a question that cannot be heard again ---------------------------------------


def no_repeat(search: Search, file: str, application: Application, by_hand: set[str]) -> None:
    """``no-repeat``: a state speaks, waits for a person's answer, and cannot say it again.

    It waits where an own event that a person raises leads to another state, unless any touch of
    the screen is such an event: then nothing need be understood. It can say it again where an
    expected event has a ``<repeat/>``, or enters it anew. Told once an application. In a part
    nothing is said where any other file of the project repeats: that may serve the part.
    """
    if may_be_part(search, file) and (
        not search.whole
        or any(_repeats(one) for one in search.project.flows.values() if one is not application)
    ):
        return
    mute = [
        state
        for state in application.states
        if _asks(state, by_hand) and not _can_repeat(application, state)
    ]
    if not mute:
        return
    message = (
        f"Who has not understood cannot hear it again in {few(mute)}: add a button or a phrase "
        "that says it again, best a Repeat button in every state"
    )
    mend = repeat(search, file, application, mute)
    search.warn(file, "no-repeat", message, mute[0].aside, ("state", mute[0].no), mend)


def _asks(state: State, by_hand: set[str]) -> bool:
    if not any(isinstance(action, Speech) and action.text for action in state.actions):
        return False
    led = {e.name for e in state.events if e.next not in (None, AGAIN, state.no)} & by_hand
    touched = state.screen.touched if state.screen is not None else None
    return bool(led) and touched not in led


def _can_repeat(application: Application, state: State) -> bool:
    return any(
        event.next in (AGAIN, state.no) or any(isinstance(a, Repeat) for a in event.actions)
        for event in expected(application, state)
    )


def _repeats(application: Application) -> bool:
    return any(isinstance(action, Repeat) for action in actions(application))


# -- languages --------------------------------------------------------------------


def languages(search: Search) -> None:
    """``language-without-voice``: a language of the project that espeak-ng does not speak, where
    the project speaks at all. ``language-without-texts``: a button or an action gives the tag
    ``language`` a value that is none of the project's languages, so texts stay as written.
    """
    project = search.project
    everything = project.flows
    speaks = any(isinstance(a, Speech) for one in everything.values() for a in actions(one))
    for language in project.languages if speaks and search.whole else ():
        if _primary(language) not in VOICES:
            message = (
                f"espeak-ng has no voice for {shown(language)}: speeches in it are shown, not "
                "heard; give the robot another voice, or leave the language out"
            )
            search.toml.append(
                ("language-without-voice", message, "project", "languages", language)
            )
    for file, application in everything.items():
        for action, place in placed_actions(application):
            if isinstance(action, Speech) and action.lang and _primary(action.lang) not in VOICES:
                message = (
                    f"espeak-ng has no voice for {shown(action.lang)}: this is shown, not heard; "
                    "give the robot another voice, or speak another language"
                )
                search.warn(file, "language-without-voice", message, action.aside, place)
            elif isinstance(action, Set) and action.tag == LANGUAGE:
                _known(search, file, action.text, action, place)
        for screen, at in screens(application):
            for component in screen.components:
                if isinstance(component, Button) and component.tag == LANGUAGE:
                    place = (*at, component.id)
                    _known(search, file, component.value or "", component, place)


def _primary(language: str) -> str:
    return language.replace("_", "-").partition("-")[0].lower()


def _known(
    search: Search, file: str, text: str, holder: Set | Button, place: tuple[str, ...]
) -> None:
    listed, value = search.project.languages, read(text.strip())
    if not listed or not isinstance(value, str) or value in ("", *listed) or "{" in value:
        return
    message = (
        f"There are no texts in {shown(value)}, all stay as they are written: add it to the "
        f"languages of situ.toml, or choose {words.listed(listed, 'or')}"
    )
    mend = None
    if search.project.toml is not None and CODE.fullmatch(value):
        end = ("project", "languages", len(listed))
        mend = mends.add(search.project.toml, end, value, f"Add {value} to the languages")
    search.warn(file, "language-without-texts", message, holder.aside, place, mend)
