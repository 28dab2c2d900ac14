"""What the runtime says in English is found again by its templates, whatever values are in it."""

from __future__ import annotations

import re
import runpy
import subprocess
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QTranslator
from tests.document.test_docs_problems import EXAMPLES, NUMBERED, Example, checked

from situ.document.ready import load_ready
from situ.errors import ScenarioError, UsageError
from situ.rehearse import recorded
from situ.rehearse.reason import Reason
from situ.rehearse.recording import read as recording_of
from situ.rehearse.recording import record
from situ.rehearse.scenario import load, parse
from situ.rehearse.suite import scenarios
from situ.rehearse.telling import Teller
from situ.rehearse.why import why_not
from situ.resources import example, resource
from situ_studio.wording.runtime_words import RuntimeWords, templates

ROOT = Path(__file__).resolve().parents[2]
KNOWN = templates()
GATHERED = runpy.run_path(str(ROOT / "packaging" / "runtime_texts.py"))["templates"]()
"""Those of the sources, as they are given to the translators next."""


def marked(template: str) -> str:
    """A language that says everything backwards, so that values stand elsewhere."""
    return "⟦" + " ".join(reversed(template.split(" "))) + "⟧"


def test_the_templates_are_those_of_the_sources() -> None:
    script = ROOT / "packaging" / "runtime_texts.py"
    code = f"import runpy; print(*runpy.run_path({str(script)!r})['templates'](), sep='\\n')"
    told = subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, encoding="utf-8"
    )
    assert told.stdout.splitlines() == KNOWN, "run python packaging/texts.py"


WRITTEN = re.compile(r'“[^”]*”|"[^"]*"|<[^>]*>|situ simulate|Illegal character')
"""What a person wrote, or stands so in a file or on the command line, and what Python says."""
ENGLISH = re.compile(r"[A-Za-z]{2,} [A-Za-z]{2,}")


@pytest.fixture(scope="module")
def japanese() -> RuntimeWords:
    texts = QTranslator()
    assert texts.load(str(resource("i18n", "studio_ja.qm")))
    return RuntimeWords(KNOWN, lambda text: texts.translate("runtime", text) or text)


@pytest.mark.parametrize("example", EXAMPLES, ids=NUMBERED)
def test_every_problem_is_said_in_the_user_s_language(
    example: Example, tmp_path: Path, japanese: RuntimeWords
) -> None:
    words = RuntimeWords(KNOWN, marked)
    _, problems = checked(tmp_path, example.failing)
    for problem in problems:
        for text in (problem.message, *([problem.mend.words] if problem.mend else ())):
            said = words.said(text)
            assert said.startswith("⟦"), text
            assert not ENGLISH.search(WRITTEN.sub("", japanese.said(text))), japanese.said(text)
            assert set(re.findall(r'"[^"]+"|\d+', text)) <= set(re.findall(r'"[^"]+"|\d+', said))


def test_what_fits_no_template_stays_as_it_is() -> None:
    words = RuntimeWords(["{0} added"], marked)
    assert words.said("Nurse Ann was here") == "Nurse Ann was here"


def test_values_are_said_in_the_user_s_language_too() -> None:
    words = RuntimeWords(
        ["state {0} added", "the timeout of {0}"],
        {"state {0} added": "{0} を追加", "the timeout of {0}": "{0} の時間切れ"}.__getitem__,
    )
    assert words.said("state the timeout of 5 added") == "5 の時間切れ を追加"


@pytest.mark.parametrize(
    ("listed", "said"),
    [
        ("1 ready, 2 wait and 3 go", "1 ready⟨, ⟩2 wait⟨ and ⟩3 go"),
        ('"yes", "no" or "stop"', '"yes"⟨, ⟩"no"⟨ or ⟩"stop"'),
        ("bp.systolic and bp.diastolic", "bp.systolic⟨ and ⟩bp.diastolic"),
        ("wash and dry", "wash and dry"),
        ("3 wash and dry", "3 wash and dry"),
        ("tea, milk", "tea, milk"),
    ],
)
def test_what_stands_between_things_is_said_in_the_user_s_language_names_are_not(
    listed: str, said: str
) -> None:
    words = RuntimeWords(["States {0} wait"], lambda text: f"⟨{text}⟩")
    assert words.said(f"States {listed} wait") == f"⟨States {said} wait⟩"


