"""Which address a secret belongs to."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from situ.engine.secrets import Secrets, ServiceSecret


@pytest.mark.parametrize(
    ("pattern", "url"),
    [
        ("https://api.example/**", "https://api.example/"),
        ("https://api.example/**", "https://API.example:443/v1/find?x=1"),
        ("https://api.example/v1/**", "https://api.example/v1"),
        ("https://api.example/v1/*/find", "https://api.example/v1/a/find"),
        ("http://127.0.0.1:8080/find", "http://127.0.0.1:8080/find"),
        ("https://api.example", "https://api.example/"),
    ],
)
def test_a_secret_belongs_to_its_host_port_and_path(pattern: str, url: str) -> None:
    assert ServiceSecret(pattern).fits(url)


@pytest.mark.parametrize(
    ("pattern", "url"),
    [
        ("https://api.example/**", "http://api.example/"),
        ("https://api.example/**", "https://api.example:8443/"),
        ("https://api.example/**", "https://api.example.evil/"),
        ("https://api.example/**", "https://evil/https://api.example/"),
        ("https://api.example/**", "https://api.example@evil/"),
        ("https://api.example/v1/**", "https://api.example/v1/../admin"),
        ("https://api.example/v1/**", "https://api.example/v1/%2e%2e/admin"),
        ("https://api.example/v1/**", "https://api.example/v12"),
        ("https://api.example/v1/*", "https://api.example/v1/a/b"),
        ("https://api.example/a.c", "https://api.example/abc"),
        ("https://*/**", "https://api.example/"),
        ("ftp://api.example/**", "ftp://api.example/"),
        ("nonsense", "nonsense"),
    ],
)
def test_and_to_no_other(pattern: str, url: str) -> None:
    assert not ServiceSecret(pattern).fits(url)


def test_the_page_shows_a_list_that_is_one(tmp_path: Path) -> None:
    page = (Path(__file__).parents[2] / "docs" / "services.md").read_text("utf-8")
    (listed,) = [
        block
        for block in re.findall(r"```toml\n(.*?)```", page, re.DOTALL)
        if block.startswith("[[service]]")
    ]
    file = tmp_path / "secrets.toml"
    file.write_text(listed, "utf-8")
    file.chmod(0o600)
    secrets = Secrets(tmp_path)
    assert secrets.web("https://weather.example/now").query.keys() == {"key"}
    assert secrets.web("https://pager.example/send").headers.keys() == {"Content-Type"}
    assert secrets.mqtt().ca == str(tmp_path / "ward-ca.pem")
