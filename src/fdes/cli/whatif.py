"""`fdes whatif`: a recording's own stick flown again, as it was or with something changed."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fdes.cli.options import AsJson
from fdes.cli.output import note, number, print_json, screen, table, track
from fdes.errors import NoSuchPart, SpecError
from fdes.units import UNIT_SYSTEMS

if TYPE_CHECKING:
    from fdes.flight import Recording
    from fdes.flight.reflight import Reflight

SHOWN = ("V", "alpha", "beta", "gamma", "phi", "theta", "psi", "p", "q", "r", "n_y", "n_z", "h")


def whatif(
    recording: Annotated[
        str, typer.Argument(metavar="RECORDING", help="A file, or the name of a recording in the data folder.")
    ],
    variations: Annotated[
        list[str] | None,
        typer.Option(
            "--try",
            metavar="TEXT",
            help="What is different: 'Cm_q*=0.5', 'law=yaw_damper', 'integrator=euler', 'plant=nonlinear', "
            "'aircraft=NAVION'; several things with semicolons. Repeatable. Without it the recording is flown again as "
            "it was.",
        ),
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", "-o", metavar="FOLDER", help="Keep what was flown there, as recordings.")
    ] = None,
    plot: Annotated[
        str | None, typer.Option("--plot", metavar="FILE", help="All flights, overlaid: .png, .svg or .html.")
    ] = None,
    units: Annotated[str, typer.Option(metavar="si|us", help="SI and radians, or feet and degrees.")] = "si",
    data: Annotated[
        Path | None, typer.Option(metavar="FOLDER", help="Where recordings are kept; else FDES_DATA, or the platform.")
    ] = None,
    json: AsJson = False,
) -> None:
    """Fly a recording's stick again, unchanged or on a changed aircraft, and show what is different.

    Unchanged, on the engine and machine of the recording, it comes out bit for bit as it was.
    """
    from fdes.analysis.what_if import Variation, what_if
    from fdes.cli.plot import save_plot, target_of
    from fdes.flight import open_recording

    if units not in UNIT_SYSTEMS:
        raise NoSuchPart("system of units", units, UNIT_SYSTEMS)
    if out is not None and not out.is_dir():
        raise SpecError(f"{out} is no folder. Make it first, or name another.")
    target = target_of(plot)
    path = _path(recording, data)
    recorded = open_recording(path)
    asked = [Variation.parse(text) for text in variations or [""]]
    flown = [(v.text or "flown again", what_if(recorded, v)) for v in track(asked, "Flying again")]
    if target is not None:
        from fdes.analysis.plots import overlay

        overlaid = [("recording", recorded), *((label, again.recording) for label, again in flown)]
        save_plot(overlay(overlaid, path.stem, units), target)
    kept = [_keep(again.recording, out, path.stem, k) for k, (_, again) in enumerate(flown)] if out else []
    if json:
        print_json({"recording": path.stem, "variations": [_as_json(recorded, *one) for one in flown]})
        return
    for label, again in flown:
        _show(recorded, label, again, units)
    for file in kept:
        screen().print(f"{file} is written.", soft_wrap=True)
    if target is not None:
        screen().print(f"{plot} is written.", soft_wrap=True)
    _note_engine(recorded, flown[0][1].recording)


def _path(recording: str, data: Path | None) -> Path:
    """The file of a recording: itself, or the one of that name in the data folder. Raises SpecError, NoSuchPart."""
    from fdes.flight import list_recordings
    from fdes.flight.recorder import SUFFIX
    from fdes.flight.storage import data_folder

    if Path(recording).exists() or recording.endswith(SUFFIX):
        return Path(recording)
    kept = {one.name: one.path for one in list_recordings(data_folder(data) / "recordings")}
    if recording not in kept:
        if not kept:
            raise SpecError(f"There is no recording {recording}, and none at all in {data_folder(data)}.")
        raise NoSuchPart("recording", recording, kept)
    return kept[recording]


def _keep(flown: "Recording", folder: Path, stem: str, number_of: int) -> Path:
    """Write a flight to a name that is free. Raises SpecError."""
    from fdes.flight.recorder import SUFFIX

    path = folder / f"{stem}_what_if_{number_of + 1}{SUFFIX}"
    try:
        flown.save(path)
    except FileExistsError:
        raise SpecError(f"{path} is there already. Move it away, or name another folder.") from None
    except OSError as trouble:
        raise SpecError(f"{path} cannot be written: {trouble.strerror or trouble}.") from trouble
    return path


def _show(recorded: "Recording", label: str, again: "Reflight", units: str) -> None:
    """The table of differences of one flight, or that there are none."""
    from fdes.flight.reflight import differences

    found = list(differences(recorded, again.recording))
    frames = len(again.recording.data)
    if not found and frames == len(recorded.data):
        screen().print(f"{label}: {frames} frames, bit for bit as they were recorded.")
    else:
        drawn = table("signal", "unit", "greatest difference", "after [s]", "rms", title=label)
        drawn.columns[1].justify = "left"
        for name, si, apart, t, rms in found:
            unit, factor = UNIT_SYSTEMS[units].get(si, (si, 1.0))
            if name in SHOWN:
                drawn.add_row(name, unit, number(apart * factor), f"{t:.2f}", number(rms * factor))
        screen().print(drawn)
    if again.departed:
        note(f"{label}: {again.departed}")


def _as_json(recorded: "Recording", label: str, again: "Reflight") -> dict[str, object]:
    from fdes.flight.reflight import differences

    return {
        "variation": label,
        "frames": len(again.recording.data),
        "departed": again.departed,
        "differences": {
            name: {"unit": unit, "greatest": apart, "t": t, "rms": rms}
            for name, unit, apart, t, rms in differences(recorded, again.recording)
        },
    }


def _note_engine(recorded: "Recording", again: "Recording") -> None:
    """Say when the recording was computed elsewhere."""
    then, now = (f"FDES {r.header.get('fdes', '?')} ({r.header.get('engine', 'unknown')})" for r in (recorded, again))
    if then != now:
        note(f"It was recorded by {then} and flown again by {now}: the two agree to rounding, not bit for bit.")
