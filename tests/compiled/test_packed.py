"""Packed instructions: that lanes and slopes are computed several at once is looked up in the machine's code."""

import platform
from typing import Any

import numpy as np
import pytest

from fdes.aircraft import load
from fdes.analysis.batch import solver_of
from fdes.analysis.compiled_plant import kind_of
from fdes.analysis.jacobians import _machine as machine_of
from fdes.flight.nonlinear import six_dof_of
from fdes.kernel import FLOATING

OPERATIONS = ("add", "sub", "mul", "div", "sqrt")
MATRIX, FLAT = "float64[:,::1]", "float64[::1]"
MOST = 0.85  # of the numbers that come out; the values themselves are computed one at a time


def packed_and_single(solver: Any, signature: str) -> tuple[int, int]:
    """How many arithmetic instructions take several numbers, and how many take one."""
    import numba

    solver.compile(signature)  # which is soon done where another test of this process has compiled it
    machine = solver
    if solver.stats.cache_hits:  # what comes from the disk shows no instructions
        machine = numba.njit(error_model="numpy", fastmath=FLOATING)(solver.py_func)
        machine.compile(signature)
    text = "\n".join(machine.inspect_asm().values())
    words = [line.strip().partition("\t")[0] for line in text.splitlines()]
    found = [word for word in words if any(o in word for o in OPERATIONS)]
    return sum(word.endswith("pd") for word in found), sum(word.endswith("sd") for word in found)


x86 = pytest.mark.skipif(platform.machine().lower() not in {"x86_64", "amd64"}, reason="counts instructions of x86")


@x86
def test_a_batch_with_tables_is_packed() -> None:
    """All of it, tables looked up and terms too."""
    solver = solver_of(six_dof_of(load("F-16").at()))
    packed, single = packed_and_single(solver.advance, f"void({MATRIX}, {MATRIX}, {MATRIX}, float64, int64)")
    assert packed > 300
    assert single == 0


@x86
def test_the_slopes_of_a_derivative_are_packed() -> None:
    machine = machine_of(kind_of(six_dof_of(load("F-16").at())))
    packed, single = packed_and_single(machine.fill, f"void({MATRIX}, {MATRIX}, {MATRIX}, {MATRIX}, {FLAT})")
    assert 4 * packed > MOST * (4 * packed + single)  # four numbers in each at least, eight with AVX-512
    assert machine.width == 24
    assert np.ceil(len((*machine.states, *machine.inputs)) / 8) * 8 == machine.width
