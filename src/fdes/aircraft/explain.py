"""What is wrong with an aircraft file, in sentences: never a dump of the validator."""

from typing import Any, get_args

from pydantic import BaseModel, ValidationError

from fdes.aircraft.schema import AircraftFile
from fdes.errors import nearest

SHOWN = 5


def explain(error: ValidationError, document: dict[str, Any]) -> str:
    """The mistakes that validation found in `document`, one line each, the first few of them."""
    lines = [f"  {_place(e['loc'], document)}{_sentence(dict(e))}" for e in error.errors()]
    more = [f"  ... and {len(lines) - SHOWN} more."] if len(lines) > SHOWN else []
    return "\n".join([*lines[:SHOWN], *more])


def _place(loc: tuple[int | str, ...], document: Any) -> str:
    """Where in the file: ``condition M0.4_SL, derivatives, Cl_p: ``. A condition goes by its id."""
    words: list[str] = []
    for key in loc:
        document = _inner(document, key)
        if isinstance(key, int) and words and words[-1] == "conditions":
            words[-1] = f"condition {_inner(document, 'id') or key + 1}"
        else:
            words.append(str(key))
    return f"{', '.join(words)}: " if words else ""


def _inner(document: Any, key: int | str) -> Any:
    if isinstance(document, dict):
        return document.get(key)
    return document[key] if isinstance(document, list) and isinstance(key, int) and key < len(document) else None


def _sentence(error: dict[str, Any]) -> str:
    given = error["input"]
    match error["type"]:
        case "extra_forbidden":
            known = _known_keys(error["loc"][:-1])
            near = nearest(str(error["loc"][-1]), known)
            return "unknown key. " + (f"Did you mean {near!r}?" if near else f"Known here: {', '.join(known)}.")
        case "missing":
            return "is missing."
        case "value_error":
            return f"{error['ctx']['error']}."
        case "finite_number":
            return f"is {given}; it must be a finite number."
        case "greater_than":
            return f"is {given}; it must be greater than {error['ctx']['gt']:g}."
        case "literal_error":
            return f"is {given!r}; it must be {error['ctx']['expected']}."
        case "string_too_short":
            return "is empty."
        case "too_short":
            return "is empty; it needs at least one."
        case "float_type":
            return f"is {given!r}; it must be a number."
        case "string_type":
            return f"is {given!r}; it must be text in quotes."
        case "bool_type":
            return f"is {given!r}; it must be true or false."
        case "model_type":
            return f"is {given!r}; it must be a table with the keys {', '.join(_known_keys(error['loc']))}."
        case _:
            return f"is {given!r}: {error['msg'][0].lower()}{error['msg'][1:]}."


def _known_keys(loc: tuple[int | str, ...]) -> list[str]:
    """The keys that the schema knows at a place."""
    model: type[BaseModel] = AircraftFile
    for key in loc:
        if isinstance(key, str):
            model = _models(model.model_fields[key].annotation)[0]
    return list(model.model_fields)


def _models(annotation: Any) -> list[type[BaseModel]]:
    """The models that an annotation such as ``tuple[Condition, ...]`` or ``Number | None`` speaks of."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [model for inner in get_args(annotation) for model in _models(inner)]
