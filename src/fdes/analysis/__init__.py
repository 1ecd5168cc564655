"""Understanding: linear models of an aircraft, and the natural modes they have."""

from fdes.analysis.linearize import linear_model
from fdes.analysis.modes import Mode, modes

__all__ = ["Mode", "linear_model", "modes"]
