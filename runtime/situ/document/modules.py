"""Module information: what developers disclose (seed 000, 4.2)."""

from __future__ import annotations

from msgspec import Struct

from situ.document.aside import NOTHING, Aside
from situ.document.spds import DataType


class Requires(Struct, frozen=True, gc=False):
    """Exactly one of ``data`` (a tag) and ``module``."""

    data: str | None = None
    module: str | None = None
    aside: Aside = NOTHING


class Provides(Struct, frozen=True, gc=False):
    data: str
    type: DataType | None = None
    unit: str | None = None
    aside: Aside = NOTHING


class Module(Struct, frozen=True, gc=False):
    """resources: those it may ask for; empty for one that only provides data."""

    name: str
    resources: tuple[str, ...] = ()
    description: str = ""
    requires: tuple[Requires, ...] = ()
    provides: tuple[Provides, ...] = ()
    aside: Aside = NOTHING


class Modules(Struct, frozen=True, gc=False):
    """One ``modules.xml``."""

    modules: tuple[Module, ...] = ()
    aside: Aside = NOTHING
