"""What a client says, as JSON: values as modules have them, numpy's too, but no NaN."""

from __future__ import annotations

import math
from typing import Any

import msgspec

from situ.blackboard.protocol import Request
from situ.errors import BlackboardError


def encode(request: Request) -> bytes:
    """The body of a request. Raises BlackboardError where a value is no JSON value.

    Arrays and numbers of numpy (whatever has ``tolist``) are what they hold.
    """
    try:
        body = _encoder.encode(request)
        # Written as null they would delete.
        if b"null" in body and not _is_finite(msgspec.structs.asdict(request)):
            raise ValueError("NaN and infinity are none; set None where there is no value")
    except (TypeError, ValueError, OverflowError, RecursionError) as error:
        raise BlackboardError(f"no JSON value: {error}") from None
    return body


def _plain(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{type(value).__module__}.{type(value).__qualname__} is unsupported")


def _is_finite(value: Any) -> bool:
    if isinstance(value, float):
        return math.isfinite(value)
    if isinstance(value, dict):
        return all(map(_is_finite, value.values()))
    if isinstance(value, list | tuple | set | frozenset):
        return all(map(_is_finite, value))
    return not hasattr(value, "tolist") or _is_finite(value.tolist())


_encoder = msgspec.json.Encoder(enc_hook=_plain)
