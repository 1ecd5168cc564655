"""The largest stable step: closed forms, the classical limits, and that a flight indeed grows beyond it."""

import pytest

from fdes.aircraft import load
from fdes.analysis import modes
from fdes.analysis.modes import Mode
from fdes.analysis.step_limit import step_limit
from fdes.flight import Clock, plant_of, simulate
from fdes.shelf import shelf


def mode(eigenvalue: complex) -> Mode:
    return Mode("a mode", "lateral", eigenvalue, abs(eigenvalue), 0.0, None, None, None, None, {})


@pytest.mark.parametrize(("name", "limit"), [("euler", 2.0), ("heun", 2.0), ("rk4", 2.785), ("kutta_merson", 3.548)])
def test_limits_on_the_real_axis(name: str, limit: float) -> None:
    found = step_limit(shelf("integrators").get(name), [mode(-2.0 + 0.0j)])
    assert found is not None
    assert found[0] == pytest.approx(limit / 2.0, rel=1e-3)


def test_euler_on_an_oscillation() -> None:
    """|1 + h lambda| = 1 at h = 2 zeta / omega_n."""
    eigenvalue = -0.409 + 3.807j
    found = step_limit(shelf("integrators").get("euler"), [mode(eigenvalue)])
    assert found is not None
    assert found[0] == pytest.approx(-2.0 * eigenvalue.real / abs(eigenvalue) ** 2)


def test_what_is_unstable_anyway_sets_no_limit() -> None:
    assert step_limit(shelf("integrators").get("rk4"), [mode(0.1 + 1.0j)]) is None


@pytest.mark.parametrize("name", ["euler", "rk4", "kutta_merson"])
def test_a_flight_grows_beyond_the_limit_and_not_before(name: str) -> None:
    condition = load("A-4D").at("M0.4_SL", variant="printed")
    plant = plant_of(condition, "paper", name)
    found = step_limit(plant.integrator, modes(condition, "paper"))
    assert found is not None
    limit, guilty = found
    assert guilty.name == "dutch_roll"
    for factor, grows in ((0.99, False), (1.01, True)):
        clock = Clock(factor * limit, duration=100 * factor * limit)
        flight = simulate(condition, clock=clock, form="paper", integrator=name, initial=["beta=0.01rad"])
        late, early = abs(flight["state_beta"][-40:]).max(), abs(flight["state_beta"][:40]).max()
        assert bool(late > early) is grows
