"""Test inputs on the surfaces, written as one would say them: "step aileron 15deg at 0s".

>>> excitation = Excitation.parse(["doublet elevator 5deg at 1s for 2s"])
>>> [round(excitation(t).elevator, 4) for t in (0.0, 1.0, 2.0, 3.0)]
[0.0, 0.0873, -0.0873, 0.0]
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, fields
from typing import Any, get_type_hints

from fdes.errors import NoSuchPart, SpecError
from fdes.physics.signals import Surfaces, channels
from fdes.shelf import shelf
from fdes.units import parse

# What people say, and the field of the shape that it means.
_WORDS = {"from": "at", "for": "lasting"}


@dataclass(frozen=True)
class Excitation:
    """Inputs added to what the control law commands: the sum, at each time, of all shapes on each channel."""

    parts: tuple[tuple[str, Callable[[float], float]], ...]

    @classmethod
    def parse(cls, texts: Iterable[str]) -> "Excitation":
        """Read descriptions; one text may hold several, separated by semicolons. Raises SpecError or NoSuchPart."""
        return cls(tuple(_parse_one(one) for text in texts for one in text.split(";") if one.strip()))

    def __call__(self, t: float) -> Surfaces:
        """What is added at `t` [s]."""
        total = dict.fromkeys(Surfaces._fields, 0.0)
        for channel, shape in self.parts:
            total[channel] += shape(t)
        return Surfaces(**total)


def _parse_one(text: str) -> tuple[str, Callable[[float], float]]:
    words = text.split()
    if len(words) < 3:
        raise SpecError(f"The input {text!r} is incomplete. Write it like 'step aileron 15deg at 0s'.")
    kind, channel, *rest = words
    shape = shelf("inputs").get(kind.lower())
    unit = {c.name: c.unit for c in channels(Surfaces)}
    if channel not in unit:
        raise NoSuchPart("input channel", channel, unit)
    keys = [f.name for f in fields(shape)][1:]
    hints = get_type_hints(shape, include_extras=True)
    amplitude, *named = _split_at_keywords(rest, keys)
    stranger = next((w for w in amplitude[1].split()[1:] if w in {*_WORDS, *_WORDS.values()}), None)
    if stranger:
        raise SpecError(
            f"The input {text!r} says {stranger!r}, which a {kind} does not have. It knows: {', '.join(keys)}."
        )
    values: dict[str, Any] = {}
    for key, said in named:
        if not said:
            raise SpecError(f"The input {text!r} does not say its value after {key!r}.")
        values[key] = parse(said, hints[key].__metadata__[0])
        if key != "at" and values[key] <= 0.0:
            raise SpecError(f"The input {text!r} lasts {said}; it must last longer than 0 s.")
    return channel, shape(parse(amplitude[1], unit[channel]), **values)


def _split_at_keywords(words: list[str], keys: list[str]) -> list[tuple[str, str]]:
    """["15deg", "at", "1", "s"] -> [("", "15deg"), ("at", "1 s")]."""
    parts: list[tuple[str, list[str]]] = [("", [])]
    for word in words:
        key = _WORDS.get(word, word)
        if key in keys:
            parts.append((key, []))
        else:
            parts[-1][1].append(word)
    return [(key, " ".join(said)) for key, said in parts]
