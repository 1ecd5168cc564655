"""The text of what loops over aircraft: it is made for the fields of named tuples, for numba cannot loop over those."""

from collections.abc import Iterator
from typing import Any, get_type_hints

OCTET = 8  # slopes in a vector of `fdes.duals`


def solver_text(state: type, held: type, numbers: type, tableau: Any, lanes: int) -> str:
    """One block of `lanes` aircraft after the other, all of its numbers in one scratch array `w`, row by row.

    Rows are the state of a stage, what is held, the numbers, the state at the beginning of the step, and slopes.
    """
    counts = [len(list(leaves(t))) for t in (state, held, numbers)]
    n, m, p = counts
    first = n + m + p  # the row where the state at the beginning is
    places = iter([f"w[{row * lanes} + l]" for row in range(first)])
    arguments = ", ".join(_built(t, places) for t in (state, held, numbers))
    return "\n".join([
        "import numpy as np",
        "",
        "def slopes(w):",
        f"    d_dt = scratch({n * lanes})",  # which is no part of w or of a table: so nothing it reads is written to
        f"    for l in range({lanes}):",
        f"        d = derivative({arguments})",
        *[f"        d_dt[{i * lanes} + l] = d[{i}]" for i in range(n)],
        f"    for i in range({n * lanes}):",
        f"        w[{(first + n) * lanes} + i] = d_dt[i]",
        "",
        "def advance(x, held, numbers, h, steps):",
        f"    count, w = x.shape[1], np.empty({(first + n * (2 + len(tableau.b))) * lanes})",
        f"    for start in range(0, count, {lanes}):",
        *_copied_in("x", n, first, lanes),
        *_copied_in("held", m, n, lanes),
        *_copied_in("numbers", p, n + m, lanes),
        "        for _ in range(steps):",
        *[line for k in range(len(tableau.b)) for line in _stage(k, n, first, tableau, lanes)],
        *_combined(tableau.b, n, first, first, lanes),
        f"        for l in range(min({lanes}, count - start)):",
        *[f"            x[{i}, start + l] = w[{(first + i) * lanes} + l]" for i in range(n)],
        "",
    ])  # fmt: skip


def _copied_in(name: str, rows: int, to: int, lanes: int) -> list[str]:
    """A block that is not full repeats the last aircraft."""
    return [
        f"        for l in range({lanes}):",
        "            column = min(start + l, count - 1)",
        *[f"            w[{(to + i) * lanes} + l] = {name}[{i}, column]" for i in range(rows)],
    ]


def _stage(k: int, n: int, first: int, tableau: Any, lanes: int) -> list[str]:
    """The derivative is in a function of its own: it is compiled once, not for each stage."""
    return [
        *_combined(tableau.a[k], n, first, 0, lanes),
        "            slopes(w)",
        f"            for i in range({n * lanes}):",
        f"                w[{(first + n * (2 + k)) * lanes} + i] = w[{(first + n) * lanes} + i]",
    ]


def _combined(weights: tuple[float, ...], n: int, first: int, to: int, lanes: int) -> list[str]:
    """Row `to` becomes the state plus h times the weighted slopes."""
    used = [(j, a) for j, a in enumerate(weights) if a]
    span = n * lanes
    sum_ = " + ".join(f"{a!r} * w[{(first + n * (2 + j)) * lanes} + i]" for j, a in used)
    moved = f" + h * ({sum_})" if used else ""
    return [
        f"            for i in range({span}):",
        f"                w[{to * lanes} + i] = w[{first * lanes} + i]{moved}",
    ]


def jacobian_text(arguments: tuple[type, ...], results: int, octets: int) -> str:
    """One point after the other; the first two arguments are dual numbers, each with a direction of its own."""
    columns, places = 0, []
    for name, tuple_ in zip(("x", "held", "numbers"), arguments, strict=True):
        count = len(list(leaves(tuple_)))
        if name == "numbers":
            places += [f"numbers[k, {i}]" for i in range(count)]
            continue
        places += [f"seed({name}[k, {i}], {columns + i}, {octets})" for i in range(count)]
        columns += count
    each = iter(places)
    width = octets * OCTET
    return "\n".join([
        "def fill(x, held, numbers, results, slopes):",
        "    for k in range(x.shape[0]):",
        f"        d = derivative({', '.join(_built(t, each) for t in arguments)})",
        *[f"        results[k, {i}] = d[{i}].real" for i in range(results)],
        *[f"        store(slopes, (k * {results} + {i}) * {width}, d[{i}])" for i in range(results)],
        "",
    ])  # fmt: skip


def _built(tuple_: type, places: Iterator[str]) -> str:
    """The text that makes a named tuple of the numbers in those places."""
    parts = [
        _built(t, places) if isinstance(t, type) and hasattr(t, "_fields") else next(places)
        for t in get_type_hints(tuple_).values()
    ]
    return f"{tuple_.__name__}({', '.join(parts)})"


def leaves(tuple_: type, prefix: str = "") -> Iterator[str]:
    """The names of all floats in a named tuple and in the tuples within it."""
    for name, t in get_type_hints(tuple_).items():
        if isinstance(t, type) and hasattr(t, "_fields"):
            yield from leaves(t, f"{prefix}{name}.")
        else:
            yield prefix + name


def tuples_of(*found: type) -> dict[str, type]:
    """The named tuples and those within them, by name."""
    all_ = {t.__name__: t for t in found}
    for t in found:
        all_ |= tuples_of(*[i for i in get_type_hints(t).values() if isinstance(i, type) and hasattr(i, "_fields")])
    return all_
