"""What came of a design: the law, its gains, and what they give where it was designed and where it is flown."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from math import inf, isfinite
from typing import Any

from fdes.analysis.placement import Quantity
from fdes.control import Law


@dataclass(frozen=True)
class Achieved:
    """What one loop was designed for, and what came of it, in the unit of `quantity`.

    wanted: None where gains were given by hand. before: without this loop. designed: with this loop closed, where it
    was designed. alone: of the whole law, continuous, without sensors and actuators. continuous and flown: with those
    there are, continuous, and sampled at the frame of the flight.
    reached: whether what was wanted could be had.
    """

    law: str
    mode: str
    quantity: Quantity
    unit: str
    wanted: float | None
    before: float
    designed: float
    alone: float
    continuous: float
    flown: float
    reached: bool


@dataclass(frozen=True)
class Designed:
    """A law with all its gains. `text` says it again, in full, without designing; `frame` [s] is that of `flown`.

    gains: by law and field, in SI. notes: what whoever flies it should know.
    """

    law: Law
    text: str
    gains: Mapping[str, Mapping[str, float]]
    achieved: tuple[Achieved, ...]
    notes: tuple[str, ...]
    frame: float

    def as_dict(self) -> dict[str, Any]:
        """What JSON says of it: everything but the law itself."""
        return {
            "text": self.text,
            "gains": {name: {k: v if isfinite(v) else None for k, v in g.items()} for name, g in self.gains.items()},
            "achieved": [{k: v if v != inf else None for k, v in asdict(a).items()} for a in self.achieved],
            "notes": list(self.notes),
            "frame": self.frame,
        }
