"""Published numbers as printed, one file per source, with where they stand and how closely they can be asserted.

They travel with the package so that every number FDES computes can be held against its source anywhere.
"""

import tomllib
from importlib.resources import files
from pathlib import Path
from typing import Any


def sources(folder: Path | None = None) -> dict[str, dict[str, Any]]:
    """All sources by file name: the content of each TOML file, of those that come with FDES or of another folder."""
    found = (f for f in (folder or files(__name__)).iterdir() if f.name.endswith(".toml"))
    return {
        f.name.removesuffix(".toml"): tomllib.loads(f.read_text("utf-8")) for f in sorted(found, key=lambda f: f.name)
    }
