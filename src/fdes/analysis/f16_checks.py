"""The F-16 against what Stevens, Lewis and Johnson print of it: trims, one state derivative, and a linear model.

Their model and that of the aircraft file differ: in a few entries of the tables, for the file's are those of Garza and
Morelli; in that their tables go on straight beyond their ends; and in constants that they round: those of the inertias,
1/0.00157 slug, 57.3 deg. So each number is computed twice. What the book's own model makes is held, to the digits that
are printed; where the file's makes something else, that is shown with the reason.
"""

import math
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from fdes.aircraft import load
from fdes.analysis.jacobian import linearized
from fdes.analysis.trim import CALM, TrimPoint, TrimSpec, solve
from fdes.analysis.verify import Check
from fdes.elementary import sqrt
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.atmosphere import GAMMA_AIR, Atmosphere
from fdes.physics.plant import SixDof, State, instant, state_at
from fdes.physics.signals import Surfaces
from fdes.physics.tables import Axis
from fdes.physics.terms import Table, TermAero
from fdes.sources import sources
from fdes.units import DEG, FOOT, POUND_FORCE, SLUG, Kelvin, Meter

BOOK = "stevens_lewis_johnson_2015"
RANKINE = 1.0 / 1.8  # K
LINEAGE = "By the aircraft file. The book's entries of tables and rounded constants make what is held."
ROUNDED_DEGREE = 57.3  # by which the book divides sideslip in CZ, instead of 180/pi


class Printed(NamedTuple):
    """A number of the book: its floor is half of its last digit."""

    item: str
    where: str
    quantity: str
    value: float
    floor: float


def f16_checks() -> list[Check]:
    """Every printed number beside ours, in the units of the book."""
    published = sources()[BOOK]
    book = published["f16"]
    file = _plant(book)
    own, unlike = _with_book_numbers(file, book), book["linear"]["unlike"]
    return [
        check
        for numbers in (_speeds, _trims, _state_derivative, _linear)
        for (printed, with_file), (_, with_book) in zip(
            numbers(book, file, own=False), numbers(book, own, own=True), strict=True
        )
        for check in _checks(printed, with_file, with_book, published["citation"], unlike.get(printed.quantity, ""))
    ]


def _checks(printed: Printed, with_file: float, with_book: float, citation: str, unlike: str) -> Iterator[Check]:
    if unlike:
        yield _check(printed, with_book, citation, unlike)
        return
    if abs(with_file - printed.value) > printed.floor:
        yield _check(printed, with_file, citation, LINEAGE)
    yield _check(printed, with_book, citation)


def _check(printed: Printed, computed: float, citation: str, note: str = "") -> Check:
    """One that is held; with a note, one that is not, for that reason."""
    relative = printed.floor / abs(printed.value) if printed.value else 0.0
    return Check(
        item=printed.item,
        quantity=printed.quantity,
        published=printed.value,
        computed=computed,
        tolerance=None if note else relative,
        floor=0.0 if printed.value else printed.floor,
        citation=citation,
        where=printed.where,
        note=note,
    )


def _half_digit(value: float, digits: int, floor: float = 0.0) -> float:
    """Half of the last of so many significant digits."""
    size = math.floor(math.log10(abs(value))) if value else 0
    return max(floor, 0.5 * 10.0 ** (size - digits + 1)) if value else floor


def _plant(book: Mapping[str, Any]) -> SixDof:
    """The plant of the aircraft file in the air, mass and gravity of the book."""
    air = book["atmosphere"]

    def day(h: Meter, warmer: Kelvin) -> Atmosphere:
        factor = 1.0 - air["lapse"] * h / FOOT
        T = air["temperature_0"] * factor
        rho = air["density_0"] * factor ** air["power"]
        p = rho * air["gas_constant"] * T * SLUG / FOOT
        sound = sqrt(GAMMA_AIR * air["gas_constant"] * T) * FOOT
        return Atmosphere(T * RANKINE + warmer, p, rho * SLUG / FOOT**3, sound)

    plant = six_dof_of(load("F-16").at("V502_SL"))
    return plant._replace(
        inertia=plant.inertia._replace(m=book["mass"] * SLUG),
        earth=plant.earth._replace(g=book["gravity"] * FOOT),
        atmosphere=day,
    )


