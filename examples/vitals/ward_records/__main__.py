"""``python -m ward_records``, from the folder that this package stands in."""

from __future__ import annotations

import argparse
import json
import os
import secrets
import sys
from datetime import UTC, datetime
from pathlib import Path

import msgspec
from aiohttp import web

from ward_records.access import Tokens
from ward_records.contacts import Contacts
from ward_records.day import Day
from ward_records.store import Store
from ward_records.watching import Watching
from ward_records.web import application

INVENTED = (
    (3, "Aroha Tamihana", "3141", ""),
    (7, "Joan Nikora", "2718", ""),
    (12, "Jack Nilsen", "1234", ""),
    (21, "木村はる", "2121", "きむら はる"),
)
"""Residents of no ward: room, name, PIN, and how the name is said, in kana."""

CONTACTS = (
    (12, "family", "Anna Nilsen", ""),
    (12, "family", "Peter Nilsen", ""),
    (12, "friends", "Bob Hart", ""),
    (7, "family", "Mere Nikora", ""),
    (7, "friends", "Rose Baker", ""),
    (3, "family", "Hana Tamihana", ""),
    (21, "family", "木村ゆき", "きむら ゆき"),
    (21, "family", "木村けんじ", "きむら けんじ"),
    (21, "friends", "佐藤ふみ", "さとう ふみ"),
)
"""Whom they may call: room, group, name, its kana. Nobody has such an address."""

MEDICINE = (
    (12, "morning", "two white tablets, with water"),
    (12, "evening", "one white tablet, with water"),
    (3, "morning", "one yellow capsule, after breakfast"),
    (7, "noon", "one drop in each eye"),
    (21, "morning", "白い錠剤を一つ、お水で"),
)
"""Room, round, what."""

TOLD = (
    (None, "10:30", "bingo in the hall"),
    (None, "15:00", "tea in the garden"),
    (7, "14:00", "the doctor comes to see you"),
    (12, "16:30", "your daughter comes to visit"),
)
"""Every day; for the room, or for all."""


def tokens_in(folder: Path) -> Tokens:
    """Those of ``tokens.json``, which is made where there is none; for its owner only."""
    file = folder / "tokens.json"
    if not file.exists():
        made = {role: secrets.token_urlsafe(24) for role in ("service", "operator", "viewer")}
        descriptor = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        with os.fdopen(descriptor, "w", encoding="utf-8") as out:
            json.dump(made, out, indent=1)
    return msgspec.json.decode(file.read_bytes(), type=Tokens)


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="ward_records", description="The records of a ward, and the nurse's page."
    )
    parser.add_argument("folder", type=Path, help="where ward.db and tokens.json are kept")
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=8081)
    args = parser.parse_args()
    args.folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    try:
        tokens = tokens_in(args.folder)
    except (OSError, msgspec.MsgspecError) as error:
        print(f"ward_records: {args.folder / 'tokens.json'}: {error}", file=sys.stderr)
        return 2

    def now() -> datetime:
        return datetime.now(UTC)

    store = Store(args.folder / "ward.db", now)
    day = Day(store.db, now)
    if not store.residents():
        made = {room: store.add(room, *whose).id for room, *whose in INVENTED}
        contacts = Contacts(store)
        for number, (room, group, name, kana) in enumerate(CONTACTS, 1):
            contacts.add(made[room], group, name, f"sip:{number}@ward.invalid", kana)
        for room, round_, what in MEDICINE:
            day.prescribe(made[room], round_, what)
        for whom, begins, what in TOLD:
            day.remind(begins, what, made.get(whom or 0), daily=True)
    said = f"http://{args.host}:{args.port}/?token={tokens.operator}"
    try:
        web.run_app(
            application(store, day, Watching(now), tokens),
            host=args.host,
            port=args.port,
            print=lambda _: print(said, flush=True),
            access_log=None,
        )
    except OSError as error:
        print(f"ward_records: can not listen at {args.host}:{args.port}: {error}", file=sys.stderr)
        return 2
    finally:
        store.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
