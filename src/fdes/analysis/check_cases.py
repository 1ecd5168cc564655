"""NASA's check cases flown again: six-degree-of-freedom flights that several simulations agree on.

NASA/TM-2015-218675 prints curves of anonymous simulations, SIM 01 to 06, and no tolerance. The two that agree best with
each other and with the constants of the report are held here, at demands of our own. Points of their curves travel
with FDES; a folder of the whole curves may be named instead.

Drag is in proportion to density, and each simulation has its own: SIM 05's is 1e-6 to 4e-6 above the US Standard
Atmosphere 1976. So where there is drag, the flight is compared twice: as it is, and with the drag that the density
printed by that simulation makes. The second is held.
"""

import csv
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from fdes.errors import SpecError
from fdes.flight.s119 import s119_columns
from fdes.flight.scenario import Scenario, fly_scenario, load_scenario, with_drag
from fdes.physics.aero import SimpleBody
from fdes.physics.atmosphere import standard_atmosphere
from fdes.units import FOOT, SLUG

POINTS = files("fdes.sources") / "nesc_check_cases.csv"
HELD = ("SIM 04", "SIM 05")
DENSITY, TIME = "airDensity_slug_ft3", "time_s"
EULER = ("eulerAngle_deg_Yaw", "eulerAngle_deg_Pitch", "eulerAngle_deg_Roll")
ALTITUDE, LATITUDE, LONGITUDE = "altitudeMsl_ft", "latitude_deg", "longitude_deg"
TENTH_OF_A_FOOT = 2.7e-7  # deg of latitude; of longitude somewhat less than that

Column = NDArray[np.float64]
Curves = Mapping[str, Column]


@dataclass(frozen=True)
class Demand:
    """How near a scenario must come. folder: of its curves. not_held: a simulation that is shown only, and why."""

    folder: str
    tolerances: Mapping[str, float]
    not_held: Mapping[str, str]


NOTHING: Mapping[str, str] = {}
DEMANDS = {
    "nesc_01_dropped_sphere": Demand("Atmos_01_DroppedSphere", {ALTITUDE: 1e-4}, NOTHING),
    "nesc_02_tumbling_brick": Demand("Atmos_02_TumblingBrickNoDamping", dict.fromkeys(EULER, 1e-4), NOTHING),
    "nesc_03_tumbling_brick_damped": Demand(
        "Atmos_03_TumblingBrickDamping",
        dict.fromkeys(EULER, 1e-3),
        {"SIM 04": "damps the rates in inertial space, not those relative to the air, which turns with the Earth"},
    ),
    "nesc_06_dropped_sphere_drag": Demand("Atmos_06_DroppedSphereEllipsoidalNoWind", {ALTITUDE: 3e-4}, NOTHING),
    "nesc_07_dropped_sphere_wind": Demand(
        "Atmos_07_DroppedSphereSteadyWind", {ALTITUDE: 3e-4, LONGITUDE: 1e-9}, NOTHING
    ),
    "nesc_09_cannonball_east": Demand("Atmos_09_EastwardCannonball", {ALTITUDE: 2e-3, LONGITUDE: 1e-8}, NOTHING),
    "nesc_11_f16_trim": Demand(
        "Atmos_11_TrimCheckSubsonicF16",
        {ALTITUDE: 0.02, LATITUDE: TENTH_OF_A_FOOT, LONGITUDE: TENTH_OF_A_FOOT},
        {"SIM 04": "begins in another trim, at a pitch attitude of 2.63873 deg against 2.63893 deg"},
    ),
    "nesc_13_1_f16_altitude": Demand(
        "Atmos_13p1_SubsonicAltitudeChangeF16",
        {ALTITUDE: 0.2},
        {"SIM 04": "begins in another trim; with the references of the autopilot's own file it would be 0.47 ft"},
    ),
}


@dataclass(frozen=True)
class Comparison:
    """One column of one flight beside that of a simulation. Errors are the largest of the flight, in the column's unit.

    raw: as flown. error: with the drag of the simulation's density. excess: how much more density that is, relative.
    note: why it is not held; empty where it is.
    """

    scenario: str
    title: str
    simulation: str
    column: str
    t: Column
    difference: Column
    raw: float
    error: float
    excess: float
    tolerance: float
    note: str

    @property
    def passed(self) -> bool:
        """Whether it is within the tolerance, or not held."""
        return bool(self.note) or self.error <= self.tolerance


