"""Compiled forms against the plain text, which is the specification."""

import importlib.util
import os
import subprocess
import sys
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from fdes import kernel
from fdes.errors import SpecError
from fdes.physics.integrators.dopri5 import dopri5
from fdes.physics.integrators.rk4 import rk4
from fdes.physics.runge_kutta import Tableau, step

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"
SAME = 1e-12  # relative to 1 + the size of a state, after 200 steps: lanes and scalars differ by some 1e-15 a step


def model() -> Any:
    spec = importlib.util.spec_from_file_location("kernel_model", BENCHMARKS / "kernel_model.py")
    assert spec
    assert spec.loader
    module = sys.modules[spec.name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


craft = model()


def slope(held: Any, y: tuple[float, ...]) -> tuple[float, ...]:
    return tuple(craft.derivative(craft.State(*y), held, craft.NAVION))


def flat(values: tuple[Any, ...]) -> list[float]:
    return [v for part in values for v in (flat(part) if isinstance(part, tuple) else [part])]


@pytest.mark.parametrize("tableau", [rk4, dopri5], ids=["rk4", "dopri5"])
@pytest.mark.parametrize("count", [1, 11])
def test_a_batch_flies_as_the_plain_text_does(tableau: Tableau, count: int) -> None:
    """Each aircraft its own, in a block that is not full too."""
    solver = kernel.batch(craft.derivative, tableau)
    starts = [craft.START._replace(u=50.0 + k, h=12000.0 * k / count) for k in range(count)]
    held = [craft.HELD._replace(aileron=0.001 * k) for k in range(count)]
    x = np.array(starts).T.copy()
    numbers = np.repeat(np.array(flat(craft.NAVION))[:, None], count, axis=1)
    assert (solver.states, solver.inputs) == (craft.State._fields, craft.Held._fields)
    assert solver.parameters[:2] == ("body.m", "body.S")
    solver.advance(x, np.array(held).T.copy(), numbers, 0.01, 200)
    for k in (0, count - 1):
        y: tuple[float, ...] = starts[k]
        for _ in range(200):
            y = step(partial(slope, held[k]), y, 0.01, tableau)
        assert x[:, k] == pytest.approx(np.array(y), rel=SAME, abs=SAME)


def test_one_function_compiles_with_all_that_it_calls() -> None:
    machine = kernel.compiled(craft.derivative)
    assert machine is not craft.derivative
    assert machine(craft.START, craft.HELD, craft.NAVION) == pytest.approx(
        craft.derivative(craft.START, craft.HELD, craft.NAVION), rel=1e-13, abs=1e-15
    )


def test_compiling_can_be_switched_off(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FDES_COMPILED", "0")
    assert kernel.compiled(craft.derivative) is craft.derivative
    with pytest.raises(SpecError, match=r"A batch of aircraft needs compiled code, and FDES_COMPILED=0 .*Unset it\."):
        kernel.batch(craft.derivative, rk4)
    with pytest.raises(SpecError, match=r"The slopes of a derivative need compiled code, and FDES_COMPILED=0"):
        kernel.jacobian(craft.derivative)


def test_a_new_process_compiles_nothing_again(tmp_path: Path) -> None:
    """And what was compiled of other sources is not used: the folder is named for them."""
    program = (
        "import sys\n"
        f"sys.path.insert(0, {str(BENCHMARKS)!r})\n"
        "from kernel_model import HELD, NAVION, START, derivative\n"
        "from fdes.kernel import compiled\n"
        "machine = compiled(derivative)\n"
        "machine(START, HELD, NAVION)\n"
        "print(sum(machine.stats.cache_hits.values()), sum(machine.stats.cache_misses.values()))\n"
    )
    environment = os.environ | {"XDG_CACHE_HOME": str(tmp_path), "LOCALAPPDATA": str(tmp_path)}

    def run() -> str:
        return subprocess.run(
            [sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True
        ).stdout.strip()

    assert run() == "0 1"
    assert run() == "1 0"


def test_numba_is_not_loaded_until_something_is_compiled() -> None:
    code = "import sys, fdes.kernel, fdes.flight; print('numba' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "False\n"
