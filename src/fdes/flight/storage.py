"""Where FDES keeps what it records: the platform's folder for user data, unless told otherwise."""

import os
from pathlib import Path

from platformdirs import user_data_path

from fdes.errors import SpecError


def data_folder(override: str | Path | None = None) -> Path:
    """The data folder: `override`, else the environment's FDES_DATA, else the platform's. Not created here."""
    chosen = override or os.environ.get("FDES_DATA")
    return Path(chosen).expanduser() if chosen else user_data_path("fdes", appauthor=False)


def recordings_folder(override: str | Path | None = None) -> Path:
    """The folder of recordings, made if need be. Raises SpecError when it cannot be written to."""
    folder = data_folder(override) / "recordings"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        writable = os.access(folder, os.W_OK)
    except OSError as trouble:
        raise SpecError(_cannot_write(folder, trouble.strerror or str(trouble))) from trouble
    if not writable:
        raise SpecError(_cannot_write(folder, "no permission"))
    return folder


def _cannot_write(folder: Path, why: str) -> str:
    return f"Recordings cannot be kept in {folder}: {why}. Choose another folder with --data, or set FDES_DATA."
