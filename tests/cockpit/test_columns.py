"""Columns of a recording as JSON: what is asked for, bounded, and refused in words."""

from math import nan

import numpy as np
import pytest

from fdes.cockpit.columns import MAX_COLUMNS, MAX_ROWS, chosen_columns
from fdes.errors import RecordingError
from fdes.flight import Recording
from fdes.physics.signals import Channel


def recording(rows: int) -> Recording:
    names = ["t", "theta", *(f"x{i}" for i in range(MAX_COLUMNS + 1))]
    columns = tuple(Channel(name=name, unit="s" if name == "t" else "rad", long_name=name) for name in names)
    data = np.tile(np.arange(rows, dtype=np.float64)[:, None], (1, len(names)))
    return Recording({}, columns, data, (), True)


def test_the_columns_asked_for_come_once_each_beside_time() -> None:
    given = chosen_columns(recording(3), "theta, theta,")
    assert given["t"] == [0.0, 1.0, 2.0]
    assert given["values"] == {"theta": [0.0, 1.0, 2.0]}
    assert given["stride"] == 1
    assert given["columns"][0] == {"name": "theta", "unit": "rad", "long_name": "theta"}


@pytest.mark.parametrize(("rows", "stride"), [(MAX_ROWS, 1), (MAX_ROWS + 1, 2), (5 * MAX_ROWS, 5)])
def test_a_long_flight_is_thinned_and_says_so(rows: int, stride: int) -> None:
    given = chosen_columns(recording(rows), "theta")
    assert given["stride"] == stride
    assert len(given["t"]) <= MAX_ROWS
    assert given["values"]["theta"][1] == given["t"][1] == stride


def test_what_is_no_number_is_null_and_no_rows_are_no_rows() -> None:
    flight = recording(2)
    flight.data[1, 1] = nan
    assert chosen_columns(flight, "theta")["values"]["theta"] == [0.0, None]
    assert chosen_columns(recording(0), "theta")["t"] == []


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ("thetta", r"no column 'thetta'. Did you mean 'theta'\?"),
        ("../../secret", "no column '../../secret'"),
        ("\x00" * 3000, "no column"),
        (",".join(f"x{i}" for i in range(MAX_COLUMNS + 1)), f"{MAX_COLUMNS + 1} columns were asked for; at most"),
    ],
)
def test_rubbish_is_refused_in_words(asked: str, words: str) -> None:
    with pytest.raises(RecordingError, match=words) as refused:
        chosen_columns(recording(2), asked)
    assert len(str(refused.value)) < 500
