"""What is compiled of a nonlinear plant: its structure as text, its numbers as parameters.

Numbers are whatever floats its tuples hold: a mass, a derivative, a wind. Structure is the rest: the functions by which
it flies, whether its Earth is flat, and its tables, which are constants of what is compiled. Plants of one structure
may fly in one batch. The equations are those of `fdes.physics.plant`, as they stand.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any, NamedTuple

from fdes.analysis.straight_line import arrays_of, longest_axis, spot_text, term_names, term_text
from fdes.elementary import where
from fdes.errors import SpecError
from fdes.kernel import module_of
from fdes.physics import earth as earths
from fdes.physics.across_mach import across_mach_loads
from fdes.physics.atmosphere import air_at, standard_atmosphere
from fdes.physics.plant import SixDof, State, air_loads, day_at, derivative, thrust_of
from fdes.physics.signals import Air, Surfaces
from fdes.physics.tables import Spot, spot
from fdes.physics.terms import TermAero, body_coefficients

PARTS = ("inertia", "aero", "engine", "limits", "rest", "wind", "warmer", "earth")  # of a plant: those with numbers
TEXT = """\
def air_loads(plant, flow, feel):
    return aerodynamics({aero}, flow, feel)

def thrust_of(plant, flow, h, throttle, power):
    return propulsion({engine}, flow, h, throttle, power)

def day_at(plant, h):
    return atmosphere(h, plant.warmer)

def rates(x, given, numbers):
    return derivative(numbers, x, given.held, given.air)

def rates_in_air(x, held, numbers):
    return derivative(numbers.plant, x, held, numbers.air)
"""


class Given(NamedTuple):
    """What is held through a step: the surfaces as the face of the plant has them, and the air."""

    held: Surfaces
    air: Air


@dataclass(frozen=True)
class Kind:
    """The structure of a plant: plants of one kind may fly in one batch. plant: one of them."""

    key: tuple[Any, ...]
    plant: SixDof = field(compare=False)


class Structure(NamedTuple):
    """What `fdes.kernel` compiles of a plant.

    rates(x, given, numbers) is dx/dt, `given` a `Given`; rates_in_air(x, held, numbers) is the same, the air being the
    last of the numbers. instead: functions to be compiled in the place of others.
    """

    rates: Callable[..., Any]
    rates_in_air: Callable[..., Any]
    instead: Mapping[Any, Any]


def kind_of(plant: SixDof) -> Kind:
    """The kind of `plant`. Raises SpecError where it is interpolated between more than two conditions."""
    if plant.aerodynamics is across_mach_loads:
        raise SpecError(
            f"An aircraft that is interpolated across Mach between {len(plant.aero.pieces) + 1} conditions cannot be "
            "compiled: it chooses two of them underway. Fly it in the plain form, or without across."
        )
    functions = plant.aerodynamics, plant.propulsion, plant.atmosphere
    tables = _fixed(plant.aero), _fixed(plant.engine)
    return Kind((functions, tables, type(plant.aero), type(plant.engine), bool(plant.earth.g)), plant)


@cache
def structure_of(kind: Kind) -> Structure:
    """What is compiled of plants of that kind."""
    plant = kind.plant
    text = TEXT.format(aero=_rebuilt("plant.aero", plant.aero), engine=_rebuilt("plant.engine", plant.engine))
    longest = longest_axis((plant.aero, plant.engine))
    text += spot_text(longest)
    names = {
        "derivative": derivative,
        "aerodynamics": plant.aerodynamics,
        "propulsion": plant.propulsion,
        "atmosphere": air_at if plant.atmosphere is standard_atmosphere else plant.atmosphere,
        "where": where,
        "Spot": Spot,
        **_constants("aero", plant.aero, longest),
        **_constants("engine", plant.engine, longest),
    }
    if isinstance(plant.aero, TermAero):
        text, names = text + "\n" + term_text(plant.aero), names | term_names(plant.aero, longest)
    made = module_of(text, names)
    flat = bool(plant.earth.g)
    instead = {
        air_loads: made.air_loads,
        thrust_of: made.thrust_of,
        day_at: made.day_at,
        earths.place: earths.flat_place if flat else earths.round_place,
        earths.gravitation: earths.flat_gravitation if flat else earths.round_gravitation,
        spot: made.spot,
    }
    if isinstance(plant.aero, TermAero):
        instead[body_coefficients] = made.body_coefficients
    craft = _tuple_type("Airframe", {part: getattr(plant, part) for part in PARTS})
    in_air = _tuple_type("InAir", {"plant": craft, "air": Air})
    made.rates.__annotations__ = {"x": State, "given": Given, "numbers": craft, "return": State}
    made.rates_in_air.__annotations__ = {"x": State, "held": Surfaces, "numbers": in_air, "return": State}
    return Structure(made.rates, made.rates_in_air, instead)


def numbers_of(plant: SixDof) -> list[float]:
    """The numbers of a plant, in the order of the parameters of what is compiled of it."""
    return [v for part in PARTS for v in _numbers(getattr(plant, part))]


def _numbers(value: Any) -> list[float]:
    """All numbers of a named tuple, and of those within it."""
    if not _varies(value):
        return []
    return [v for part in value for v in _numbers(part)] if isinstance(value, tuple) else [float(value)]


def _varies(value: Any) -> bool:
    """Whether there are numbers in it, of which each aircraft of a batch has its own; tables are none."""
    if isinstance(value, tuple):
        return hasattr(value, "_fields") and any(_varies(part) for part in value)
    return isinstance(value, float | int) and not isinstance(value, bool)


def _fixed(value: Any) -> Any:
    """What of a named tuple is the same for all aircraft of a batch."""
    if not hasattr(value, "_fields"):
        return None if _varies(value) else value
    return tuple(_fixed(part) for part in value)


def _tuple_type(name: str, parts: Mapping[str, Any]) -> Any:
    """A named tuple type for what varies of those parts, or for parts that are such types already."""
    fields: list[tuple[str, type]] = []
    for name_, part in parts.items():
        if isinstance(part, type):
            fields.append((name_, part))
        elif isinstance(part, tuple) and _varies(part):
            inner = {f: getattr(part, f) for f in part._fields}  # type: ignore[attr-defined]  # it varies, so it is named
            whole = all(_varies(v) for v in part)
            fields.append((name_, type(part) if whole else _tuple_type(f"{type(part).__name__}Numbers", inner)))
        elif _varies(part):
            fields.append((name_, float))
    make: Any = NamedTuple  # whose fields a type checker wants to know; they are those of the plant
    return make(name, fields)


def _rebuilt(place: str, value: Any) -> str:
    """The text of that part of a plant: of its own numbers, and of constants for its tables."""
    if isinstance(value, TermAero) or all(_varies(part) for part in value):
        return place  # terms have their tables in the text that is made of them
    name = place.rpartition(".")[2]
    parts = (f"{place}.{f}" if _varies(getattr(value, f)) else f"{name}_{f}" for f in value._fields)
    return f"{name}_type({', '.join(parts)})"


def _constants(name: str, value: Any, longest: int) -> dict[str, Any]:
    """What `_rebuilt` asks for by name."""
    if isinstance(value, TermAero):
        return {}
    fixed = [f for f in value._fields if not _varies(getattr(value, f))]
    return {f"{name}_type": type(value), **{f"{name}_{f}": arrays_of(getattr(value, f), longest) for f in fixed}}
