"""What the robot tells services and nobody else: headers, keys, passwords.

The list is ``secrets.toml`` in the runtime's state folder, written by whoever looks after the
robot, never by a project, and readable by the runtime's own user only::

    [[service]]
    url = "https://api.example/v1/**"      # * is one part of the path, ** any number
    headers = { Authorization = "Bearer …" }
    query = { key = "…" }

    [mqtt]
    user = "robot"
    password = "…"
    ca = "ca.pem"                          # who signed the broker's certificate; beside this file

The file is read anew for each request. What stands in it is in no message of an error.
"""

from __future__ import annotations

import os
import re
import stat
import tomllib
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

import msgspec
from msgspec import Struct

from situ.engine.actions import ActionFailed

HIDDEN = "•••"
SHORTEST = 4
"""Characters of a secret that is looked for in what comes back."""

_PORTS = {"http": 80, "https": 443}


class ServiceSecret(Struct, frozen=True, forbid_unknown_fields=True, tag=False):
    """One ``[[service]]``; of several that fit a url, all are told, the last one's word counts."""

    url: str
    headers: dict[str, str] = {}
    query: dict[str, str] = {}

    def fits(self, url: str) -> bool:
        """Whether scheme, host and port are the url's, and the path's pattern fits."""
        ours, given = urlsplit(self.url), urlsplit(url)
        if _origin(ours) is None or _origin(ours) != _origin(given):
            return False
        path = unquote(given.path) or "/"
        if ".." in path.split("/"):
            return False
        return re.fullmatch(_pattern(ours.path), path) is not None


class MqttSecret(Struct, frozen=True, forbid_unknown_fields=True):
    user: str | None = None
    password: str | None = None
    ca: str | None = None


class _Listed(Struct, frozen=True, forbid_unknown_fields=True):
    service: tuple[ServiceSecret, ...] = ()
    mqtt: MqttSecret | None = None


class Told(Struct, frozen=True):
    """What is told with one request, header names as written."""

    headers: dict[str, str] = {}
    query: dict[str, str] = {}

    def hide(self, text: str) -> str:
        """The text without what must not be repeated: a whole value, or a long word of one."""
        for word in self.words():
            text = text.replace(word, HIDDEN)
        return text

    def words(self) -> list[str]:
        """What must not be repeated, the longest first; how a body is written is none."""
        values = [v for name, v in self.headers.items() if name.lower() != "content-type"]
        values += self.query.values()
        words = {v for v in values if len(v) >= SHORTEST}
        words |= {w for v in values for w in v.split() if len(w) >= 2 * SHORTEST}
        return sorted(words, key=len, reverse=True)


class Secrets:
    """The list in ``folder`` (None: there is none)."""

    def __init__(self, folder: Path | None) -> None:
        self._folder = folder

    def web(self, url: str) -> Told:
        """What is told to the service at ``url``.

        Raises ActionFailed where the list can not be read, or others can read it, too.
        """
        headers: dict[str, str] = {}
        query: dict[str, str] = {}
        for one in self._read().service:
            if one.fits(url):
                headers |= one.headers
                query |= one.query
        for name, value in headers.items():
            # An error of the library would repeat it.
            if not (value.isascii() and value.isprintable()):
                raise ActionFailed(
                    f"{self._folder}/secrets.toml can not be used: "
                    f"the header {name} has characters that none can have"
                )
        return Told(headers, query)

    def mqtt(self) -> MqttSecret:
        """Who the robot is at its broker; ``ca`` as a whole path. Raises as ``web``."""
        found = self._read().mqtt or MqttSecret()
        if found.ca is not None and self._folder is not None:
            found = MqttSecret(found.user, found.password, str(self._folder / found.ca))
        return found

    def _read(self) -> _Listed:
        if self._folder is None:
            return _Listed()
        file = self._folder / "secrets.toml"
        try:
            with file.open("rb") as opened:
                about = os.fstat(opened.fileno())
                listed = opened.read()
        except FileNotFoundError:
            return _Listed()
        except OSError as error:
            raise ActionFailed(f"{file} can not be read: {error.strerror}") from None
        if stat.S_IMODE(about.st_mode) & 0o077:
            raise ActionFailed(f"{file} may be read by others, so it is not used: chmod 600 it")
        try:
            return msgspec.convert(tomllib.loads(listed.decode()), _Listed)
        except (ValueError, msgspec.ValidationError) as error:
            raise ActionFailed(f"{file} can not be used: {_where(error)}") from None


def _where(error: Exception) -> str:
    """What is wrong, without a word of the file."""
    if isinstance(error, msgspec.ValidationError):
        return str(error)
    line = re.search(r"line \d+", str(error))
    return f"no TOML at {line[0]}" if line else "no TOML in UTF-8"


def _origin(parts: Any) -> tuple[str, str, int] | None:
    try:
        host, port = parts.hostname, parts.port
    except ValueError:
        return None
    scheme = parts.scheme.lower()
    if scheme not in _PORTS or not host:
        return None
    return scheme, host.rstrip("."), port or _PORTS[scheme]


def _pattern(path: str) -> str:
    """``/v1/**`` fits ``/v1`` and all below it."""
    found = ""
    for part in unquote(path).strip("/").split("/"):
        if part == "**":
            found += "(/.*)?"
        elif part:
            found += "/" + re.escape(part).replace(r"\*", "[^/]*")
    return found + "/?"
