"""Random steady flights of every aircraft, from a wide envelope: each is flown, or what keeps it from that is named.

A seeded sample; FDES_TRIMS=1000 asks for that many of each condition (some minutes of each).
"""

import os
import random
import re
import warnings

import numpy as np
import pytest

from fdes.aircraft import catalogue, load
from fdes.analysis.trim import TrimPoint, TrimSpec, trim
from fdes.errors import TrimError
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.plant import SixDof
from fdes.physics.signals import Air
from fdes.units import DEG, FOOT

COUNT = int(os.environ.get("FDES_TRIMS", "8"))
SPEEDS, HEIGHTS = (0.3, 2.0), (0.0, 60000 * FOOT)  # of the condition's; m
CLIMBS, BANKS, SLIPS, LOADS = 30 * DEG, 75 * DEG, 15 * DEG, (0.0, 4.0)
NAMED = re.compile(
    r"the (elevator|aileron|rudder|throttle) would have to be .* and stops at|the throttle would have to be .* of 1"
    r"|still accelerates by .* (falls short|is too much|to the right|to the left|in roll|in pitch|in yaw)"
)
CONDITIONS = [
    (aircraft.id, condition.id)
    for aircraft in catalogue()
    for condition in aircraft.conditions
    if aircraft.at(condition.id).nondimensional
]


def requests(aircraft: str, condition: str, count: int) -> list[tuple[SixDof, TrimSpec]]:
    """So many requests of that aircraft, always the same ones."""
    ready = load(aircraft).at(condition)
    plant, chance = six_dof_of(ready), random.Random(f"{aircraft} {condition}")

    def one() -> TrimSpec:
        V, h = ready.reference.V * chance.uniform(*SPEEDS), chance.uniform(*HEIGHTS)
        gamma, slip = chance.uniform(-CLIMBS, CLIMBS), chance.choice([0.0, chance.uniform(-SLIPS, SLIPS)])
        bank, n = chance.uniform(-BANKS, BANKS), chance.uniform(*LOADS)
        path = chance.choice([{"gamma": gamma}, {"throttle": chance.random()}, {}])
        side = chance.choice([{"beta": slip}, {"beta": slip}, {"n_y": 0.0}])
        turning = n if n > 1.0 else n - 2.0  # to the left as often as to the right below 2
        kinds = [{"beta": slip}, {"bank": bank, **side}, {"n_turn": turning, **side}, {"n": n, "beta": slip}]
        return TrimSpec(V, h)._replace(**path, **chance.choice([*kinds, {"slip_bank": 0.3 * bank}]))

    return [(plant, one()) for _ in range(count)]


def assert_it_stays(point: TrimPoint) -> None:
    """Nothing accelerates; and where the path does not bend up, a second later it is the same flight."""
    plant, spec = point.plant, point.spec
    x, held = plant.start(), plant.trim()
    d = plant.derivative(x, held, Air())
    assert max(abs(v) for v in (d.u, d.v, d.w, d.p, d.q, d.r, d.power)) < 1e-7
    assert all(low - 1e-8 <= s <= high + 1e-8 for s, low, high in zip(point.surfaces, *plant.limits, strict=True))
    first = plant.observe(x, held, Air())
    assert all(np.isfinite(first))
    found = (first.V, first.h, first.gamma, first.beta)
    assert found == pytest.approx((spec.V, spec.h, spec.gamma, spec.beta), rel=1e-9, abs=1e-9)
    if spec.q:
        return
    assert first.psi_dot == pytest.approx(spec.turn, abs=1e-9)
    for _ in range(20):
        x = plant.advance(x, held, Air(), 0.05)
    # It climbs, and the air gets thinner: so far does that go in a second.
    drift = 1e-5 + 3e-4 * abs(spec.V * first.gamma)
    last = plant.observe(x, held, Air())
    for name in ("alpha", "beta", "gamma", "phi", "theta", "p", "q", "r"):
        assert getattr(last, name) == pytest.approx(getattr(first, name), abs=drift), name
    assert pytest.approx(first.V, abs=100.0 * drift) == last.V


def assert_it_is_asked(point: TrimPoint, spec: TrimSpec) -> None:
    """What was asked for is what the instruments show."""
    y = point.outputs()
    shown = {"n": y.n_z, "n_turn": y.n_z, "n_y": y.n_y, "bank": y.phi, "slip_bank": y.phi, "throttle": y.throttle}
    for name, value in shown.items():
        asked = getattr(spec, name)
        if asked is not None:
            assert value == pytest.approx(abs(asked) if name == "n_turn" else asked, abs=1e-7), name
    if spec.n_turn is not None:
        assert y.psi_dot * spec.n_turn > 0.0


def flown_or_refused(plant: SixDof, spec: TrimSpec) -> TrimPoint | str:
    try:
        return trim(plant, spec)
    except TrimError as refused:
        return str(refused)


@pytest.mark.parametrize(("aircraft", "condition"), CONDITIONS)
def test_each_is_flown_or_refused_with_its_limit(aircraft: str, condition: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for plant, spec in requests(aircraft, condition, COUNT):
            found = flown_or_refused(plant, spec)
            if isinstance(found, str):
                assert NAMED.search(found), found
                assert "nan" not in found, found
            else:
                assert_it_stays(found)
                assert_it_is_asked(found, spec)
