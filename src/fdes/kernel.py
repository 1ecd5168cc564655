"""The one door to numba: the plain text of physics, compiled for one aircraft or for many, or differentiated.

Physics is written once, as scalar functions on named tuples, and runs as it stands. `compiled` makes the machine's
form of a function and of everything it calls; `batch` makes a solver that takes many aircraft through a derivative, in
lanes; `jacobian` makes the slopes of a derivative, by dual numbers. numba is imported when one of them is first asked
for, and never by `import fdes` or by the cockpit.

With ``FDES_COMPILED=0`` in the environment `compiled` gives back the plain function.

Compiled forms are kept on disk, under a hash of all sources of FDES and of numba's version: numba itself looks only at
the file that a function stands in, and would go on using physics that has been edited since.
"""

import dis
import hashlib
import importlib
import os
import sys
from collections.abc import Callable, Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path
from shutil import rmtree
from types import CodeType, FunctionType, ModuleType
from typing import Any, NamedTuple, TypeVar, get_type_hints

from fdes.errors import SpecError
from fdes.solver_text import OCTET, jacobian_text, leaves, solver_text, tuples_of

F = TypeVar("F", bound=Callable[..., Any])

# Not `reassoc`, which would change published digits, nor `nnan` and `ninf`, with which isnan() is always false.
FLOATING = {"contract", "arcp", "nsz"}
LANES = 8  # of a block: one AVX-512 register each, two of AVX2; 16 and 32 are 5 % slower on a 14-state model
NOTHING: Mapping[Any, Any] = {}
KEPT = 4  # folders of compiled forms: of this FDES, and of the last that was edited or installed beside it


def enabled() -> bool:
    """Whether FDES may compile."""
    return os.environ.get("FDES_COMPILED", "1") != "0"


def compiled(f: F) -> F:
    """`f` as machine code, for the types it is first called with; `f` itself where compiling is switched off."""
    machine: F = _outer(f) if enabled() else f
    return machine


class Batch(NamedTuple):
    """A compiled solver for many aircraft.

    advance(x, held, numbers, h, steps) takes the columns of `x`, one aircraft each, `steps` steps of length `h` [s]
    further in place. Rows are `states`, `inputs` and `parameters`, in that order; arrays are float64 and contiguous.
    """

    states: tuple[str, ...]
    inputs: tuple[str, ...]
    parameters: tuple[str, ...]
    advance: Callable[..., None]


def batch(
    derivative: Callable[[Any, Any, Any], Any],
    tableau: Any,
    lanes: int = LANES,
    instead: Mapping[Any, Any] = NOTHING,
) -> Batch:
    """A solver for `derivative(x, held, numbers) -> dx/dt`, its arguments named tuples of floats, or of such tuples.

    tableau: an explicit Runge-Kutta method. instead: functions to be compiled in the place of others, wherever those
    are called. Nothing loops over aircraft but the innermost loop, which the compiler turns into packed instructions.
    Raises SpecError where compiling is switched off.
    """
    state, held, numbers, _ = _signature(derivative, "A batch of aircraft needs")
    text = solver_text(state, held, numbers, tableau, lanes) + f"# of {_content(derivative, instead)}\n"
    machine = _machine_form(derivative, instead, inside=True)
    scratch = importlib.import_module("fdes.lanes").scratch
    solver: Any = module_of(text, {"derivative": machine, "scratch": scratch, **tuples_of(state, held, numbers)})
    solver.slopes = _njit(solver.slopes, cached=False)
    states, inputs, parameters = (tuple(leaves(t)) for t in (state, held, numbers))
    return Batch(states, inputs, parameters, _njit(solver.advance, nogil=True))


class Jacobian(NamedTuple):
    """A compiled function with its slopes.

    fill(x, held, numbers, results, slopes) takes points row by row: `states`, `inputs` and `parameters`, in that order.
    It writes the results, and their slopes by states and inputs: into rows of `width`, of which the first columns are
    those of states and inputs. All arrays are float64 and contiguous; `slopes` is flat.
    """

    states: tuple[str, ...]
    inputs: tuple[str, ...]
    parameters: tuple[str, ...]
    width: int
    fill: Callable[..., None]


