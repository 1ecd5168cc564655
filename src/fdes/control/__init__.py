"""Control laws and linear systems.

`law` is the contract between a pilot's stick, what is measured, and the surfaces; the shelf `laws` holds those that
exist, and `blocks` what they are made of. `linear` holds a linear model with its names and units, and the exact
zero-order hold. A law sees outputs and never an aircraft.
"""

from fdes.control.law import Law, Stick
from fdes.control.linear import LinearModel, exact_hold

__all__ = ["Law", "LinearModel", "Stick", "exact_hold"]