def _with_book_numbers(plant: SixDof, book: Mapping[str, Any]) -> SixDof:
    """The same with the book's tables, with the line of its throttle, and with its 1/Iy."""
    constants = book["constants"]
    throttle, power = Axis(tuple(constants["throttle"]), held=False), tuple(constants["power"])
    return plant._replace(
        aero=_with_book_entries(plant.aero, book),
        engine=plant.engine._replace(throttle=throttle, power=power),
        inertia=plant.inertia._replace(Iy=SLUG * FOOT**2 / constants["C"][6]),
    )


def _with_book_entries(aero: TermAero, book: Mapping[str, Any]) -> TermAero:
    """The tables with the entries that the book prints instead, and going on straight beyond their ends."""
    tables = load("F-16").at("V502_SL").tables
    names = list(tables.tables) if tables else []
    changed = list(aero.tables)
    for name, row, column, value in book["lineage"]["tables"]:
        k = names.index(name)
        values: Any = [list(r) for r in changed[k].values]  # type: ignore[arg-type]  # all of these have two axes
        values[row][column] = value
        changed[k] = Table(changed[k].axes, tuple(map(tuple, values)))
    square = (1.0 / (ROUNDED_DEGREE * DEG)) ** 2
    CZ = tuple(t._replace(gain=t.gain * square) if len(t.signals) == 2 else t for t in aero.sums[2])
    return aero._replace(
        tables=tuple(changed),
        axes=tuple(a._replace(axis=a.axis._replace(held=False)) for a in aero.axes),
        sums=(*aero.sums[:2], CZ, *aero.sums[3:]),
    )


def _at_cg(plant: SixDof, cg: float) -> SixDof:
    reference, aero = load("F-16").at("V502_SL").cg, plant.aero
    return plant._replace(aero=aero._replace(arm=aero.arm + ((reference or 0.0) - cg) * aero.c))


def _speeds(book: Mapping[str, Any], plant: SixDof, *, own: bool) -> Iterator[tuple[Printed, float]]:
    table = book["speeds"]
    for V, *row in table["rows"]:
        point = solve(plant, TrimSpec(V * FOOT, 0.0))
        for name, value in zip(table["columns"][1:], row, strict=True):
            floor = _half_digit(value, table["digits"], table["floor"])
            yield Printed("F16_SPEEDS", table["where"], f"{name} at {V} ft/s", value, floor), _figures(point)[name]


def _trims(book: Mapping[str, Any], plant: SixDof, *, own: bool) -> Iterator[tuple[Printed, float]]:
    trims = book["trims"]
    for name, case in trims.items():
        if not isinstance(case, dict):
            continue
        spec = TrimSpec(502.0 * FOOT, 0.0, turn=case.get("turn", 0.0), beta=case.get("beta", 0.0))
        found = _figures(solve(_at_cg(plant, case["cg"]), spec))
        for quantity, value in case["published"].items():
            floor = _half_digit(value, trims["digits"], case.get("floor", {}).get(quantity, 0.0))
            yield Printed("F16_TRIMS", trims["where"], f"{name}: {quantity}", value, floor), found[quantity]


def _figures(point: TrimPoint) -> dict[str, float]:
    """What the book prints of a trim: surfaces in deg, positive aileron rolling left."""
    x, s = point.state, point.surfaces
    angles = {"alpha": point.alpha, "alpha_deg": point.alpha / DEG, "phi": point.phi, "theta": point.theta}
    surfaces = {"elevator": s.elevator / DEG, "aileron": -s.aileron / DEG, "rudder": s.rudder / DEG}
    return {**angles, **surfaces, "throttle": s.throttle, "p": x.p, "q": x.q, "r": x.r}


