"""Measured time histories: numbers from a CSV file, flown as they are, and clear words where they cannot be."""

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from fdes.aircraft import load
from fdes.cli import app
from fdes.errors import NoSuchPart, SpecError
from fdes.flight import Clock, Excitation, simulate
from fdes.units import DEG, FOOT

ROWS = "t [s],elevator [deg],gust [ft/s],lever,raw\n10,0,0,0,1\n11,2,10,0.1,2\n13,-2,0,0,3\n"


@pytest.fixture
def run(tmp_path: Path) -> Path:
    path = tmp_path / "run 1.csv"
    path.write_text(ROWS, encoding="utf-8")
    return path


def read(text: str) -> Excitation:
    return Excitation.parse([text], files=True)


def test_straight_lines_between_rows_and_nothing_outside(run: Path) -> None:
    put = read(f"measured elevator {run} at 1s")
    found = [put(t).elevator / DEG for t in (0.999, 1.0, 1.5, 2.0, 3.0, 3.5, 4.0, 4.001)]
    assert found == pytest.approx([0.0, 0.0, 1.0, 2.0, 0.0, -1.0, -2.0, 0.0])


def test_a_column_of_another_name_on_any_channel(run: Path) -> None:
    assert read(f"measured gust_w {run} column gust").gusts(1.0).gust_w == pytest.approx(10.0 * FOOT)
    assert read(f"Measured throttle {run} COLUMN lever from 2s")(3.0).throttle == pytest.approx(0.1)


def test_a_flight_that_was_written_is_flown_again_from_its_own_columns(tmp_path: Path) -> None:
    path = tmp_path / "first.csv"
    fc = load("A-4D").at()
    clock = Clock(0.02, duration=10.0)
    first = simulate(fc, ["doublet elevator 2deg at 1s", "1-cosine-pulse gust_w -4m/s at 3s"], clock=clock)
    with path.open("w", encoding="utf-8") as file:
        first.to_csv(file, "us")
    again = [f"measured elevator {path} column excitation_elevator", f"measured gust_w {path} column air_gust_w"]
    second = simulate(fc, again, clock=clock)
    np.testing.assert_allclose(second.data, first.data, rtol=1e-9, atol=1e-9)


def test_on_the_command_line(run: Path) -> None:
    words = ["simulate", "A-4D", "-i", f"measured elevator {run}", "--duration", "5", "--dt", "0.5", "-o", "-"]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 0, result.output
    head, *rows = result.output.splitlines()
    column = head.split(",").index("excitation_elevator [rad]")
    peak = max(float(row.split(",")[column]) for row in rows[:11])
    assert peak == pytest.approx(2 * DEG)


@pytest.mark.parametrize(
    ("rows", "column", "words"),
    [
        (ROWS, "elevtor", "has no column 'elevtor'. Did you mean 'elevator'? It has: t, elevator, gust, lever, raw."),
        (ROWS, "raw", "The column 'raw' of {} does not say its unit. Write it into its header: raw [deg]."),
        (
            ROWS,
            "gust",
            "The column 'gust' of {} cannot be used. '1 ft/s' is in ft/s, which is not a unit of this quantity.",
        ),
        (
            "t,a [degs]\n0,1\n1,1\n",
            "a",
            "The column 'a' of {} cannot be used. Unknown unit 'degs'. Did you mean 'deg'?",
        ),
        ("time [s],a [deg]\n0,1\n1,1\n", "a", "{} has no column 't'."),
        ("t,a [deg]\n0,1\n0,1\n", "a", "must grow from row to row; row 2 goes from 0 s to 0 s. Sort the rows"),
        ("t,a [deg]\n1,1\n0.5,1\n", "a", "row 2 goes from 1 s to 0.5 s"),
        ("t,a [deg]\n0,1\n1,nan\n", "a", "Line 3 of {}: a is nan; only finite numbers can be flown."),
        ("t,a [deg]\n0,1\ninf,1\n", "a", "Line 3 of {}: t is inf; only finite numbers can be flown."),
        ("t,a [deg]\n0,1\n\n1,x\n", "a", "Line 4 of {}: a is 'x', not a number."),
        ("t,a [deg]\n0,1\n1\n", "a", "Line 3 of {}: a is empty, not a number."),
        ("t,a [deg]\n0,1\n", "a", "{}: A measured input needs at least two rows; there is 1."),
        ("t,a [deg]\n", "a", "{}: A measured input needs at least two rows; there are 0."),
        ("", "a", "{} is empty. Its first line should name the columns, such as 't [s],elevator [deg]'."),
    ],
)
def test_says_what_is_wrong_with_a_file(tmp_path: Path, rows: str, column: str, words: str) -> None:
    path = tmp_path / "run.csv"
    path.write_text(rows, encoding="utf-8")
    with pytest.raises(SpecError) as found:
        read(f"measured elevator {path} column {column}")
    assert words.format(path) in str(found.value)


def test_says_what_is_no_file_at_all(tmp_path: Path) -> None:
    with pytest.raises(SpecError, match=r"There is no file nowhere.csv. Name it from the folder you are in"):
        read("measured elevator nowhere.csv")
    with pytest.raises(SpecError, match=r"cannot be read: Is a directory\."):
        read(f"measured elevator {tmp_path}")
    (tmp_path / "noise.csv").write_bytes(b"t,a\xff\xfe\n")
    with pytest.raises(SpecError, match=r"noise.csv is not a CSV file: it is not text in UTF-8\. Save"):
        read(f"measured elevator {tmp_path / 'noise.csv'}")


@pytest.mark.parametrize("text", ["measured elevator", "measured elevator at 1s", "measured elevator run.csv column"])
def test_says_how_it_is_written(text: str) -> None:
    with pytest.raises(SpecError, match=r"is incomplete. Write it like"):
        read(text)
    with pytest.raises(NoSuchPart, match="Did you mean 'elevator'"):
        read("measured elevatr run.csv")


def test_a_text_names_no_file_unless_that_is_allowed(run: Path) -> None:
    """The network's texts are read without it: neither what a file holds nor whether there is one may come out."""
    refusals = set()
    for path in (run, run.with_name("none.csv"), Path("/etc/passwd")):
        with pytest.raises(SpecError, match="names a file, which is read on the command line and in Python only") as no:
            Excitation.parse([f"measured elevator {path}"])
        refusals.add(str(no.value).replace(str(path), ""))
    assert len(refusals) == 1
