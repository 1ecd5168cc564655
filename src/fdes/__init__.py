"""FDES, the flight dynamics engineering simulator.

Pick an aircraft, fly it, change a stability derivative, and see what that does.

>>> import fdes
>>> navion = fdes.load("NAVION").at("M0.158_SL", variant="printed")
>>> [mode.name for mode in fdes.modes(navion, form="nelson")]
['short_period', 'phugoid', 'roll', 'dutch_roll', 'spiral']

The public names are loaded when they are first asked for, so that ``import fdes`` stays light.
"""

from importlib import import_module
from typing import Any

__version__ = "0.1.0"

_HOME = {
    "Clock": "fdes.flight",
    "FdesError": "fdes.errors",
    "assess": "fdes.analysis.qualities",
    "edited": "fdes.aircraft",
    "fly": "fdes.flight",
    "load": "fdes.aircraft",
    "linear_model": "fdes.analysis",
    "modes": "fdes.analysis",
    "open_recording": "fdes.flight",
    "plant_of": "fdes.flight",
    "simulate": "fdes.flight",
    "what_if": "fdes.analysis.what_if",
}

__all__ = sorted(_HOME)  # noqa: PLE0605  the table above is the one list of public names


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'fdes' has no attribute {name!r}")
    return getattr(import_module(_HOME[name]), name)


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
