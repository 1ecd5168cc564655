"""A law of one's own: one Python file, named by its path.

Reading such a file runs it. So only the command line and Python programs come here; recordings, links and the network
name laws of the shelf, by `fdes.control.spoken`, which knows no paths. A test holds the two apart.
"""

import importlib.util
from dataclasses import is_dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from fdes.errors import SpecError

if TYPE_CHECKING:
    from collections.abc import Sequence

OFFERS = ("start", "step", "linear")


def is_path(name: str) -> bool:
    """Whether a law is named by the path of a file."""
    return name.endswith(".py") or "/" in name or "\\" in name


def law_from_file(path: Path) -> Any:
    """The law in a Python file: the one name in its ``__all__``, a frozen dataclass as those of the shelf are.

    Raises SpecError for a file that is not there, fails, or holds no law.
    """
    path = path.expanduser()
    if not path.is_file():
        raise SpecError(f"There is no law in {path}: it is no file.")
    spec = importlib.util.spec_from_file_location(path.stem, path)
    if spec is None or spec.loader is None:
        raise SpecError(f"The law in {path} cannot be read: let its name end in .py.")
    module = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except Exception as trouble:
        raise SpecError(f"The law in {path} cannot be read: {type(trouble).__name__}: {trouble}.") from trouble
    names: Sequence[str] = getattr(module, "__all__", ())
    if len(names) != 1:
        raise SpecError(f'{path} must name its law in __all__ = ["TheLaw"]; it names {len(names)}.')
    part = getattr(module, names[0], None)
    missing = [name for name in OFFERS if not callable(getattr(part, name, None))]
    if not is_dataclass(part) or missing:
        what = f"it lacks {', '.join(missing)}" if missing else "it is no dataclass"
        raise SpecError(
            f"{names[0]} in {path} is not a law: {what}. A law is a frozen dataclass with start, step, linear."
        )
    return part


def own_laws(text: str) -> tuple[str, dict[str, Any]]:
    """`text` with every path of a law replaced by the name of its file, and those laws by that name. Raises SpecError.

    "./mine.py gain=0.2; yaw_damper" becomes "mine gain=0.2; yaw_damper".
    """
    said, own = [], {}
    for loop in text.split(";"):
        path, _, settings = loop.strip().partition(" ")
        if is_path(path):
            own[Path(path).stem] = law_from_file(Path(path))
            path = Path(path).stem
        said.append(f"{path} {settings}".strip())
    return "; ".join(said), own
