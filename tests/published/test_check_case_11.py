"""NASA's check case 11: the F-16, trimmed and unaugmented, for 180 s over the rotating WGS-84 Earth.

Points of SIM 05 of NASA/TM-2015-218675. Their model has no rotor, so neither has ours here. The demand is 0.02 ft of
altitude and 0.1 ft across the ground.
"""

import csv
from importlib.resources import files

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.errors import SpecError, TrimError
from fdes.flight.nonlinear import six_dof_of
from fdes.flight.trim_over_earth import Over, local_rates, trim_over
from fdes.physics.attitude import euler_angles, rotation, seen_from
from fdes.physics.earth import FLAT, WGS84, geodetic, place
from fdes.physics.plant import SixDof, state_at
from fdes.physics.signals import Air
from fdes.units import DEG, FOOT

OVER = Over(36.01916667 * DEG, -75.67444444 * DEG, 10013.0 * FOOT, 400.0 * FOOT, 400.0 * FOOT)
CURVE = [
    {name: float(text) for name, text in row.items()}
    for row in csv.DictReader((files("fdes.sources") / "f16_check_case_11.csv").read_text("utf-8").splitlines())
]


def without_rotor() -> SixDof:
    plant = six_dof_of(load("F-16").at("M0.53_10kft"))
    return plant._replace(inertia=plant.inertia._replace(Hx=0.0))


def test_the_flight() -> None:
    """At a step of 0.05 s. Their first position is 0.002 ft from the one that the case states."""
    plant = trim_over(without_rotor(), WGS84, OVER)
    x, held, k = plant.start(), plant.trim(), 0
    assert x.power == pytest.approx(13.8738, abs=1e-3)
    assert held.elevator == 0.0
    assert len(CURVE) == 7
    for row in CURVE:
        for _ in range(round(row["time_s"] / 0.1) - k):
            x = plant.advance(x, held, Air(), 0.1, 2)
        k = round(row["time_s"] / 0.1)
        latitude, longitude, h = geodetic(WGS84, x.x, x.y, x.z)
        angles = euler_angles(seen_from(place(WGS84, x.x, x.y, x.z).local, rotation(x.e0, x.e1, x.e2, x.e3)))
        assert h / FOOT == pytest.approx(row["altitudeMsl_ft"], abs=2e-3)
        feet = WGS84.a / FOOT
        assert (latitude - row["latitude_deg"] * DEG) * feet == pytest.approx(0.0, abs=5e-3)
        assert (longitude - row["longitude_deg"] * DEG) * feet == pytest.approx(0.0, abs=5e-3)
        for angle, name in zip(angles, ("Roll", "Pitch", "Yaw"), strict=True):
            assert angle / DEG == pytest.approx(row[f"eulerAngle_deg_{name}"], abs=3e-5)


def test_local_axes_turn_as_they_are_seen_to() -> None:
    """Over one second of flight, from the axes at both ends."""
    rates = local_rates(WGS84, OVER)
    start = state_at(WGS84, OVER[:3], OVER[3:], (0.0, 0.0, 0.0))
    R = rotation(start.e0, start.e1, start.e2, start.e3)
    velocity = np.array([R[3 * i : 3 * i + 3] for i in range(3)]) @ np.array([start.u, start.v, start.w])
    there = place(WGS84, *(np.array(start[:3]) + velocity)).local
    phi, theta, psi = euler_angles(seen_from(place(WGS84, *start[:3]).local, there))
    assert (phi, theta, psi) == pytest.approx(rates, rel=1e-4)


def test_what_cannot_be_trimmed_is_said() -> None:
    with pytest.raises(SpecError, match="over a flat one, ask for an ordinary trim"):
        trim_over(without_rotor(), FLAT, OVER)
    with pytest.raises(TrimError, match=r"No trim over that Earth: the nearest has pitch .* Ask for another speed"):
        trim_over(without_rotor(), WGS84, OVER._replace(down=-1500.0 * FOOT))
    stopped = without_rotor()
    up_only = stopped.limits._replace(upper=stopped.limits.upper._replace(elevator=-5.0 * DEG))
    with pytest.raises(TrimError, match=r"elevator -3\.2\d* deg of -25 to -5, throttle"):
        trim_over(stopped._replace(limits=up_only), WGS84, OVER)
