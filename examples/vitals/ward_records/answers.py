"""The two kinds of answers: to the robot, and to a browser."""

from __future__ import annotations

from aiohttp import web


def refused(status: int, why: str) -> web.Response:
    return web.json_response({"error": why}, status=status)


def shown(text: str, status: int = 200) -> web.Response:
    return web.Response(text=text, status=status, content_type="text/html")
