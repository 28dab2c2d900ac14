"""A project as a value: the folder with ``situ.toml`` and every file it names.

formats.md, *A project*. A single ``.rbd.xml`` or ``.spds.xml`` is a project too.
Reading and writing is ``situ.document.folder``'s.
"""

from __future__ import annotations

from typing import Any

from msgspec import Struct, field

from situ.document.modules import Module, Modules
from situ.document.rbd import Application
from situ.document.spds import Spds

SETTING_TYPES = ("text", "number", "time", "date", "boolean", "choice")
"""What a setting may be; times are ``HH:MM``, dates ``YYYY-MM-DD``, a choice one of its texts."""


class Setting(Struct, frozen=True):
    """``[[setting]]``: a form with which end users change a durable tag.

    choices: for the type ``choice`` only, in the order in which they are shown.
    """

    tag: str
    label: str = ""
    type: str = "text"
    choices: tuple[str, ...] = ()


class Mqtt(Struct, frozen=True):
    """``[mqtt]``. incoming: topic filter to ``event:NAME`` or ``tag:NAME``."""

    url: str = ""
    incoming: dict[str, str] = field(default_factory=dict)


class Project(Struct, frozen=True, kw_only=True):
    """All of a project that has been read; paths are relative to ``root``, with ``/``.

    applications: file to application, in the project's order, which counts.
    parts: file to application, those that only a ``flow`` names.
    texts: language to (text as written to translation), from ``texts/LANG.po``.
    readings: language to (word as written to how its voice says it), from the same.
    tags: values before the start, ``robot.local.toml`` already laid over them.
    places: name to (x metres, y metres, heading degrees) in the robot's map.
    announce: whether a robot that can be reached from the network tells there that it is there.
    """

    root: str
    name: str
    toml: str | None = None
    applications: dict[str, Application] = field(default_factory=dict)
    parts: dict[str, Application] = field(default_factory=dict)
    spds_file: str | None = None
    spds: Spds | None = None
    modules_file: str | None = None
    modules: Modules | None = None
    media: str | None = None
    scenarios: str | None = None
    languages: tuple[str, ...] = ()
    texts: dict[str, dict[str, str]] = field(default_factory=dict)
    readings: dict[str, dict[str, str]] = field(default_factory=dict)
    endpoint: str = "tcp://127.0.0.1:5570"
    adapter: str = "sim"
    announce: bool = True
    tags: dict[str, Any] = field(default_factory=dict)
    durable: tuple[str, ...] = ()
    places: dict[str, tuple[float, float, float]] = field(default_factory=dict)
    mqtt: Mqtt | None = None
    private: tuple[str, ...] = ()
    settings: tuple[Setting, ...] = ()

    @property
    def flows(self) -> dict[str, Application]:
        """File to application: those of the project, then the parts."""
        return {**self.applications, **self.parts}

    def flow(self, file: str) -> Application | None:
        """What a ``flow`` that names ``file`` runs."""
        return self.parts.get(file) or self.applications.get(file)

    def module(self, name: str) -> Module | None:
        """What the module information says of ``name``."""
        every = self.modules.modules if self.modules is not None else ()
        return next((m for m in every if m.name == name), None)

    def resources(self, module: str) -> tuple[str, ...] | None:
        """The resources that ``module`` declared, in SPDS or module information; None: unknown."""
        if self.spds is not None:
            for declared in self.spds.modules:
                if declared.name == module:
                    return declared.resources
        known = self.module(module)
        return known.resources if known is not None else None

    def declared(self) -> dict[str, tuple[str, ...]]:
        """Every declared module with its resources; applications are not added."""
        found = {m.name: m.resources for m in (self.modules.modules if self.modules else ())}
        found.update({m.name: m.resources for m in (self.spds.modules if self.spds else ())})
        return found
