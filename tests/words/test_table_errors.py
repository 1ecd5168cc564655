"""What a reader is told when the tables of an aircraft file do not fit together."""

import copy
from collections.abc import Callable
from typing import Any

import pytest

from fdes.aircraft import load, parse
from fdes.errors import AircraftFileError

F16 = load("F-16").document
Document = dict[str, Any]


def _set(*path: str | int, to: Any) -> Callable[[Document], None]:
    def change(document: Document) -> None:
        part: Any = document
        for key in path[:-1]:
            part = part[key]
        part[path[-1]] = to

    return change


MISTAKES = [
    pytest.param(
        _set("terms", "axes", "beta", "breakpoints", to=[-30, -20, -20, 0]),
        "must rise from breakpoint to breakpoint, and -20 follows -20",
        id="breakpoints that do not rise",
    ),
    pytest.param(
        _set("terms", "axes", "beta", "breakpoints", to=[0]), "needs two breakpoints at least, and has 1", id="too few"
    ),
    pytest.param(
        _set("terms", "axes", "alpha", "signal", to="alfa"), "'alfa' is no signal. Did you mean 'alpha'?", id="signal"
    ),
    pytest.param(
        _set("terms", "axes", "alpha", "unit", to="ft"),
        "is in 'ft', but alpha is in 'rad', or what converts to it",
        id="unit of another kind",
    ),
    pytest.param(
        _set("terms", "axes", "half_beta", "breakpoints", to=[5, 10, 15, 20, 25, 30, 35]),
        "is mirrored, and so must begin at 0, not at 5",
        id="mirrored",
    ),
    pytest.param(
        _set("terms", "tables", "CZ_0", "values", to=[1, 2, 3]),
        "table 'CZ_0' needs 12 values for its axes, and has 1 rows of 3",
        id="size of a row",
    ),
    pytest.param(
        _set("terms", "tables", "Cm_0", "values", to=[[0] * 12] * 4),
        "table 'Cm_0' needs 5 x 12 values for its axes, and has 4 rows of 12",
        id="size of a grid",
    ),
    pytest.param(
        _set("terms", "tables", "Cm_0", "axes", to=["elevater", "alpha"]),
        "table 'Cm_0': 'elevater' is no axis of [terms.axes]. Did you mean 'elevator'?",
        id="axis",
    ),
    pytest.param(
        _set("terms", "sums", "Cm", to=[{"table": "Cm_0"}, {"table": "CMq", "times": ["q_hat"]}]),
        "sum Cm: 'CMq' is no table of [terms.tables]. Did you mean 'Cm_q'?",
        id="table",
    ),
    pytest.param(
        _set("terms", "sums", "Cm", to=[{"table": "Cm_0"}, {"table": "Cm_q", "times": ["qhat"]}]),
        "sum Cm: 'qhat' is no signal. Did you mean 'q_hat'?",
        id="signal in a sum",
    ),
    pytest.param(
        _set("terms", "sums", "Cm", to=[{"table": "Cm_0"}]),
        "table 'Cm_q' is used in no sum: use it, or leave it out",
        id="idle table",
    ),
    pytest.param(
        _set("terms", "signals", "del", "per", to="25 ft"), "25 ft", id="unit of another kind in a signal of the source"
    ),
    pytest.param(_set("terms", "signals", "del", "per", to="0 deg"), "is per 0", id="per nothing"),
    pytest.param(
        _set("terms", "signals", "beta", to={"signal": "beta"}), "'beta' is a signal of FDES already", id="a name twice"
    ),
    pytest.param(_set("terms", "source", to="F16_AER"), "source 'F16_AER' is cited, but not listed", id="source"),
    pytest.param(
        _set("turbofan", "idle", to=[[0] * 6] * 5),
        "idle needs a row of 6 thrusts for each of 6 Mach numbers, and has 5 rows of 6",
        id="size of a thrust table",
    ),
    pytest.param(
        _set("turbofan", "units", to={"height": "ft", "thrust": "lb"}), "has a thrust in 'lb', which is none", id="lb"
    ),
    pytest.param(_set("turbofan", "throttle", to=[0, 0.5, 0.9]), "needs a throttle from 0 to 1", id="throttle"),
    pytest.param(_set("turbofan", "lag", "near", to=60), "near must be the smaller one", id="lag"),
    pytest.param(lambda d: d["mass"].pop("cg"), "mass.cg is missing, and condition 'M0.53_10kft' needs it", id="cg"),
]


@pytest.mark.parametrize(("change", "said"), MISTAKES)
def test_what_is_said(change: Callable[[Document], None], said: str) -> None:
    document = copy.deepcopy(dict(F16))
    change(document)
    with pytest.raises(AircraftFileError) as error:
        parse(document, "mine.toml")
    assert said in str(error.value)
