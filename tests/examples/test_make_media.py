"""The script that draws the examples' media makes what is in the repository."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
MEDIA = EXAMPLES / "reception" / "media"
MAGIC = {".png": b"\x89PNG\r\n\x1a\n", ".wav": b"RIFF", ".webm": b"\x1aE\xdf\xa3"}


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    spec = importlib.util.spec_from_file_location("make_media", EXAMPLES / "make_media.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    folder = tmp_path_factory.mktemp("media")
    module.make(folder)
    return folder


def test_the_script_makes_every_file_that_is_committed(made: Path) -> None:
    assert {p.name for p in made.iterdir()} == {p.name for p in MEDIA.iterdir()}


@pytest.mark.parametrize("file", sorted(MEDIA.iterdir()), ids=lambda p: p.name)
def test_a_file_is_of_its_kind_and_like_the_one_drawn_now(made: Path, file: Path) -> None:
    drawn = (made / file.name).read_bytes()
    kept = file.read_bytes()
    assert kept.startswith(MAGIC[file.suffix])
    if file.suffix == ".wav":
        assert len(kept) == len(drawn)
    else:
        # Another version of Qt packs the same picture into more or fewer bytes.
        assert len(drawn) == pytest.approx(len(kept), rel=0.3)
