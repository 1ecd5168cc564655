"""Which signals of a flight were beyond the tables that its plant reads, or the conditions it is interpolated between.

There a table is held or extrapolated, or the nearest condition flies, and the flight goes on: it is announced, not
ended.
"""

from collections.abc import Mapping, Sequence

from fdes.physics.across_mach import AcrossMach, Between, conditions_of
from fdes.physics.plant import SixDof
from fdes.physics.signals import Outputs, Surfaces, channels
from fdes.physics.terms import ends, term_loads
from fdes.physics.turbofan import Turbofan
from fdes.units import DEG

SURFACES = Surfaces._fields[:3]
SLACK = 0.01  # of the range of a table: what is beyond it by less is not worth a word, such as flight at sea level


def table_ends(plant: SixDof) -> dict[str, tuple[float, float]]:
    """The least and the greatest value of each signal that its tables know [SI]; empty where it has none."""
    found = ends(plant.aero) if plant.aerodynamics is term_loads else {}
    if isinstance(plant.aero, Between | AcrossMach):
        sets = conditions_of(plant.aero)
        found["mach"] = sets[0].mach_0, sets[-1].mach_0
    if isinstance(plant.engine, Turbofan):
        for name, axis in (("mach", plant.engine.mach), ("h", plant.engine.height)):
            low, high = found.get(name, (axis.breakpoints[0], axis.breakpoints[-1]))
            found[name] = max(low, axis.breakpoints[0]), min(high, axis.breakpoints[-1])
    return {name: between for name, between in found.items() if name in Outputs._fields}


def beyond_tables(plant: SixDof, signals: Mapping[str, Sequence[float]], t: Sequence[float] | None = None) -> list[str]:
    """A sentence for each signal that was beyond its tables or conditions, with when it left them first; `t` in s.

    signals: columns of `Outputs`, surfaces from those of `plant.rest`.
    """
    units = {c.name: c.unit for c in channels(Outputs)}
    what = "conditions" if isinstance(plant.aero, Between | AcrossMach) else "tables"
    said = []
    for name, (low, high) in table_ends(plant).items():
        rest = getattr(plant.rest, name) if name in SURFACES else 0.0
        values = [value + rest for value in signals[name]]
        slack = SLACK * (high - low)
        out = [k for k, value in enumerate(values) if not low - slack <= value <= high + slack]
        if not out:
            continue
        worst = max((values[k] for k in out), key=lambda value: max(low - value, value - high))
        end = low if worst < low else high
        scale, unit = (1.0 / DEG, " deg") if units[name] == "rad" else (1.0, "" if name == "mach" else " m")
        when = f" from t = {t[out[0]]:g} s on" if t is not None else ""
        said.append(
            f"{name} is beyond its {what}{when}: it reaches {worst * scale:.4g}{unit}, and they end at "
            f"{end * scale:.4g}{unit}. What is computed there is no longer the source's."
        )
    return said
