"""How long something was, in the unit that people would take."""

from __future__ import annotations

from situ_studio.wording.language import tr


def lasting(seconds: float) -> str:
    """``1.5 s``, ``80.7 min``, ``2 h``, ``30 d``: three digits that count."""
    if seconds < 120:
        return tr("{0} s").format(f"{seconds:.3g}")
    if seconds < 7200:
        return tr("{0} min").format(f"{seconds / 60:.3g}")
    if seconds < 48 * 3600:
        return tr("{0} h").format(f"{seconds / 3600:.3g}")
    return tr("{0} d").format(f"{seconds / 86400:.3g}")
