"""An aircraft that is being written in the page's form: what is wrong with it so far, and its file once it can fly.

A draft is the content of an aircraft file as JSON, with gaps where nothing was entered yet. It is data and nothing
else: no name in it is looked for as a file or as code, and nothing of it is kept.
"""

import json
import re
from dataclasses import asdict
from typing import Any

from pydantic import ValidationError

from fdes.aircraft import Aircraft, check, parse
from fdes.aircraft.explain import by_place
from fdes.aircraft.load import aircraft_of
from fdes.aircraft.role import CATEGORIES, CLASSES, PHASES
from fdes.aircraft.schema import UNLESS_SAID, AircraftFile, Assumed, Derivatives
from fdes.errors import AircraftFileError, FdesError, SpecError
from fdes.physics.atmosphere import standard_atmosphere
from fdes.units import to_si, units_of

LARGEST = 60_000  # bytes, as of a file that is opened in the page
MOST = 64  # errors that are answered
QUANTITIES = ("1/rad", "rad", "m", "m^2", "kg", "kg m^2", "m/s", "kg/m^3", "m/s^2", "N")
NEEDED = {
    "mass": ("Ix", "Iy", "Iz"),
    "assumed": tuple(name for name in Assumed.model_fields if name not in {"drag", "engine_lag", *UNLESS_SAID}),
}
SAYS = ("printed", "corrected", "value", "unit", "reason")  # parts of one number, which is one field of the form


def choices(fleet: dict[str, Aircraft]) -> dict[str, Any]:
    """What the form offers: the units of each quantity, with what makes SI of them, and where to start from."""
    started = [
        {"aircraft": a.id, "name": a.name, "condition": c["id"], "condition_name": c["name"]}
        for a in fleet.values()
        for c in a.document["conditions"]
        if "derivatives" in c
    ]
    return {
        "units": {si: {unit: to_si(1.0, unit) for unit in units_of(si)} for si in QUANTITIES},
        "start_from": started,
        "roles": {"classes": CLASSES, "categories": CATEGORIES, "phases": PHASES},
    }


def reviewed(body: bytes) -> dict[str, Any]:
    """What is wrong with the draft in `body`, by field; what the linter finds; and the text of its file, or None.

    Raises SpecError for what is no draft at all.
    """
    content = _content(body)
    errors = _errors(content)
    if errors:
        return {"errors": errors, "findings": [], "file": None}
    try:
        aircraft = parse(content, "The aircraft")
        found = [f for f in check(aircraft) if f.waived is None]
    except AircraftFileError as wrong:
        reason = str(wrong).split("\n", 1)[-1].strip()
        return {"errors": [_error("", reason, _fields_in(reason))], "findings": [], "file": None}
    import tomli_w

    findings = [{**asdict(f), "fields": _fields_in(f.what)} for f in found]
    return {"errors": [], "findings": findings, "file": {"name": _file_name(content), "text": tomli_w.dumps(content)}}


def content_of(body: bytes) -> dict[str, Any]:
    """The content of an aircraft file that comes as TOML. Raises FdesError for what is none."""
    try:
        text = body.decode()
    except UnicodeDecodeError:
        raise SpecError("The aircraft cannot be read: it is not text in UTF-8.") from None
    return dict(aircraft_of(text, "The aircraft").document)


def _content(body: bytes) -> dict[str, Any]:
    if len(body) > LARGEST:
        raise SpecError(f"The aircraft has {len(body)} bytes; the largest that can be checked has {LARGEST}.")
    try:
        content = json.loads(body)
    except (ValueError, RecursionError):
        raise SpecError("The aircraft cannot be read: it is not JSON.") from None
    if not isinstance(content, dict):
        raise SpecError("The aircraft cannot be read: it is not a JSON object such as an aircraft file holds.")
    return content


def _errors(content: dict[str, Any]) -> list[dict[str, Any]]:
    """Mistakes and gaps, each with the place of its field, such as ``conditions.0.derivatives.Cl_p``."""
    _fill_in_mach(content)
    found: dict[str, str] = {}
    try:
        AircraftFile.model_validate(content)
    except (ValidationError, RecursionError) as wrong:
        if isinstance(wrong, RecursionError):
            raise SpecError("The aircraft cannot be read: its tables are nested too deeply.") from None
        for loc, sentence in by_place(wrong):
            parts = [str(key) for key in loc if key not in SAYS]
            found.setdefault(".".join(parts), sentence)
    for block, names in NEEDED.items():
        given = [part.get(block) for part in (content, *_conditions(content))]
        tables = [table for table in given if isinstance(table, dict)]
        for name in names if tables else ():
            if all(table.get(name) is None for table in tables):
                found.setdefault(f"{block}.{name}", "is missing.")
    if len(found) > 1:
        found.pop("", None)  # what a gap makes of the whole is said by the gap
    return [
        _error(place, sentence, _fields_in(sentence) if not place else [])
        for place, sentence in list(found.items())[:MOST]
    ]


def _fill_in_mach(content: dict[str, Any]) -> None:
    """The Mach number of a condition that gives its speed alone, from the standard atmosphere."""
    for condition in _conditions(content):
        if condition.get("mach") is not None:
            continue
        try:
            speed, altitude = (
                to_si(float(condition[name]["printed"]), str(condition[name]["unit"])) for name in ("speed", "altitude")
            )
            condition["mach"] = speed / standard_atmosphere(altitude).a
        except (FdesError, KeyError, TypeError, ValueError):
            continue  # the field that is wrong is reported


def _conditions(content: dict[str, Any]) -> list[dict[str, Any]]:
    given = content.get("conditions")
    return [c for c in given if isinstance(c, dict)] if isinstance(given, list) else []


def _error(place: str, sentence: str, fields: list[str]) -> dict[str, Any]:
    return {"field": place, "what": sentence, "fields": fields or [place]}


_NAMES = {
    **{name: f"geometry.{name}" for name in ("S", "b", "c")},
    **{name: f"mass.{name}" for name in ("W", "cg", "Ix", "Iy", "Iz", "Ixz")},
    **{name: f"conditions.0.{name}" for name in ("mach", "altitude", "speed", "trim_alpha")},
    **{name: f"conditions.0.derivatives.{name}" for name in Derivatives.model_fields},
    **{name: f"assumed.{name}" for name in Assumed.model_fields},
}


def _fields_in(sentence: str) -> list[str]:
    """The fields that a sentence speaks of."""
    return list(dict.fromkeys(_NAMES[word] for word in re.findall(r"\w+", sentence) if word in _NAMES))


def _file_name(content: dict[str, Any]) -> str:
    return f"{re.sub(r'[^A-Za-z0-9_-]+', '-', content['id']).strip('-') or 'aircraft'}.toml"
