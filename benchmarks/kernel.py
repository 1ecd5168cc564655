"""Compiled Python beside C++: the same aircraft, the same equations, one core.

    python benchmarks/kernel.py [--aircraft 4096] [--steps 100] [--rounds 7]

kernel_peer.cpp is compiled here with the C++ compiler that is found, once in lanes and once for one aircraft at a time.
A ratio is void if the trajectories differ, or if the peer in lanes is not at least four times its own scalar build.
Rounds are interleaved and timed by processor time; each figure is the best of its rounds, for others only slow it down.
"""

import argparse
import ctypes
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numba
import numpy as np
from kernel_model import HELD, NAVION, START, State, derivative
from numpy.typing import NDArray

from fdes.kernel import FLOATING, batch
from fdes.physics.integrators.rk4 import rk4
from fdes.physics.runge_kutta import step

STEP = 0.01  # s
PEER = Path(__file__).with_name("kernel_peer.cpp")
FLAGS = "-shared -fPIC -std=c++20 -O3 -march=native -w"
LANES_OF_PEER = "-ffast-math -DLANES=8"
SCALAR_PEER = "-fno-math-errno -fno-trapping-math -ffp-contract=fast -fno-tree-vectorize -DLANES=1"
SAME = 1e-12  # of a state, relative to 1 + its size
AT_LEAST = 0.5  # of the peer, demanded of the batch
FAIR = 4.0  # times its scalar build, demanded of the peer

Array = NDArray[np.float64]
Solver = Callable[[Array, Array, Array, int], None]


class Runner(NamedTuple):
    """One way to fly: `aircraft` of them for `steps` steps."""

    name: str
    advance: Solver
    aircraft: int
    steps: int


