"""Services: a request over http, or a file of the project's media (``media:quiz.json``).

GET, HEAD, OPTIONS and DELETE send the params as a query, all other methods as a JSON object;
as a form where the robot's ``secrets.toml`` gives the service that ``Content-Type``.
The answer's JSON is the result; an empty answer is null, ``text/plain`` a string.
"""

from __future__ import annotations

import asyncio
import logging
import re
from typing import Any
from urllib.parse import unquote, urlencode, urlsplit

import httpx
import msgspec

from situ.blackboard.wire import too_deep
from situ.engine.actions import ActionFailed
from situ.engine.clock import Clock, pause
from situ.engine.media import MediaFolder
from situ.engine.secrets import HIDDEN, Secrets, Told

LIMIT = 4 * 1024 * 1024
"""Bytes that an answer may have."""

REDIRECTS = 5
AGAIN = (0.25, 1.0, 4.0)
"""Seconds before each further try, of what may be asked twice."""

_IN_QUERY = ("GET", "HEAD", "OPTIONS", "DELETE")
_METHODS = (*_IN_QUERY, "POST", "PUT", "PATCH")
_REPEATABLE = ("GET", "HEAD", "OPTIONS", "PUT", "DELETE")
_BUSY = (502, 503, 504)
_FORM = "application/x-www-form-urlencoded"
_LOOPBACK = ("all://127.0.0.1", "all://localhost", "all://[::1]")


class Services:
    """Asks services. timeout: seconds that one answer may take, all in all, with what is tried
    again and where it is sent on to. secrets: what it tells to whom."""

    def __init__(
        self,
        media: MediaFolder,
        clock: Clock,
        log: logging.Logger,
        timeout: float = 30.0,
        secrets: Secrets | None = None,
    ) -> None:
        self._media = media
        self._clock = clock
        self._log = log
        self._timeout = timeout
        self._secrets = secrets or Secrets(None)
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
            self._client = _client(self._timeout)
        told = self._secrets.web(url)
        try:
            async with asyncio.timeout(self._timeout):
                return await self._tried(self._client, url, method, params, told, shown)
        except (TimeoutError, httpx.TimeoutException):
            raise ActionFailed(f"{shown} did not answer within {self._timeout:g} s") from None
        except httpx.ConnectError:
            raise ActionFailed(f"{shown} can not be reached") from None
        except (httpx.HTTPError, httpx.InvalidURL, httpx.StreamError, UnicodeError) as error:
            raise ActionFailed(told.hide(f"{shown}: {_words(error)}")) from None

    async def _tried(
        self,
        client: httpx.AsyncClient,
        url: str,
        method: str,
        params: dict[str, Any],
        told: Told,
        shown: str,
    ) -> tuple[Any, int]:
        """Asks, and once more after a while where nobody was there and twice is as good as once."""
        for wait in (*AGAIN, None) if method in _REPEATABLE else (None,):
            try:
                request = _asking(client, url, method, params, told)
                return await self._exchange(client, request, shown)
            except (httpx.NetworkError, httpx.RemoteProtocolError):
                if wait is None:
                    raise
            except ActionFailed as failed:
                if wait is None or failed.status not in _BUSY:
                    raise
            await pause(self._clock, wait)
        raise AssertionError("the last try gives or raises")

    async def _exchange(
        self, client: httpx.AsyncClient, request: httpx.Request, shown: str
    ) -> tuple[Any, int]:
        """The answer, where the service sends on by whom it sends on to.

        A secret goes only where it belongs: each address is told what ``secrets.toml`` has
        for that very address.
        """
        told = self._secrets.web(str(request.url))
        for _ in range(REDIRECTS + 1):
            response = await client.send(request, stream=True)
            try:
                following = response.next_request
                if following is None:
                    return await self._answer(response, told, shown), response.status_code
            finally:
                await response.aclose()
            request, told = self._sent_on(following, told)
        raise ActionFailed(f"{shown} sends from one address to the next")

    def _sent_on(self, request: httpx.Request, before: Told) -> tuple[httpx.Request, Told]:
        for name in before.headers:
            if name.lower() != "content-type":
                request.headers.pop(name, None)
        told = self._secrets.web(str(request.url))
        request.headers.update(
            {name: v for name, v in told.headers.items() if name.lower() != "content-type"}
        )
        if told.query:
            request.url = request.url.copy_merge_params(told.query)
        return request, told

    async def _answer(self, response: httpx.Response, told: Told, shown: str) -> Any:
        status = response.status_code
        if not response.is_success:
            reason = told.hide(f"{shown} answered {status} {response.reason_phrase}".strip())
            raise ActionFailed(reason, status)
        body = bytearray()
        async for chunk in response.aiter_bytes():
            body += chunk
            if len(body) > LIMIT:
                raise ActionFailed(f"{shown} answered with more than {LIMIT >> 20} MB", status)
        if not body.strip():
            return None
        for word in told.words():
            # Some services repeat what they were told; the trace must not.
            body = body.replace(word.encode(), HIDDEN.encode())
        if response.headers.get("content-type", "").startswith("text/plain"):
            return body.decode("utf-8", "replace")
        try:
            return _value(bytes(body))
        except ValueError as error:
            raise ActionFailed(f"{shown} answered with something that is {error}", status) from None


def _client(timeout: float) -> httpx.AsyncClient:
    for name in ("httpx", "httpcore"):
        # Their lines have whole addresses and headers.
        logging.getLogger(name).setLevel(logging.WARNING)
    return httpx.AsyncClient(
        timeout=timeout,
        # A proxy from the environment never stands between a robot and itself.
        mounts=dict.fromkeys(_LOOPBACK),
        headers={"Accept": "application/json"},
    )


def _asking(
    client: httpx.AsyncClient, url: str, method: str, params: dict[str, Any], told: Told
) -> httpx.Request:
    """The request, the params where its method has them, and what the service is told."""
    headers = httpx.Headers(told.headers)
    # httpx would replace a query that stands in the url already.
    query = httpx.URL(url).params
    content = None
    if method in _IN_QUERY:
        query = query.merge({name: _text(value) for name, value in params.items()})
    else:
        kind = headers.setdefault("Content-Type", "application/json")
        if kind.split(";")[0].strip().lower() == _FORM:
            content = urlencode({name: _text(value) for name, value in params.items()}).encode()
        else:
            content = msgspec.json.encode(params)
    query = query.merge(told.query)
    return client.build_request(
        method, url, params=query if query else None, content=content, headers=headers
    )


def _value(body: bytes) -> Any:
    """What may stand on the blackboard. Raises ValueError: what the body is instead."""
    try:
        value = msgspec.json.decode(body)
        if too_deep([value]):
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
