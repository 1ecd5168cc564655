"""Some columns of a recording as JSON: what a page needs to draw it, and never more than a page can hold."""

from math import ceil
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fdes.errors import RecordingError, nearest
from fdes.flight import Recording

MAX_COLUMNS = 16
MAX_ROWS = 20_000


def chosen_columns(recording: Recording, asked: str) -> dict[str, Any]:
    """The columns of `recording` named in `asked` (comma between them; empty: none), in SI, beside its time `t` [s].

    Of more than MAX_ROWS rows every n-th is given, and `stride` is n. A value that is no finite number is None.
    Raises RecordingError for an unknown column, or for more than MAX_COLUMNS.
    """
    names = list(dict.fromkeys(name.strip() for name in asked.split(",") if name.strip()))
    if len(names) > MAX_COLUMNS:
        raise RecordingError(f"{len(names)} columns were asked for; at most {MAX_COLUMNS} come at once. Ask in parts.")
    index = {column.name: i for i, column in enumerate(recording.columns)}
    for name in names:
        if name not in index:
            near = nearest(name[:80], index)
            hint = f" Did you mean {near!r}?" if near else ""
            raise RecordingError(f"The recording has no column {name[:80]!r}.{hint}")
    stride = max(1, ceil(len(recording.data) / MAX_ROWS))
    rows = recording.data[::stride]
    time = recording.columns[0].name
    return {
        "columns": [
            {"name": c.name, "unit": c.unit, "long_name": c.long_name} for c in recording.columns if c.name != time
        ],
        "stride": stride,
        "t": _finite(rows[:, 0]),
        "values": {name: _finite(rows[:, index[name]]) for name in names},
    }


def _finite(values: NDArray[np.float64]) -> list[float | None]:
    if np.isfinite(values).all():
        return list(values.tolist())
    return [value if np.isfinite(value) else None for value in values.tolist()]