def jacobian(derivative: Callable[[Any, Any, Any], Any], instead: Mapping[Any, Any] = NOTHING) -> Jacobian:
    """The slopes of `derivative(x, held, numbers)` by all of `x` and `held`; its result is a flat tuple of numbers.

    Arguments are as of `batch`. Raises SpecError where compiling is switched off.
    """
    state, held, numbers, result = _signature(derivative, "The slopes of a derivative need")
    states, inputs, parameters = (tuple(leaves(t)) for t in (state, held, numbers))
    octets = -(-(len(states) + len(inputs)) // OCTET)
    text = jacobian_text((state, held, numbers), len(list(leaves(result))), octets)
    text += f"# of {_content(derivative, instead)}\n"
    duals = importlib.import_module("fdes.duals")
    given = {"derivative": _machine_form(derivative, instead, inside=True, forms="fdes.duals")}
    given |= {"seed": duals.seed, "store": duals.store, **tuples_of(state, held, numbers)}
    solver = module_of(text, given)
    return Jacobian(states, inputs, parameters, octets * OCTET, _njit(solver.fill, nogil=True))


def _signature(derivative: Any, what: str) -> tuple[type, type, type, type]:
    """The named tuples that it takes, and the one it gives. Raises SpecError where compiling is switched off."""
    if not enabled():
        raise SpecError(f"{what} compiled code, and FDES_COMPILED=0 switches that off. Unset it.")
    state, held, numbers, result = get_type_hints(derivative).values()
    return state, held, numbers, result


def _machine_form(f: Any, instead: Mapping[Any, Any], *, inside: bool, forms: str = "fdes.lanes") -> Any:
    """numba's form of `f`, and of what it calls; `inside` another, it is inlined, so that lanes stay together.

    forms: the module whose functions stand in for the elementary ones.
    """
    globals_ = dict(f.__globals__)
    for name in _globals_of(f.__code__):
        value = globals_.get(name)
        if isinstance(value, FunctionType) or (callable(value) and _elementary(name, value)):
            form = instead.get(value, _form_of(name, value, forms))
            globals_[name] = _machine_form(form, instead, inside=True, forms=forms)
    twin = FunctionType(f.__code__, globals_, f.__name__, f.__defaults__, f.__closure__)
    twin.__module__, twin.__qualname__, twin.__kwdefaults__ = f.__module__, f.__qualname__, f.__kwdefaults__
    return _njit(twin, forceinline=inside, cached=not inside)


@cache
def _outer(f: Any) -> Any:
    return _machine_form(f, NOTHING, inside=False)


def _form_of(name: str, value: Any, forms: str) -> Any:
    """An elementary function compiles as its namesake in `forms`."""
    return getattr(importlib.import_module(forms), name) if _elementary(name, value) else value


def _elementary(name: str, value: Any) -> bool:
    return value is getattr(sys.modules.get("fdes.elementary"), name, None)


def _globals_of(code: CodeType) -> set[str]:
    """The names that a function looks up in its module; `co_names` has those of attributes too."""
    return {i.argval for i in dis.get_instructions(code) if i.opname == "LOAD_GLOBAL"}


def _content(f: Any, instead: Mapping[Any, Any]) -> str:
    """A hash of what is compiled: the code and the constants of `f`, and of all that it calls.

    Without it, numba's cache could not tell two aircraft apart whose tuples have the same fields.
    """
    digest, seen = hashlib.sha256(), set()

    def take(value: Any) -> None:
        if isinstance(value, FunctionType):
            value = instead.get(value, value)
            if id(value) not in seen:
                seen.add(id(value))
                take(value.__code__)
                for name in sorted(_globals_of(value.__code__)):
                    take(value.__globals__.get(name))
        elif isinstance(value, CodeType):
            digest.update(value.co_code + repr(value.co_names).encode())
            take(value.co_consts)
        elif isinstance(value, tuple):
            for part in value:
                take(part)
        else:
            digest.update(value.tobytes() if hasattr(value, "tobytes") else repr(value).encode())

    take(f)
    return digest.hexdigest()


def _njit(f: Any, *, cached: bool = True, **options: Any) -> Any:
    """`numba.njit`, with the disk cache in a folder that belongs to these sources.

    What is inlined is not cached: the same text calls other functions in the next aircraft, which numba would not see.
    """
    import numba
    from numba.core import config as _config

    config: Any = _config  # its settings are made when it is imported, where a type checker cannot see them
    machine = numba.njit(error_model="numpy", fastmath=FLOATING, **options)(f)
    if not cached:
        return machine
    before, config.CACHE_DIR = config.CACHE_DIR, str(_cache_folder())
    try:
        machine.enable_caching()
    finally:
        config.CACHE_DIR = before
    return machine


@cache
def _cache_folder() -> Path:
    """Where compiled forms of exactly these sources are kept."""
    import numba
    from platformdirs import user_cache_path

    digest = hashlib.sha256(f"{numba.__version__} {sys.version}".encode())
    for source in sorted(Path(str(files("fdes"))).rglob("*.py")):
        digest.update(source.read_bytes())
    folder = user_cache_path("fdes") / f"compiled-{digest.hexdigest()[:16]}"
    folder.mkdir(parents=True, exist_ok=True)
    others = sorted(folder.parent.glob("compiled-*"), key=lambda f: f.stat().st_mtime, reverse=True)
    for outdated in others[KEPT:]:
        rmtree(outdated, ignore_errors=True)
    return folder


def module_of(text: str, given: Mapping[str, Any]) -> ModuleType:
    """A module of that text and of names that are given to it, to be compiled.

    Its file is named for the text, which is what numba's cache goes by.
    """
    key = hashlib.sha256(text.encode()).hexdigest()[:16]
    path = _cache_folder() / f"solver_{key}.py"
    if not path.exists():
        unfinished = path.with_suffix(f".{os.getpid()}")
        unfinished.write_text(text, encoding="utf-8")
        unfinished.replace(path)
    name = f"fdes_solver_{key}"
    module = ModuleType(name)
    module.__dict__.update(given)
    sys.modules[name] = module  # numba looks a cached function's module up by name
    exec(compile(text, str(path), "exec"), module.__dict__)  # noqa: S102  text that was made above, of names of fields
    return module
