"""Which modules a robot knows, which of them are there, and what each may ask for."""

from __future__ import annotations

from msgspec import Struct

from situ.document.project import Project


class PresenceState(Struct):
    """connected: module to the resources it says it has. everyone: a declared module counts as
    present unless it is ``gone``; else only connected ones do.
    """

    connected: dict[str, tuple[str, ...]] = {}
    gone: list[str] = []
    everyone: bool = True


class Presence:
    """The modules of one robot; its applications are always present."""

    def __init__(self, project: Project) -> None:
        self.state = PresenceState()
        self._project = project
        self._declared = project.declared()
        self._applications = {one.name for one in project.applications.values()}

    def modules(self) -> dict[str, bool]:
        """Every module known, in order of name, and whether it is present."""
        known = {*self._declared, *self.state.connected} - self._applications
        return {name: self.is_present(name) for name in sorted(known)}

    def is_present(self, module: str) -> bool:
        state = self.state
        if module in self._applications or module in state.connected:
            return True
        return state.everyone and module in self._declared and module not in state.gone

    def lacks(self, module: str) -> list[str]:
        """The modules that it requires and that are absent."""
        known = self._project.module(module)
        required = [r.module for r in known.requires] if known is not None else []
        return [name for name in required if name is not None and not self.is_present(name)]

    def connect(self, module: str, resources: tuple[str, ...]) -> None:
        self.came(module)
        self.state.connected[module] = resources

    def came(self, module: str) -> None:
        """It says something, so it is there."""
        if module in self.state.gone:
            self.state.gone.remove(module)

    def lose(self, module: str) -> str | None:
        """It is gone. Gives why not, where there is no such module."""
        if module in self._applications or self._resources(module) is None:
            return f"there is no module {module}"
        self.came(module)
        self.state.gone.append(module)
        self.state.gone.sort()
        self.state.connected.pop(module, None)
        return None

    def refusal(self, module: str, resources: tuple[str, ...]) -> str | None:
        """Why a module may not ask for or command these, and what to do; None where it may."""
        declared = self._resources(module)
        if module in self._applications:
            return f"{module} is an application; its states ask for it"
        if declared is None:
            return (
                f"the module {module} is not declared: "
                "ask the task designer for a priority in the script"
            )
        if strange := [r for r in resources if r not in declared]:
            return (
                f"{module} did not declare {', '.join(strange)}: declare it in the module "
                "information and ask the task designer for a priority"
            )
        return None

    def _resources(self, module: str) -> tuple[str, ...] | None:
        return self._declared.get(module, self.state.connected.get(module))
