"""The flight recorder: what goes in comes out, and a crash costs the tail alone."""

import io
import json
import math
from pathlib import Path

import numpy as np
import pytest
import xarray
from scipy.io import loadmat

from fdes.aircraft import load
from fdes.control import Stick
from fdes.control.laws.direct import Direct
from fdes.errors import RecordingError
from fdes.flight import Clock, Edit, Frame, Recorder, Setup, SteadyAir, fly, list_recordings, open_recording, plant_of
from fdes.flight.recorder import MAGIC, chunk, row_of
from fdes.physics.small_perturbation import PerturbationState

HEADER = {"aircraft": "A-4D", "condition": "M0.4_SL", "dt": 0.01}


def flight() -> list[Frame]:
    condition = load("A-4D").at("M0.4_SL")
    plant = plant_of(condition)

    def pilot(t: float) -> Stick:
        return Stick(math.sin(3.0 * t), math.cos(t), 0.0, 0.3)

    def reset(t: float) -> Edit | None:
        return Edit(state=plant.start(), note={"reset": True}) if t == 1.0 else None

    setup = Setup(plant, Direct(condition.full_stick))
    return list(fly(plant.start(), setup, pilot, SteadyAir(), Clock(0.01, 1, 2.0), edits=reset))


@pytest.fixture
def recorded(tmp_path: Path) -> tuple[Path, list[Frame]]:
    path, frames = tmp_path / "one.fdes", flight()
    recorder = Recorder(path, PerturbationState, HEADER)
    for frame in frames:
        recorder.append(frame)
    recorder.close()
    return path, frames


def test_what_goes_in_comes_out_to_the_last_bit(recorded: tuple[Path, list[Frame]]) -> None:
    path, frames = recorded
    recording = open_recording(path)
    assert recording.complete
    assert recording.header["aircraft"] == "A-4D"
    assert recording.edits == ({"t": 1.0, "reset": True},)
    assert [tuple(row) for row in recording.data] == [row_of(f) for f in frames]
    assert list(recording["state_phi"]) == [f.state.phi for f in frames]


def test_a_tail_cut_off_anywhere_costs_the_tail_alone(recorded: tuple[Path, list[Frame]], tmp_path: Path) -> None:
    path, frames = recorded
    whole = path.read_bytes()
    rows = [row_of(f) for f in frames]
    header_ends = whole.index(b"ROWS")
    for cut in range(header_ends, len(whole), 997):
        stump = tmp_path / "stump.fdes"
        stump.write_bytes(whole[:cut])
        found = open_recording(stump)
        assert not found.complete
        assert [tuple(row) for row in found.data] == rows[: len(found.data)]


def test_a_flipped_bit_ends_the_reading(recorded: tuple[Path, list[Frame]]) -> None:
    path, frames = recorded
    damaged = bytearray(path.read_bytes())
    damaged[-2000] ^= 1
    path.write_bytes(damaged)
    found = open_recording(path)
    assert not found.complete
    assert len(found.data) < len(frames)


def test_csv_has_units_in_its_header_and_all_digits(recorded: tuple[Path, list[Frame]]) -> None:
    path, frames = recorded
    text = io.StringIO()
    open_recording(path).to_csv(text)
    first, *lines = text.getvalue().splitlines()
    names = first.split(",")
    assert names[:3] == ["t [s]", "V [m/s]", "mach [1]"]
    assert "q [rad/s]" in names
    values = np.array([[float(v) for v in line.split(",")] for line in lines])
    np.testing.assert_allclose(values, [row_of(f) for f in frames], rtol=1e-14)


def test_csv_in_us_units(recorded: tuple[Path, list[Frame]]) -> None:
    path, frames = recorded
    text = io.StringIO()
    open_recording(path).to_csv(text, units="us")
    first, second = text.getvalue().splitlines()[:2]
    row = dict(zip(first.split(","), map(float, second.split(",")), strict=True))
    assert row["V [ft/s]"] == pytest.approx(frames[0].outputs.V / 0.3048)
    assert row["theta [deg]"] == pytest.approx(math.degrees(frames[0].outputs.theta))
    assert row["mach [1]"] == pytest.approx(0.4)


def test_dataset_is_labelled(recorded: tuple[Path, list[Frame]]) -> None:
    path, frames = recorded
    data = open_recording(path).to_dataset()
    assert data["q"].attrs == {"units": "rad/s", "long_name": "pitch rate"}
    assert float(data["h"].sel(t=1.0)) == frames[100].outputs.h
    assert data.attrs["aircraft"] == "A-4D"


def test_listing_passes_over_what_is_no_recording(recorded: tuple[Path, list[Frame]]) -> None:
    path, _ = recorded
    (path.parent / "noise.fdes").write_bytes(b"nothing of ours")
    (found,) = list_recordings(path.parent)
    assert (found.name, found.seconds) == ("one", pytest.approx(2.0))


def test_never_overwrites(recorded: tuple[Path, list[Frame]]) -> None:
    path, _ = recorded
    with pytest.raises(FileExistsError):
        Recorder(path, PerturbationState, HEADER)


def test_says_why_a_file_cannot_be_read(recorded: tuple[Path, list[Frame]], tmp_path: Path) -> None:
    path, _ = recorded
    (tmp_path / "x.fdes").write_bytes(b"PK\x03\x04 something else")
    with pytest.raises(RecordingError, match=r"x\.fdes is not an FDES recording"):
        open_recording(tmp_path / "x.fdes")
    with pytest.raises(RecordingError, match="cannot be read: No such file"):
        open_recording(tmp_path / "none.fdes")
    whole = path.read_bytes()
    header = json.loads(whole[whole.index(b'{"format"') : whole.index(b"ROWS")])
    later = json.dumps(header | {"format": 99, "fdes": "9.0"}).encode()
    (tmp_path / "new.fdes").write_bytes(MAGIC + chunk(b"HEAD", later))
    with pytest.raises(RecordingError, match=r"has format 99 and was written by FDES 9\.0; this FDES reads format 1"):
        open_recording(tmp_path / "new.fdes")


def test_netcdf_and_mat_hold_the_same_numbers(recorded: tuple[Path, list[Frame]], tmp_path: Path) -> None:
    path, frames = recorded
    recording = open_recording(path)
    recording.to_netcdf(tmp_path / "one.nc")
    recording.to_mat(tmp_path / "one.mat")
    pitch_rate = [f.outputs.q for f in frames]
    with xarray.open_dataset(tmp_path / "one.nc", engine="scipy") as data:
        assert list(data["q"].values) == pitch_rate
        assert data["q"].attrs["units"] == "rad/s"
        assert data.attrs["aircraft"] == "A-4D"
    mat = loadmat(tmp_path / "one.mat")
    assert list(mat["q"][:, 0]) == pitch_rate
    assert mat["units"]["q"][0, 0][0] == "rad/s"
