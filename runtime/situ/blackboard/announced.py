"""What a robot tells the network of itself, as DNS-SD has it (docs/protocol.md, *Announced*).

Whoever is in the network can tell anything: what was heard is names and numbers to look at, and
which robot it really is shows with the keys (docs/security.md).
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping

from msgspec import Struct

from situ.blackboard.protocol import VERSION

SERVICE = "_situ._tcp.local."
LABEL = 63
"""Bytes of a name in DNS."""
TEXT = 200
"""Characters of a name that are looked at; a string of a TXT record has 255 bytes."""


class Announced(Struct, frozen=True, omit_defaults=True):
    """A robot that can be asked at a port of these addresses (IPv4, the best first).

    host: the name of its machine. addresses: none while nobody has asked for them. key: the
    fingerprint of its public key; "" lets everybody in. protocol: the version that it speaks.
    """

    project: str
    host: str
    port: int
    addresses: tuple[str, ...] = ()
    key: str = ""
    protocol: int = VERSION

    @property
    def endpoint(self) -> str:
        """Where it is asked; there is an address."""
        return f"tcp://{self.addresses[0]}:{self.port}"


def fingerprint(public: bytes | str) -> str:
    """32 hexadecimal digits for a public key in z85."""
    raw = public.encode() if isinstance(public, str) else public
    return hashlib.blake2b(raw, digest_size=16, person=b"situ robot").hexdigest()


def properties(robot: Announced) -> dict[str, bytes]:
    """The strings of its TXT record."""
    told = {
        "txtvers": "1",
        "protocol": str(robot.protocol),
        "project": robot.project,
        "host": robot.host,
        "key": robot.key,
    }
    return {key: _cut(value, TEXT) for key, value in told.items() if value}


def label(robot: Announced) -> str:
    """Its name among the others; the network gives one that is taken a number."""
    # A dot would part it, and " (2)" must have room.
    name = _one_line(f"{robot.project} at {robot.host}").replace(".", "-")
    return _cut(name, LABEL - 5).decode()


def heard(
    addresses: tuple[str, ...], port: int | None, told: Mapping[bytes, bytes | None]
) -> Announced | None:
    """What somebody in the network tells; None where that is no robot that could be asked."""
    texts = {key: _plain(value) for key, value in told.items() if value}
    protocol = texts.get(b"protocol", "")
    if not addresses or not port or not (protocol.isdecimal() and len(protocol) < 6):
        return None
    key = texts.get(b"key", "").lower()
    return Announced(
        project=texts.get(b"project", ""),
        host=texts.get(b"host", ""),
        port=port,
        addresses=addresses,
        key=key,
        protocol=int(protocol),
    )


def _plain(value: bytes) -> str:
    return _one_line(value.decode("utf-8", "replace"))[:TEXT]


def _one_line(text: str) -> str:
    """Without what steers a terminal."""
    return "".join(one if one.isprintable() else " " for one in text).strip()


def _cut(text: str, most: int) -> bytes:
    """At most so many bytes, in whole characters."""
    return text.encode("utf-8", "replace")[:most].decode("utf-8", "ignore").encode()