def main(argv: list[str] | None = None) -> dict[str, float]:
    """Measure, print, and return the figures: millions of aircraft-steps per second, and ratios."""
    options = argparse.ArgumentParser(description="Compiled Python beside C++.")
    options.add_argument("--aircraft", type=int, default=4096)
    options.add_argument("--steps", type=int, default=100)
    options.add_argument("--rounds", type=int, default=7)
    chosen = options.parse_args(argv)
    alone = chosen.aircraft * chosen.steps // 8
    runners = [
        Runner("FDES, batch", ours(batch(derivative, rk4).advance), chosen.aircraft, chosen.steps),
        Runner("FDES, one aircraft", ours(batch(derivative, rk4, lanes=1).advance), 1, alone),
        Runner("plain Python, one aircraft", plain, 1, max(alone // 1000, 1)),
    ]
    compiler = shutil.which("c++") or shutil.which("g++") or shutil.which("clang++")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        if compiler:
            packed = peer(compiler, LANES_OF_PEER, Path(folder) / "packed.so")
            scalar = peer(compiler, SCALAR_PEER, Path(folder) / "scalar.so")
            runners += [
                Runner("C++, batch", packed, chosen.aircraft, chosen.steps),
                Runner("C++, batch, scalar build", scalar, chosen.aircraft, chosen.steps),
                Runner("C++, one aircraft", scalar, 1, alone),
            ]
        figures = measure(runners, chosen.rounds)
        for name, value in figures.items():
            print(f"{name:32} {value:9.3f} M steps/s")
        if not compiler:
            print("No C++ compiler was found on the path, so there is no peer to compare with: install g++ or clang++.")
            return figures
        return figures | ratios(figures, [r for r in runners if r.aircraft > 1])


def ratios(figures: dict[str, float], batches: list[Runner]) -> dict[str, float]:
    """The comparison, unless it is void."""
    ends = [flown(r, 1000) for r in batches]
    apart = max(float(np.abs((end - ends[-1]) / (1.0 + np.abs(ends[-1]))).max()) for end in ends)
    gain = figures["C++, batch"] / figures["C++, batch, scalar build"]
    found = {
        "batch": figures["FDES, batch"] / figures["C++, batch"],
        "one aircraft": figures["FDES, one aircraft"] / figures["C++, one aircraft"],
        "peer in lanes over peer scalar": gain,
        "trajectories apart": apart,
    }
    print(f"FDES / C++, batch                {found['batch']:9.2f}     demanded {AT_LEAST}")
    print(f"FDES / C++, one aircraft         {found['one aircraft']:9.2f}")
    print(f"C++ in lanes / C++ scalar        {gain:9.2f}     demanded {FAIR:g}, else the ratio is void")
    print(f"trajectories apart               {apart:9.1e}     allowed {SAME:g}")
    print(f"packed instructions of FDES: {packed_instructions()}")
    return found


def columns(values: tuple[Any, ...], aircraft: int) -> Array:
    """A named tuple, flattened, once per aircraft."""

    def flat(part: Any) -> list[float]:
        return [v for inner in part for v in flat(inner)] if isinstance(part, tuple) else [part]

    return np.repeat(np.array(flat(values))[:, None], aircraft, axis=1)


def flown(runner: Runner, steps: int) -> Array:
    """The final states after so many steps from the start."""
    x = columns(START, runner.aircraft)
    runner.advance(x, columns(HELD, runner.aircraft), columns(NAVION, runner.aircraft), steps)
    return x


def measure(runners: list[Runner], rounds: int) -> dict[str, float]:
    """Millions of aircraft-steps per second of processor time, the best of the interleaved rounds."""
    best: dict[str, float] = {}
    for r in runners:
        flown(r, 1)  # compiles
    for _ in range(rounds):
        for r in runners:
            x, held, numbers = columns(START, r.aircraft), columns(HELD, r.aircraft), columns(NAVION, r.aircraft)
            began = time.process_time()
            r.advance(x, held, numbers, r.steps)
            took = time.process_time() - began
            best[r.name] = max(best.get(r.name, 0.0), 1e-6 * r.aircraft * r.steps / took)
    return best


def ours(advance: Callable[..., None]) -> Solver:
    """The compiled solver."""
    return lambda x, held, numbers, steps: advance(x, held, numbers, STEP, steps)


def plain(x: Array, held: Array, numbers: Array, steps: int) -> None:
    """The same text as plain Python, for one aircraft."""
    y: tuple[float, ...] = tuple(x[:, 0].tolist())
    for _ in range(steps):
        y = step(lambda z: derivative(State(*z), HELD, NAVION), y, STEP, rk4)
    x[:, 0] = y


def peer(compiler: str, flags: str, target: Path) -> Solver:
    """The C++ solver, compiled now."""
    subprocess.run([compiler, *FLAGS.split(), *flags.split(), str(PEER), "-o", str(target)], check=True)
    return partial(call, ctypes.CDLL(str(target)).advance)


def call(advance: Any, x: Array, held: Array, numbers: Array, steps: int) -> None:
    """Hand the arrays over."""
    pointers = [a.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for a in (x, held, numbers)]
    advance(*pointers, ctypes.c_int64(x.shape[1]), ctypes.c_double(STEP), ctypes.c_int64(steps))


def packed_instructions() -> str:
    """How many arithmetic instructions of the batch's machine code take several numbers, and how many one."""
    cached: Any = batch(derivative, rk4).advance
    solver = numba.njit(error_model="numpy", fastmath=FLOATING)(cached.py_func)  # a cached one shows no instructions
    flown(Runner("", ours(solver), 8, 1), 1)
    text = "\n".join(solver.inspect_asm().values())
    operations = ("add", "sub", "mul", "div", "sqrt", "fmadd", "fnmadd", "fmsub")
    words = [word for line in text.splitlines() if (word := line.strip().partition("\t")[0]).startswith("v")]
    many = sum(any(o in w for o in operations) and w.endswith("pd") for w in words)
    one = sum(any(o in w for o in operations) and w.endswith("sd") for w in words)
    return f"{many} of {many + one}"


if __name__ == "__main__":
    main(sys.argv[1:])
