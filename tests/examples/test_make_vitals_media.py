"""The script that draws what examples/vitals shows and plays makes what is in the repository."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
MEDIA = EXAMPLES / "vitals" / "media"


def test_the_script_makes_every_picture_film_and_tune_that_is_committed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.syspath_prepend(str(EXAMPLES))
    spec = importlib.util.spec_from_file_location(
        "make_vitals_media", EXAMPLES / "make_vitals_media.py"
    )
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.make(tmp_path)
    kept = {one.name: one for one in MEDIA.iterdir() if one.suffix != ".json"}
    assert {one.name for one in tmp_path.iterdir()} == set(kept)
    for name, file in kept.items():
        drawn, there = (tmp_path / name).read_bytes(), file.read_bytes()
        if file.suffix == ".wav":
            assert drawn[:44] == there[:44], name
            assert len(drawn) == len(there), name
        else:
            assert drawn[:4] == there[:4], name
            # Another version of Qt packs the same picture into more or fewer bytes.
            assert len(drawn) == pytest.approx(len(there), rel=0.3), name
