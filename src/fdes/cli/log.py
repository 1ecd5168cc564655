"""The server's log: a rotating file in the data folder, and on stderr with --verbose."""

import logging
from collections.abc import Iterator
from contextlib import contextmanager
from logging.handlers import RotatingFileHandler
from pathlib import Path

from fdes.errors import SpecError

LARGEST, KEPT = 1_000_000, 3  # bytes of a file, and how many older ones stay
FORMAT = "%(asctime)s %(levelname)s %(name)s: %(message)s"


@contextmanager
def logged(folder: Path, *, verbose: bool) -> Iterator[None]:
    """While this lasts, log to ``fdes.log`` in `folder` from INFO on; with `verbose` also to stderr, from DEBUG on.

    Raises SpecError when the folder cannot be written to.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        to_file = RotatingFileHandler(folder / "fdes.log", maxBytes=LARGEST, backupCount=KEPT, encoding="utf-8")
    except OSError as trouble:
        why = trouble.strerror or trouble
        raise SpecError(f"The log cannot be kept in {folder}: {why}. Choose another folder with --data.") from trouble
    to_file.setLevel(logging.INFO)
    handlers: list[logging.Handler] = [to_file, *([logging.StreamHandler()] if verbose else [])]
    root = logging.getLogger()
    level = root.level
    root.setLevel(logging.DEBUG if verbose else logging.INFO)
    for handler in handlers:
        handler.setFormatter(logging.Formatter(FORMAT))
        root.addHandler(handler)
    try:
        yield
    finally:
        root.setLevel(level)
        for handler in handlers:
            root.removeHandler(handler)
            handler.close()
