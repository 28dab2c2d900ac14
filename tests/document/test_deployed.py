"""A project is read from its texts as from its folder: what a robot does that takes a new one."""

from __future__ import annotations

from pathlib import Path

import pytest

from situ.document import deployed, folder
from situ.document.problem import Problem

EXAMPLES = Path(__file__).parents[2] / "examples"
FLOW = '<application name="a"><state no="1">{}</state></application>'
TOML = '[project]\nname = "p"\napplications = ["a.rbd.xml"]\n'


def errors(texts: dict[str, str]) -> list[str]:
    return [str(one) for one in deployed.read(texts)[1] if one.severity == "error"]


@pytest.mark.parametrize("name", ["reception", "conversation"])
def test_texts_are_the_project_that_their_folder_is(name: str) -> None:
    root = str(EXAMPLES / name)
    project, _ = folder.load(root)
    assert project is not None
    texts = folder.sources(project)
    assert deployed.read(texts, root)[0] == project
    assert errors(texts) == []


def test_a_single_document_is_a_project_with_the_parts_that_it_names() -> None:
    texts = {
        "a.rbd.xml": FLOW.format('<flow src="b.rbd.xml"/>'),
        "b.rbd.xml": FLOW.format("").replace('"a"', '"b"'),
    }
    project, _ = deployed.read(texts)
    assert project is not None
    assert (list(project.applications), list(project.parts)) == (["a.rbd.xml"], ["b.rbd.xml"])
    assert errors(texts) == []


def test_the_robots_own_settings_are_laid_over() -> None:
    texts = {
        "situ.toml": f"{TOML}[tags]\nx = 1\ny = 1\n",
        "a.rbd.xml": FLOW.format(""),
        "robot.local.toml": "[tags]\ny = 2\n",
    }
    project, _ = deployed.read(texts)
    assert project is not None
    assert project.tags == {"x": 1, "y": 2}


@pytest.mark.parametrize(
    ("texts", "said"),
    [
        ({}, "There are no files"),
        ({"situ.toml": TOML}, "There is no file a.rbd.xml"),
        ({"situ.toml": TOML.replace("a.rbd", "../a.rbd")}, "leads out of the project"),
        ({"situ.toml": "[", "a.rbd.xml": FLOW}, "situ.toml"),
        ({"a.rbd.xml": FLOW.format('<flow src="b.rbd.xml"/>')}, "b.rbd.xml"),
        ({"a.rbd.xml": FLOW.format('<flow src="../b.rbd.xml"/>')}, "leads out of the project"),
        ({"a.rbd.xml": FLOW.format('<timeout next="7">3</timeout>')}, "7"),
        ({"a.rbd.xml": "<application"}, "a.rbd.xml:1"),
        ({"a.rbd.xml": "\udcff"}, "a.rbd.xml"),
    ],
)
def test_what_is_wrong_with_texts_is_told(texts: dict[str, str], said: str) -> None:
    assert any(said in one for one in errors(texts))


def test_media_count_as_there() -> None:
    image = '<image id="i" x="1" y="1" width="9" height="9" src="{}"/>'
    shown = FLOW.format(f"<screen><components>{image}</components></screen>")
    texts = {"situ.toml": TOML, "a.rbd.xml": shown.format("far.png")}
    assert _of_media(deployed.read(texts)[1]) == []
    texts["a.rbd.xml"] = shown.format("../far.png")
    assert _of_media(deployed.read(texts)[1]) != []


def _of_media(problems: list[Problem]) -> list[Problem]:
    return [one for one in problems if "far.png" in one.message]
