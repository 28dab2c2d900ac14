"""The records that the reception asks: ``python examples/reception/records_service.py``.

A stand-in for the web services of a retirement village, with invented residents:

====================================  ==========================================
``POST /findPatientsByInitials``      ``{"x": "J", "y": "N"}`` to
                                      ``{"names": [{"id", "name", "room"}, …]}``
``POST /saveProfile``                 ``{"user": {"id", …}}`` to ``{"saved": true}``
``POST /regUsr``                      ``{"usr": {"first", "last"}}`` to
                                      ``{"user": {"id", "name", "room"}}``
``GET /``                             how many residents there are
====================================  ==========================================

Everything is JSON. What it can not use it answers with status 400, an unknown
resident with 404, an incomplete name with 422, each with ``{"error": "…"}``. It
keeps what it learns in memory; only with ``--records FILE`` does it read and
write that file. The address it listens at is its first line of output.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import sys
import tempfile
import threading
import unicodedata
from collections.abc import Callable
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any, cast

Resident = dict[str, Any]

INVENTED: list[Resident] = [
    {"first": "Jack", "last": "Nilsen", "room": "12"},
    {"first": "Joan", "last": "Nikora", "room": "7"},
    {"first": "Aroha", "last": "Tamihana", "room": "3"},
    {"first": "Haru", "last": "Kimura", "room": "21", "reading": ["はる", "きむら"]},
    {"first": "Hana", "last": "Kitano", "room": "22", "reading": ["はな", "きたの"]},
    {"first": "Margaret", "last": "Doyle", "room": "5"},
    {"first": "Mele", "last": "Fonua", "room": "9"},
    {"first": "Priya", "last": "Nair", "room": "14"},
    {"first": "Tomás", "last": "Ibarra", "room": "16"},
    {"first": "Wen", "last": "Chen", "room": "18"},
    {"first": "Grace", "last": "Okafor", "room": "10"},
    {"first": "Élise", "last": "Moreau", "room": "2"},
]

LONGEST_BODY = 64 * 1024
LONGEST_NAME = 40


class Wrong(Exception):
    """A request that is answered with ``status`` and this text."""

    def __init__(self, status: int, text: str) -> None:
        super().__init__(text)
        self.status = status


def letter(text: str) -> str:
    """The first letter as it is compared: no accent, no case, katakana as hiragana."""
    plain = unicodedata.normalize("NFKD", unicodedata.normalize("NFKC", text).strip())
    first = plain[:1].casefold()
    return chr(ord(first) - 0x60) if "ァ" <= first <= "ヶ" else first


class Records:
    """The residents. Safe to use from several threads."""

    def __init__(self, residents: list[Resident], file: Path | None = None) -> None:
        self._residents = [dict(r, id=r.get("id", i + 1)) for i, r in enumerate(residents)]
        self._file = file
        self._lock = threading.Lock()

    def __len__(self) -> int:
        return len(self._residents)

    def find(self, asked: dict[str, Any]) -> dict[str, Any]:
        x, y = (self._text(asked.get(key), f"{key}, an initial,") for key in ("x", "y"))
        if not letter(x) or not letter(y):
            raise Wrong(400, "x and y must each hold a letter")
        with self._lock:
            found = [r for r in self._residents if _has_initials(r, letter(x), letter(y))]
        return {"names": [_shown(r) for r in found]}

    def save_profile(self, asked: dict[str, Any]) -> dict[str, Any]:
        user = asked.get("user")
        if not isinstance(user, dict):
            raise Wrong(400, "user must be an object, as findPatientsByInitials gave it")
        with self._lock:
            known = next((r for r in self._residents if r["id"] == user.get("id")), None)
            if known is None:
                raise Wrong(404, "there is no resident with this id")
            known["visits"] = known.get("visits", 0) + 1
            self._keep()
        return {"saved": True}

    def register(self, asked: dict[str, Any]) -> dict[str, Any]:
        usr = asked.get("usr")
        if not isinstance(usr, dict):
            raise Wrong(400, "usr must be an object with first and last")
        first, last = (self._text(usr.get(key), key) for key in ("first", "last"))
        if not first or not last:
            raise Wrong(422, "both names are needed")
        if len(first) > LONGEST_NAME or len(last) > LONGEST_NAME:
            raise Wrong(422, f"a name has at most {LONGEST_NAME} letters")
        with self._lock:
            one: Resident | None = next(
                (r for r in self._residents if (r["first"], r["last"]) == (first, last)), None
            )
            if one is None:
                number = max((r["id"] for r in self._residents), default=0) + 1
                one = {"first": first, "last": last, "room": "–", "id": number}
                self._residents.append(one)
                self._keep()
        return {"user": _shown(one)}

    @staticmethod
    def _text(value: Any, what: str) -> str:
        if value is None:
            return ""
        if not isinstance(value, str):
            raise Wrong(400, f"{what} must be a text")
        return value.strip()

    def _keep(self) -> None:
        if self._file is None:
            return
        handle, name = tempfile.mkstemp(dir=self._file.parent, prefix=self._file.name)
        with os.fdopen(handle, "w", encoding="utf-8") as out:
            json.dump(self._residents, out, ensure_ascii=False, indent=1)
        os.replace(name, self._file)


def _has_initials(resident: Resident, x: str, y: str) -> bool:
    spellings = [(resident["first"], resident["last"])]
    if "reading" in resident:
        spellings.append(tuple(resident["reading"]))
    return any((letter(first), letter(last)) == (x, y) for first, last in spellings)


def _shown(resident: Resident) -> dict[str, Any]:
    names = resident["first"], resident["last"]
    if any("\u3040" <= sign <= "\u9fff" for sign in "".join(names)):
        names = names[::-1]  # written in Japanese or Chinese, the family comes first
    name = " ".join(names)
    return {"id": resident["id"], "name": name, "room": resident["room"]}


def _read(file: Path | None) -> list[Resident]:
    if file is None or not file.exists():
        return INVENTED
    residents = json.loads(file.read_text(encoding="utf-8"))
    if not isinstance(residents, list) or not all(
        isinstance(r, dict) and all(isinstance(r.get(k), str) for k in ("first", "last", "room"))
        for r in residents
    ):
        raise ValueError("it must hold a JSON list of residents with first, last and room")
    return residents


class Server(ThreadingHTTPServer):
    """Answers on ``(host, port)``; port 0 is a free one, then ``address`` says which."""

    daemon_threads = True

    def __init__(self, host: str, port: int, records: Records) -> None:
        self.records = records
        super().__init__((host, port), Handler)

    @property
    def address(self) -> str:
        host, port = self.server_address[:2]
        return f"http://{host!s}:{port}"


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server_version = "records"
    timeout = 10
    wbufsize = -1  # head and body leave in one packet: no waiting for an acknowledgement

    def do_POST(self) -> None:
        records = cast(Server, self.server).records
        services: dict[str, Callable[[dict[str, Any]], dict[str, Any]]] = {
            "/findPatientsByInitials": records.find,
            "/saveProfile": records.save_profile,
            "/regUsr": records.register,
        }
        try:
            asked = self._body()
            service = services.get(self.path)
            if service is None:
                raise Wrong(404, f"no such service; there are {', '.join(services)}")
            self._answer(200, service(asked))
        except Wrong as wrong:
            self._answer(wrong.status, {"error": str(wrong)})

    def do_GET(self) -> None:
        if self.path != "/":
            self._answer(404, {"error": "GET answers at / only; the services want POST"})
        else:
            self._answer(200, {"residents": len(cast(Server, self.server).records)})

    def _body(self) -> dict[str, Any]:
        given = self.headers.get("Content-Length", "")
        length = int(given) if given.isascii() and given.isdigit() and len(given) < 9 else -1
        if not 0 <= length <= LONGEST_BODY:
            # Who is still sending would not hear the answer: some more is read, and dropped.
            self.rfile.read(min(max(length, 0), 16 * LONGEST_BODY))
            self.close_connection = True
            raise Wrong(413, f"send a body of at most {LONGEST_BODY} bytes with its length")
        try:
            body = json.loads(self.rfile.read(length))
        except (ValueError, RecursionError):
            raise Wrong(400, "the body must be JSON") from None
        if not isinstance(body, dict):
            raise Wrong(400, "the body must be a JSON object")
        return body

    def _answer(self, status: int, body: dict[str, Any]) -> None:
        data = json.dumps(body, ensure_ascii=False).encode()
        self.send_response(status)
        self.send_header("Content-Type", "application/json; charset=utf-8")
        self.send_header("Content-Length", str(len(data)))
        if self.close_connection:
            self.send_header("Connection", "close")
        self.end_headers()
        self.wfile.write(data)

    def log_message(self, *_: Any) -> None:
        """Silent: what residents ask is nobody's business."""


def main(argv: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description="The records that the reception example asks.")
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=8080, help="0: a free one (default 8080)")
    parser.add_argument("--records", type=Path, help="a JSON file to read and to keep up to date")
    args = parser.parse_args(argv)
    try:
        records = Records(_read(args.records), args.records)
    except (OSError, ValueError) as error:
        print(f"can not use {args.records}: {error}", file=sys.stderr)
        return 2
    try:
        server = Server(args.host, args.port, records)
    except (OSError, OverflowError) as error:
        print(f"can not listen at {args.host}:{args.port}: {error}", file=sys.stderr)
        return 2
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    print(server.address, flush=True)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        pass
    finally:
        server.server_close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