def test_what_stands_between_resources_is_said_in_the_user_s_language() -> None:
    words = RuntimeWords(["{0} asks for {1}", "{0} goes on"], lambda text: f"⟨{text}⟩")
    said = words.said("wash and dry asks for screen, speech and head")
    assert said == "⟨wash and dry asks for screen⟨, ⟩speech⟨ and ⟩head⟩"


def test_a_language_without_a_template_leaves_its_english() -> None:
    words = RuntimeWords(["state {0} added"], lambda text: text)
    assert words.said("state 5 added") == "state 5 added"


def test_what_a_person_wrote_is_never_translated() -> None:
    words = RuntimeWords(["{0} to {1}", "call {0}"], marked)
    assert words.said("call “Helper to Ann”") == "⟦“Helper to Ann” call⟧"
    spoken = '{"text":"Would you like to do it?","lang":"en"}'
    assert words.said(f"call {spoken}") == f"⟦{spoken} call⟧"


@pytest.mark.parametrize("name", ["conversation", "reception"])
def test_what_happened_and_why_something_did_not_is_said_in_the_user_s_language(name: str) -> None:
    project = load_ready(Path(example(name)))
    words, teller = RuntimeWords(KNOWN, marked), Teller(project)
    told: set[str] = set()
    for file in scenarios(project):
        run, _ = record(project, load(file))
        told |= {teller.tell(event) for event in run.events}
        told |= {teller.origin(event) for event in run.events}
        for wanted in WANTED[name]:
            for at in (0.0, run.end / 2, run.end):
                answer = why_not(project, run, wanted, at)
                told |= set(every(answer.reasons))
    assert len(told) > 100
    assert [text for text in told if not words.said(text).startswith("⟦")] == []
    # What is said and shown is quoted as it is.
    quoted = [text for one in told for text in re.findall("“[^“”]*”", one)]
    assert len(quoted) > 10
    every_word = " ".join(words.said(text) for text in told)
    assert [text for text in quoted if text not in every_word] == []


WANTED: dict[str, list[dict[str, str]]] = {
    "conversation": [
        {"kind": "enter", "state": "4"},
        {"kind": "transition", "to": "6"},
        {"kind": "situation", "to": "called"},
        {"kind": "authority", "to": "nod", "resource": "head"},
        {"kind": "mapping", "module": "nod", "resource": "head"},
        {"kind": "action", "action": "speech"},
        {"kind": "event", "name": "clickNo"},
        {"kind": "resume"},
    ],
    "reception": [
        {"kind": "enter", "state": "14"},
        {"kind": "action", "action": "service"},
        {"kind": "event", "name": "timedout"},
    ],
}


def every(reasons: Iterable[Reason]) -> Iterator[str]:
    for reason in reasons:
        yield reason.text
        yield from every(reason.below)


@pytest.mark.parametrize(
    "line",
    [
        b'{"at":1,"event":"e","set":{"a":1}}',
        b'{"at":-1,"event":"e"}',
        b'{"at":1,"event":"e","application":"nobody"}',
        b'{"at":1,"end":false}',
        b'{"at":1,"end":true}\n{"at":2,"event":"e"}',
        b'{"at":2,"event":"e"}\n{"at":1,"event":"e"}',
    ],
)
def test_what_is_wrong_with_a_scenario_is_said_in_the_user_s_language(line: bytes) -> None:
    words = RuntimeWords(GATHERED, marked)
    with pytest.raises(ScenarioError) as wrong:
        parse(line, "s.jsonl", ["desk"])
    assert "⟦" in words.said(str(wrong.value))


def test_what_is_no_recording_is_said_in_the_user_s_language(tmp_path: Path) -> None:
    words = RuntimeWords(GATHERED, marked)
    file = tmp_path / "x.mcap"
    file.write_bytes(b"nothing of a recording")
    with pytest.raises(UsageError) as wrong:
        list(recorded.read(file))
    assert words.said(str(wrong.value)).startswith("⟦")
    file.write_bytes(b"{}\n")
    with pytest.raises(UsageError) as wrong:
        recording_of(file)
    assert "⟦" in words.said(str(wrong.value))
