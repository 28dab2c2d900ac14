"""The records of the reception example, asked over real HTTP."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import httpx
import pytest

FILE = Path(__file__).resolve().parents[2] / "examples" / "reception" / "records_service.py"


def load() -> ModuleType:
    spec = importlib.util.spec_from_file_location("records_service", FILE)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


service = load()


@pytest.fixture
def ask() -> Iterator[httpx.Client]:
    server = service.Server("127.0.0.1", 0, service.Records(service.INVENTED))
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02})
    thread.start()
    try:
        with httpx.Client(base_url=server.address, timeout=10, trust_env=False) as client:
            yield client
    finally:
        server.shutdown()
        server.server_close()
        thread.join(10)


def names(answer: httpx.Response) -> list[str]:
    assert answer.status_code == 200
    return [found["name"] for found in answer.json()["names"]]


@pytest.mark.parametrize(
    ("x", "y", "found"),
    [
        ("J", "N", ["Jack Nilsen", "Joan Nikora"]),
        ("j", " n ", ["Jack Nilsen", "Joan Nikora"]),
        ("e", "m", ["Élise Moreau"]),
        ("は", "き", ["Haru Kimura", "Hana Kitano"]),
        ("ハ", "キ", ["Haru Kimura", "Hana Kitano"]),
        ("Q", "Q", []),
    ],
)
def test_people_are_found_by_their_initials(
    ask: httpx.Client, x: str, y: str, found: list[str]
) -> None:
    assert names(ask.post("/findPatientsByInitials", json={"x": x, "y": y})) == found


def test_who_registers_is_found_afterwards(ask: httpx.Client) -> None:
    learnt = ask.post("/regUsr", json={"usr": {"first": "Ana", "last": "Silva"}})
    assert learnt.status_code == 200
    user = learnt.json()["user"]
    assert user["name"] == "Ana Silva"
    assert names(ask.post("/findPatientsByInitials", json={"x": "A", "y": "S"})) == ["Ana Silva"]
    assert ask.post("/saveProfile", json={"user": user}).json() == {"saved": True}


def test_a_name_in_japanese_is_written_family_first(ask: httpx.Client) -> None:
    learnt = ask.post("/regUsr", json={"usr": {"first": "太郎", "last": "山田"}})
    assert learnt.json()["user"]["name"] == "山田 太郎"


def test_registering_twice_is_registering_once(ask: httpx.Client) -> None:
    usr = {"usr": {"first": "Ana", "last": "Silva"}}
    first, again = ask.post("/regUsr", json=usr), ask.post("/regUsr", json=usr)
    assert first.json() == again.json()


@pytest.mark.parametrize(
    ("service", "body", "status"),
    [
        ("findPatientsByInitials", {"x": "", "y": "N"}, 400),
        ("findPatientsByInitials", {"x": None, "y": None}, 400),
        ("findPatientsByInitials", {"x": 3, "y": "N"}, 400),
        ("saveProfile", {"user": None}, 400),
        ("saveProfile", {"user": {"id": 999}}, 404),
        ("saveProfile", {"user": {"id": {}}}, 404),
        ("regUsr", {"usr": {"first": "Ana", "last": "  "}}, 422),
        ("regUsr", {"usr": {"first": "A" * 41, "last": "B"}}, 422),
        ("regUsr", {"usr": "Ana"}, 400),
        ("regUsr", ["Ana"], 400),
        ("nothing", {}, 404),
    ],
)
def test_what_it_can_not_use_it_says_in_one_line(
    ask: httpx.Client, service: str, body: Any, status: int
) -> None:
    answer = ask.post(f"/{service}", json=body)
    assert answer.status_code == status
    assert "\n" not in answer.json()["error"]


def test_it_goes_on_after_a_body_that_is_no_json(ask: httpx.Client) -> None:
    assert ask.post("/regUsr", content=b"[" * 5000).status_code == 400
    assert ask.post("/regUsr", content=b"\xff").status_code == 400
    assert ask.post("/regUsr", content=b" " * 70_000).status_code == 413
    assert ask.get("/").json() == {"residents": len(service.INVENTED)}


def test_it_keeps_a_file_only_where_it_was_told_to(tmp_path: Path) -> None:
    file = tmp_path / "records.json"
    records = service.Records(service.INVENTED, file)
    records.register({"usr": {"first": "Ana", "last": "Silva"}})
    again = service.Records(service._read(file), file)
    assert again.find({"x": "A", "y": "S"})["names"][0]["name"] == "Ana Silva"
    assert len(service.Records(service.INVENTED)) == len(service.INVENTED)
    assert [p.name for p in tmp_path.iterdir()] == ["records.json"]


def test_as_a_program_it_prints_its_address_and_ends_when_told() -> None:
    program = subprocess.Popen(
        [sys.executable, str(FILE), "--port", "0"], stdout=subprocess.PIPE, text=True
    )
    assert program.stdout is not None
    with program:
        address = program.stdout.readline().strip()
        answer = httpx.get(address, timeout=10, trust_env=False)
        program.terminate()
        assert program.wait(10) == 0
    assert answer.json()["residents"] > 0


def test_a_records_file_that_is_none_is_one_line(tmp_path: Path) -> None:
    file = tmp_path / "records.json"
    file.write_text(json.dumps({"first": "Ana"}))
    ended = subprocess.run(
        [sys.executable, str(FILE), "--port", "0", "--records", str(file)],
        capture_output=True,
        text=True,
        timeout=20,
        check=False,
    )
    assert ended.returncode == 2
    assert ended.stderr.count("\n") == 1
