"""Two runs put beside one another: what comes of it goes from process to process. No Qt."""

from __future__ import annotations

from msgspec import Struct

from situ.rehearse.comparing import Difference, common, differences
from situ.rehearse.deeds import Deeds


class Alike(Struct, frozen=True):
    """Where two runs part, and when each did the first thing that both did."""

    differences: list[Difference]
    common: tuple[float, float] | None


def alike(runs: tuple[Deeds, Deeds]) -> Alike:
    """What ``situ.rehearse.comparing`` says of them."""
    return Alike(differences(*runs), common(*runs))
