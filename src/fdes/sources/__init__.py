"""Published numbers as printed, one file per source, with where they stand and how closely they can be asserted.

They travel with the package so that every number FDES computes can be held against its source anywhere. What is known
to be misprinted in them is recorded apart, with the evidence: see `misprints`.
"""

import tomllib
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

MISPRINTS = "misprints.toml"


def sources(folder: Path | None = None) -> dict[str, dict[str, Any]]:
    """All sources by file name: the content of each TOML file, of those that come with FDES or of another folder."""
    inside = (folder or files(__name__)).iterdir()
    found = sorted((f for f in inside if f.name.endswith(".toml") and f.name != MISPRINTS), key=lambda f: f.name)
    return {f.name.removesuffix(".toml"): tomllib.loads(f.read_text("utf-8")) for f in found}


@cache
def misprints() -> dict[str, dict[str, Any]]:
    """The accepted misprints by name: which number, as printed and as it should be, and the independent evidence.

    Both numbers have the signs of docs/symbols.md. A misprint excuses no check that fails for another reason.
    """
    return tomllib.loads((files(__name__) / MISPRINTS).read_text("utf-8"))
