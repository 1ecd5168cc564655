"""What --plot writes, and where."""

import os
from pathlib import Path
from typing import TYPE_CHECKING

from fdes.errors import SpecError

if TYPE_CHECKING:
    from fdes.analysis.drawing import Drawing

FORMATS = (".png", ".svg", ".html")


def target_of(plot: str | None, formats: tuple[str, ...] = FORMATS) -> Path | None:
    """The file to write, if one is wanted. Raises SpecError for what cannot be written, before anything is computed."""
    if plot is None:
        return None
    path = Path(plot)
    if path.suffix.lower() not in formats:
        raise SpecError(f"{plot} cannot be written: let its name end in {', '.join(formats)}.")
    if path.is_dir():
        raise SpecError(f"{plot} cannot be written: it is a folder.")
    if not path.parent.is_dir():
        raise SpecError(f"{plot} cannot be written: there is no folder {path.parent}.")
    if not os.access(path if path.exists() else path.parent, os.W_OK):
        raise SpecError(f"{plot} cannot be written: no permission to write there.")
    return path


def save_plot(drawing: "Drawing", path: Path) -> None:
    """Draw into a file. Raises SpecError where the disk does not take it."""
    from fdes.analysis.drawing import save

    try:
        save(drawing, path)
    except OSError as trouble:
        raise SpecError(f"{path} cannot be written: {trouble.strerror or trouble}.") from trouble
