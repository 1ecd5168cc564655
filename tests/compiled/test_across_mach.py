"""An aircraft between two conditions, with an engine that spools up, compiles as it stands."""

from typing import Any

import numpy as np

from fdes.aircraft import load
from fdes.analysis.jacobians import slopes_at
from fdes.analysis.trim import TrimSpec, trim
from fdes.flight.nonlinear import six_dof_of
from fdes.physics.atmosphere import standard_atmosphere
from fdes.physics.plant import State
from fdes.physics.signals import Air, Surfaces

TINY = 1e-30


def test_rates_and_slopes_are_those_of_the_plain_text_below_between_and_beyond() -> None:
    plant = six_dof_of(load("A-4D").at(across="mach", spool=True))
    a = standard_atmosphere(6000.0).a
    points = [trim(plant, TrimSpec(mach * a, 6000.0)) for mach in (0.36, 0.6, 0.84)]
    plants, states = [p.plant for p in points], [p.state._replace(q=0.05, r=-0.02) for p in points]
    held = [Surfaces(0.01, 0.02, -0.03, p.surfaces.throttle + 0.1) for p in points]
    found = slopes_at(plants, states, held)
    for one, x, u, rates, by in zip(plants, states, held, found.rates, found.by, strict=True):
        np.testing.assert_allclose(rates, one.derivative(x, u, Air()), rtol=1e-11, atol=1e-11)
        for column, name in enumerate(State._fields):
            z: dict[str, Any] = {name: complex(getattr(x, name), TINY)}
            stepped = x._replace(**z)
            slope = [complex(v).imag / TINY for v in one.derivative(stepped, u, Air())]
            np.testing.assert_allclose(by[:, column], slope, rtol=1e-10, atol=1e-10)
