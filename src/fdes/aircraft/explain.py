"""What is wrong with an aircraft file, in sentences that a reader of the file understands."""

from reprlib import repr as repr_short
from typing import Any, get_args

from pydantic import BaseModel, ValidationError

from fdes.aircraft.schema import AircraftFile
from fdes.errors import nearest

SHOWN = 5

# What validation calls a mistake, and what is said of the place where it is.
SENTENCES = {
    "missing": "is missing",
    "value_error": "{error}",
    "finite_number": "is {input}; it must be a finite number",
    "greater_than": "is {input}; it must be greater than {gt:g}",
    "literal_error": "is {input}; it must be {expected}",
    "string_too_short": "is empty",
    "float_type": "is {input}; it must be a number",
    "string_type": "is {input}; it must be text in quotes",
    "bool_type": "is {input}; it must be true or false",
    "dict_type": "is {input}; it must be a table",
    "tuple_type": "is {input}; it must be a list, or tables under [[double brackets]]",
}


def explain(error: ValidationError, document: dict[str, Any]) -> str:
    """The mistakes that validation found in `document`, one line each, the first few of them."""
    lines = [f"  {_place(e['loc'], document)}{_sentence(dict(e))}" for e in error.errors()]
    more = [f"  ... and {len(lines) - SHOWN} more."] if len(lines) > SHOWN else []
    return "\n".join([*lines[:SHOWN], *more])


def by_place(error: ValidationError) -> list[tuple[tuple[int | str, ...], str]]:
    """All mistakes that validation found: the keys that lead to each, and what is wrong there."""
    return [(e["loc"], _sentence(dict(e))) for e in error.errors()]


def _place(loc: tuple[int | str, ...], document: dict[str, Any]) -> str:
    """Where in the file: ``derivatives.Cl_p of condition 'M0.4_SL' ``. A condition goes by its id."""
    if len(loc) > 1 and loc[0] == "conditions" and isinstance(loc[1], int):
        given = document["conditions"][loc[1]]
        name = repr(given["id"]) if isinstance(given, dict) and "id" in given else str(loc[1] + 1)
        return f"{_dotted(loc[2:])} of condition {name} " if loc[2:] else f"condition {name} "
    return f"{_dotted(loc)} " if loc else ""


def _dotted(loc: tuple[int | str, ...]) -> str:
    return ".".join(str(key) for key in loc)


def _sentence(error: dict[str, Any]) -> str:
    known = _known_keys(error["loc"])
    if error["type"] == "extra_forbidden":
        known = _known_keys(error["loc"][:-1])
        near = nearest(str(error["loc"][-1]), known)
        return "is not a known key. " + (f"Did you mean {near!r}?" if near else f"Known here: {', '.join(known)}.")
    given = "a table" if isinstance(error["input"], dict) else repr_short(error["input"])
    if error["type"] == "model_type":
        number = "printed" in known
        wanted = "a number or a table such as { printed = 0.5 }" if number else f"a table of {', '.join(known)}"
        return f"is {given}; it must be {wanted}."
    sentence = SENTENCES.get(error["type"], "is {input}: {msg}")
    words = sentence.format(input=given, msg=error["msg"], **error.get("ctx", {}))
    return words if words.endswith("?") else f"{words}."


def _known_keys(loc: tuple[int | str, ...]) -> list[str]:
    """The keys that the schema knows at a place; none where a number or a text belongs."""
    models: list[type[BaseModel]] = [AircraftFile]
    for key in loc:
        if isinstance(key, str):
            field = models[0].model_fields.get(key) if models else None
            models = _models(field.annotation) if field else []
    return list(models[0].model_fields) if models else []


def _models(annotation: Any) -> list[type[BaseModel]]:
    """The models that an annotation such as ``tuple[Condition, ...]`` or ``Number | None`` speaks of."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [model for inner in get_args(annotation) for model in _models(inner)]