def check_cases(folder: Path | None = None) -> list[Comparison]:
    """All comparisons, with the points that come with FDES or with the whole curves in `folder`.

    Raises SpecError where `folder` does not hold the curves.
    """
    return [c for name in DEMANDS for c in check_case(name, folder)]


def check_case(name: str, folder: Path | None = None) -> Iterator[Comparison]:
    """The comparisons of one scenario."""
    demand, scenario = DEMANDS[name], load_scenario(name)
    flown = _columns_of(scenario)
    for simulation in HELD:
        end = scenario.clock.duration
        curves = _points(name, simulation) if folder is None else _curves(folder, demand, simulation, end)
        excess = _excess_density(scenario, curves)
        with_theirs = flown
        if excess:
            denser = with_drag(scenario, 1.0 + excess)
            with_theirs = _columns_of(denser)
        rows = np.rint(curves[TIME] / scenario.row).astype(int)
        for column, tolerance in demand.tolerances.items():
            raw, difference = (_difference(column, f[column][rows], curves[column]) for f in (flown, with_theirs))
            yield Comparison(
                scenario=name,
                title=scenario.title,
                simulation=simulation,
                column=column,
                t=curves[TIME],
                difference=difference,
                raw=float(np.abs(raw).max()),
                error=float(np.abs(difference).max()),
                excess=excess,
                tolerance=tolerance,
                note=demand.not_held.get(simulation, ""),
            )


def _columns_of(scenario: Scenario) -> Curves:
    return s119_columns(scenario.plant.earth, fly_scenario(scenario), scenario.plant.warmer)


def _excess_density(scenario: Scenario, curves: Curves) -> float:
    """How much denser the simulation's air is than the standard's at its own heights, on average; 0 without drag."""
    if not isinstance(scenario.plant.aero, SimpleBody) or not scenario.plant.aero.CD:
        return 0.0
    ours = np.array([standard_atmosphere(h).rho for h in (curves[ALTITUDE] * FOOT).tolist()])
    return float(np.mean(curves[DENSITY] * SLUG / FOOT**3 / ours)) - 1.0


def _difference(column: str, ours: Column, theirs: Column) -> Column:
    """Ours less theirs; that of angles is from -180 to 180 degrees."""
    found = ours - theirs
    return (found + 180.0) % 360.0 - 180.0 if column in EULER else found


def _points(name: str, simulation: str) -> Curves:
    with POINTS.open(encoding="utf-8") as file:
        return _columns(r for r in csv.DictReader(file) if r["scenario"] == name and r["simulation"] == simulation)


def _curves(folder: Path, demand: Demand, simulation: str, end: float | None) -> Curves:
    """Every tenth of a second of a published curve, until `end` [s]."""
    number = demand.folder.split("_")[1]
    path = folder / demand.folder / f"Atmos_{number}_{simulation.lower().replace(' ', '_')}.csv"
    if not path.is_file():
        raise SpecError(
            f"{path} is not there. Name the folder that holds {demand.folder} and the other check cases of "
            "NASA/TM-2015-218675, as unpacked; or leave --data out to use the points that come with FDES."
        )
    with path.open(encoding="utf-8", newline="") as file:
        rows = [{TIME: r["time"], **r} for r in csv.DictReader(file)]
    flown = [r for r in rows if end is None or float(r[TIME]) < end + 1e-5]
    return _columns(r for r in flown if math.isclose(float(r[TIME]), round(float(r[TIME]), 1), abs_tol=1e-5))


def _columns(rows: Iterable[Mapping[str, str]]) -> Curves:
    """Numbers by column; a column that is not given for the case is left out."""
    kept = list(rows)
    wanted = (TIME, ALTITUDE, LATITUDE, LONGITUDE, *EULER, DENSITY)
    return {name: np.array([float(r[name]) for r in kept]) for name in wanted if all(r.get(name) for r in kept)}
