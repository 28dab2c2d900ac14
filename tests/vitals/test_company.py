"""Calling, the brain game and entertainment of examples/vitals, with what they read from media."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import pytest
from tests.vitals.person import VITALS, Person

import situ.testing
from situ.decide.inputs import Finish, Use
from situ.decide.masking import Mask

MEDIA = VITALS / "media"
LANGUAGES = ("en", "ja")
ANNA = {"id": 4, "name": "Anna Nilsen", "address": "sip:4@ward.invalid"}


def read(name: str) -> Any:
    return json.loads((MEDIA / name).read_text("utf-8"))


@pytest.fixture
def person() -> Iterator[Person]:
    with situ.testing.robot(VITALS, seed=3) as robot:
        jack = Person(robot)
        jack.log_in()
        yield jack


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_game_has_five_other_questions_and_its_score_is_written_down(
    person: Person, language: str
) -> None:
    person.robot.set("language", language)
    person.use("game", "start")
    (asked,) = person.robot.events(kind="action", name="questions")
    assert asked["url"] == f"media:quiz.{language}.json"
    person.answer("questions", read(f"quiz.{language}.json"))
    seen = []
    for wrong in (False, True, False, False, False):
        question = person.robot.value("quiz.question")
        seen.append(question["text"])
        right = question["right"]
        person.use(("first", "second", "third")[(right + wrong) % 3])
        assert person.at == ("15/6" if wrong else "15/5")
        person.use("on")
    assert len(set(seen)) == 5
    assert person.at == "15/7"
    (kept,) = person.robot.events(kind="action", name="keepReading")
    assert kept["params"]["reading"] == {"kind": "game", "user": "3", "score": "4"}


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_question_has_three_answers_one_of_them_right_and_says_why(language: str) -> None:
    questions = read(f"quiz.{language}.json")["questions"]
    assert len({one["text"] for one in questions}) == len(questions) >= 15
    for one in questions:
        assert len(set(one["answers"])) == 3
        assert one["right"] in (0, 1, 2)
        assert one["because"]


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_stands_on_the_shelf_is_there(language: str) -> None:
    shelf = read(f"shelf.{language}.json")
    assert list(shelf) == ["music", "films", "stories"]
    assert all(one["title"] for pieces in shelf.values() for one in pieces)
    for pieces, kind in zip(shelf.values(), ("music", "film", "story"), strict=True):
        assert {one["kind"] for one in pieces} == {kind}
    played = [one["src"] for one in shelf["music"] + shelf["films"]]
    assert [name for name in played if not (MEDIA / name).is_file()] == []
    assert all(len(one["pages"]) > 1 for one in shelf["stories"])


def test_each_piece_is_heard_once_before_any_comes_again(person: Person) -> None:
    person.use("entertainment")
    person.answer("shelf", read("shelf.en.json"))
    person.use("playMusic")
    heard = []
    while person.at == "16/4":
        heard.append(person.robot.value("shelf.piece")["title"])
        person.use("next")
    assert sorted(heard) == sorted(one["title"] for one in read("shelf.en.json")["music"])
    assert person.at == "16/9"


def test_who_is_called_stands_in_no_trace_that_others_see_and_is_forgotten(person: Person) -> None:
    person.use("calling", "family")
    person.answer("contacts", {"contacts": [ANNA]})
    person.robot.give(Use("people", ANNA))
    person.use("yes")
    assert person.at == "14/5"
    person.robot.give(Finish(action="speech"))
    (call,) = person.robot.events(kind="action", action="launch")
    assert call["params"] == {"address": "sip:4@ward.invalid"}
    person.use("home")
    assert person.robot.events(kind="cancelled", action="launch") != []
    assert person.robot.value("contact") is None
    mask = Mask(person.robot.project.private)
    shown = str(mask.step(list(person.robot.trace)))
    assert "Anna" not in shown
    assert "sip:4" not in shown


def test_a_film_that_can_not_be_played_is_passed_over(person: Person) -> None:
    person.log_in()
    person.use("entertainment")
    person.answer("shelf", read("shelf.en.json"))
    person.use("playFilm")
    assert person.at == "16/5"
    person.robot.give(Finish(action="movie", ok=False, error="the page can not play this movie"))
    # It asks whether they would like another one.
    assert person.at == "16/8"
