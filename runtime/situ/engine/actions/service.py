"""Services: a request over http, or a file of the project's media (``media:quiz.json``).

GET, HEAD and DELETE send the params as a query, all other methods as a JSON object.
The answer's JSON is the result; an empty answer is null, ``text/plain`` a string.
"""

from __future__ import annotations

import asyncio
import logging
import re
from typing import Any
from urllib.parse import unquote, urlsplit

import httpx
import msgspec

from situ.blackboard.protocol import too_deep
from situ.engine.actions import ActionFailed
from situ.engine.media import MediaFolder

LIMIT = 4 * 1024 * 1024
"""Bytes that an answer may have."""

_IN_QUERY = ("GET", "HEAD", "DELETE")
_METHODS = (*_IN_QUERY, "POST", "PUT", "PATCH")
_LOOPBACK = ("all://127.0.0.1", "all://localhost", "all://[::1]")


class Services:
    """Asks services. timeout: seconds that one answer may take, all in all."""

    def __init__(self, media: MediaFolder, log: logging.Logger, timeout: float = 30.0) -> None:
        self._media = media
        self._log = log
        self._timeout = timeout
        self._client: httpx.AsyncClient | None = None

    async def close(self) -> None:
        if self._client is not None:
            await self._client.aclose()
            self._client = None

    async def ask(self, url: str, method: str, params: dict[str, Any]) -> tuple[Any, int | None]:
        """The result and the http status (None for files).

        Raises ActionFailed in plain words, with the status if there was one.
        """
        if url.startswith("media:"):
            return self._read(url.removeprefix("media:")), None
        if url.startswith("board:"):
            raise ActionFailed(f"{url}: services of modules are not built yet; use http or media")
        return await self._request(url, method.upper(), params)

    def _read(self, path: str) -> Any:
        file = self._media.find(unquote(path.split("?")[0]))
        if file is None:
            raise ActionFailed(f"there is no file {path} in the project's media")
        try:
            if file.stat().st_size > LIMIT:
                raise ActionFailed(f"media file {path} is larger than {LIMIT >> 20} MB")
            return _value(file.read_bytes())
        except OSError as error:
            raise ActionFailed(f"media file {path} can not be read: {error.strerror}") from error
        except ValueError as error:
            raise ActionFailed(f"media file {path} is {error}") from None

    async def _request(self, url: str, method: str, params: dict[str, Any]) -> tuple[Any, int]:
        shown = _shown(url)
        if method not in _METHODS:
            raise ActionFailed(f"{method} is no method that services know")
        if self._client is None:
            # A proxy from the environment never stands between a robot and itself.
            self._client = httpx.AsyncClient(
                follow_redirects=True,
                max_redirects=5,
                timeout=self._timeout,
                mounts=dict.fromkeys(_LOOPBACK),
                headers={"Accept": "application/json"},
            )
        try:
            more: dict[str, Any] = {}
            if method in _IN_QUERY:
                if params:
                    # httpx would replace a query that stands in the url already.
                    given = httpx.URL(url).params
                    more["params"] = given.merge({k: _text(v) for k, v in params.items()})
            else:
                more["content"] = msgspec.json.encode(params)
                more["headers"] = {"Content-Type": "application/json"}
            async with (
                asyncio.timeout(self._timeout),
                self._client.stream(method, url, **more) as response,
            ):
                return await self._answer(response, shown), response.status_code
        except (TimeoutError, httpx.TimeoutException) as error:
            raise ActionFailed(f"{shown} did not answer within {self._timeout:g} s") from error
        except httpx.ConnectError as error:
            raise ActionFailed(f"{shown} can not be reached") from error
        except httpx.TooManyRedirects as error:
            raise ActionFailed(f"{shown} sends from one address to the next") from error
        except (httpx.HTTPError, httpx.InvalidURL, httpx.StreamError, UnicodeError) as error:
            raise ActionFailed(f"{shown}: {_words(error)}") from error

    async def _answer(self, response: httpx.Response, shown: str) -> Any:
        status = response.status_code
        if not response.is_success:
            raise ActionFailed(
                f"{shown} answered {status} {response.reason_phrase}".strip(), status
            )
        body = bytearray()
        async for chunk in response.aiter_bytes():
            body += chunk
            if len(body) > LIMIT:
                raise ActionFailed(f"{shown} answered with more than {LIMIT >> 20} MB", status)
        if not body.strip():
            return None
        if response.headers.get("content-type", "").startswith("text/plain"):
            return body.decode("utf-8", "replace")
        try:
            return _value(bytes(body))
        except ValueError as error:
            raise ActionFailed(f"{shown} answered with something that is {error}", status) from None


def _value(body: bytes) -> Any:
    """What may stand on the blackboard. Raises ValueError: what the body is instead."""
    try:
        value = msgspec.json.decode(body)
        if too_deep(value):
            raise RecursionError
    except RecursionError:
        raise ValueError("nested too deep") from None
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise ValueError(f"no JSON: {error}") from None
    return value


def _text(value: Any) -> str:
    """A param as it stands in a query: strings as they are, else compact JSON."""
    if isinstance(value, str):
        return value
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    return msgspec.json.encode(value).decode()


def _shown(url: str) -> str:
    """The address as it may stand in a message. Raises ActionFailed where it is none."""
    try:
        parts = urlsplit(url)
        host, port = parts.hostname, parts.port
    except ValueError as error:
        raise ActionFailed(f"{url!r} is no address: {error}") from error
    if parts.scheme not in ("http", "https") or not host:
        raise ActionFailed(f"{url!r} is no address; it begins with http://, https:// or media:")
    # Without user, password and query: those are nobody's business.
    return f"{parts.scheme}://{host}{f':{port}' if port else ''}{parts.path}"


def _words(error: Exception) -> str:
    words = re.sub(r"\s+", " ", str(error)).strip()
    return words or f"the request failed ({type(error).__name__})"