def _state_derivative(book: Mapping[str, Any], plant: SixDof, *, own: bool) -> Iterator[tuple[Printed, float]]:
    table = book["state_derivative"]
    V, alpha, beta, phi, theta, psi, p, q, r, north, east, h, power = table["state"]
    x = state_at(plant.earth, (north * FOOT, east * FOOT, h * FOOT), (0.0, 0.0, 0.0), (phi, theta, psi))
    level, v = V * FOOT * math.cos(beta), V * FOOT * math.sin(beta)
    x = x._replace(u=level * math.cos(alpha), v=v, w=level * math.sin(alpha), p=p, q=q, r=r, power=power)
    de, da, dr = (s * DEG for s in table["surfaces"])
    held = Surfaces(de, -da, dr, table["throttle"])
    there = _at_cg(plant, table["cg"])._replace(rest=Surfaces())
    found = _rates(there, x, held, (phi, theta))
    if own:
        found |= _rotation(there, x, held, book["constants"])
    for name, value in zip(table["names"], table["published"], strict=True):
        floor = _half_digit(value, table["digits"])
        yield Printed("F16_DERIVATIVE", table["where"], name, value, floor), found[name]


def _rates(plant: SixDof, x: State, held: Surfaces, attitude: tuple[float, float]) -> dict[str, float]:
    d = plant.derivative(x, held, CALM)
    level = x.u * x.u + x.w * x.w
    V = math.sqrt(level + x.v * x.v)
    V_dot = (x.u * d.u + x.v * d.v + x.w * d.w) / V
    phi, theta = attitude
    turning = x.q * math.sin(phi) + x.r * math.cos(phi)
    return {
        "V_dot": V_dot / FOOT,
        "alpha_dot": (x.u * d.w - x.w * d.u) / level,
        "beta_dot": (V * d.v - x.v * V_dot) / (V * math.sqrt(level)),
        "phi_dot": x.p + math.tan(theta) * turning,
        "theta_dot": x.q * math.cos(phi) - x.r * math.sin(phi),
        "psi_dot": turning / math.cos(theta),
        "p_dot": d.p,
        "q_dot": d.q,
        "r_dot": d.r,
        "north_dot": d.x / FOOT,
        "east_dot": d.y / FOOT,
        "h_dot": -d.z / FOOT,
        "power_dot": d.power,
    }


def _rotation(plant: SixDof, x: State, held: Surfaces, constants: Mapping[str, Any]) -> dict[str, float]:
    """Euler's equations with the book's nine rounded constants; eq. 1.7-18."""
    loads = instant(plant, x, held, CALM).loads
    L, M, N = (moment / (POUND_FORCE * FOOT) for moment in (loads.L, loads.M, loads.N))
    C1, C2, C3, C4, C5, C6, C7, C8, C9 = constants["C"]
    h = constants["angular_momentum"]
    p, q, r = x.p, x.q, x.r
    return {
        "p_dot": (C1 * r + C2 * p + C4 * h) * q + C3 * L + C4 * N,
        "q_dot": (C5 * p - C7 * h) * r - C6 * (p * p - r * r) + C7 * M,
        "r_dot": (C8 * p - C2 * r + C9 * h) * q + C4 * L + C9 * N,
    }


def _linear(book: Mapping[str, Any], plant: SixDof, *, own: bool) -> Iterator[tuple[Printed, float]]:
    """Of V [ft/s], alpha, theta, q; ours are u and w [m/s], which are V and V alpha near the trim."""
    table = book["linear"]
    point = solve(plant, TrimSpec(502.0 * FOOT, 0.0))
    model = linearized(point)
    ours = {"V": ("u", FOOT), "alpha": ("w", point.spec.V), "theta": ("theta", 1.0), "q": ("q", 1.0)}
    elevator = model.inputs.index("elevator")
    for i, into in enumerate(table["states"]):
        name, unit = ours[into]
        row = model.states.index(name)
        gain = float(model.B[row, elevator]) * DEG / unit
        gains = [(f"A[{into}, {of}]", table["A"][i][j], ours[of]) for j, of in enumerate(table["states"])]
        entries = [(q, v, float(model.A[row, model.states.index(n)]) * s / unit) for q, v, (n, s) in gains]
        for quantity, value, found in [*entries, (f"B[{into}, elevator]", table["B"][i], gain)]:
            floor = _half_digit(value, table["digits"], table["floor"])
            yield Printed("F16_LINEAR", table["where"], quantity, value, floor), found
