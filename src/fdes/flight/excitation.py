"""Test inputs on the surfaces, written as one would say them: "step aileron 15deg at 0s".

>>> excitation = Excitation.parse(["doublet elevator 5deg at 1s for 2s"])
>>> [round(excitation(t).elevator, 4) for t in (0.0, 1.0, 2.0, 3.0)]
[0.0, 0.0873, -0.0873, 0.0]
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, get_type_hints

from fdes.errors import NoSuchPart, SpecError
from fdes.physics.signals import Surfaces, channels
from fdes.shelf import shelf
from fdes.units import parse

# What people say, and the name of what they mean; and what to call it when speaking to them.
_MEANT = {"from": "at", "for": "lasting", "3-2-1-1": "three_two_one_one", "3211": "three_two_one_one"}
_SAID = {"lasting": "for"}


@dataclass(frozen=True)
class Excitation:
    """Inputs added to what the control law commands: the sum, at each time, of all shapes on each channel."""

    parts: tuple[tuple[str, Any], ...]

    @classmethod
    def parse(cls, texts: Iterable[str]) -> "Excitation":
        """Read descriptions; one text may hold several, separated by semicolons. Raises SpecError or NoSuchPart."""
        said = [one for text in texts for one in text.rstrip("; ").split(";")]
        return cls(tuple(_parse_one(one) for one in said))

    def later(self, t: float) -> "Excitation":
        """The same inputs, begun `t` [s] later."""
        return Excitation(tuple((channel, replace(shape, at=shape.at + t)) for channel, shape in self.parts))

    def over(self, times: Sequence[float]) -> Surfaces:
        """What is added at each of `times` [s]: one list per surface."""
        total: dict[str, list[float]] = {name: [0.0] * len(times) for name in Surfaces._fields}
        for channel, shape in self.parts:
            total[channel] = [sum_so_far + shape(t) for sum_so_far, t in zip(total[channel], times, strict=True)]
        return Surfaces(**total)  # type: ignore[arg-type]  # whole columns

    def __call__(self, t: float) -> Surfaces:
        """What is added at `t` [s]."""
        total = dict.fromkeys(Surfaces._fields, 0.0)
        for channel, shape in self.parts:
            total[channel] += shape(t)
        return Surfaces(**total)


def _parse_one(text: str) -> tuple[str, Any]:
    words = text.split()
    if len(words) < 3:
        raise SpecError(f"The input {text!r} is incomplete. Write it like 'step aileron 15deg at 0s'.")
    kind, channel, *rest = words
    shape = shelf("inputs").get(_meant(kind))
    unit = {c.name: c.unit for c in channels(Surfaces)}
    channel = channel.lower()
    if channel not in unit:
        raise NoSuchPart("input channel", channel, unit)
    amplitude, *keys = [f.name for f in fields(shape)]
    hints = get_type_hints(shape, include_extras=True)
    units = {amplitude: unit[channel]} | {key: hints[key].__metadata__[0] for key in keys}
    values: dict[str, float] = {}
    for key, said in _split_at_keywords(rest, amplitude, keys):
        name = channel if key == amplitude else _SAID.get(key, key)
        if not said:
            raise SpecError(f"The input {text!r} does not say its value after {name!r}.")
        if key in values:
            raise SpecError(f"The input {text!r} says {name!r} twice.")
        strangers = said[2:] if _is_number(said[0]) else said[1:]  # "15 deg" is two words, "15deg" is one
        if strangers:
            known = ", ".join(_SAID.get(k, k) for k in keys)
            raise SpecError(
                f"The input {text!r} says {strangers[0]!r}, which a {kind} does not have. It knows: {known}."
            )
        values[key] = _quantity(text, " ".join(said), units[key])
        if key not in {amplitude, "at"} and values[key] <= 0.0:
            raise SpecError(f"The input {text!r} says {name} {' '.join(said)}; it must last longer than 0 s.")
    return channel, shape(**values)


def _split_at_keywords(words: list[str], amplitude: str, keys: list[str]) -> list[tuple[str, list[str]]]:
    """["15deg", "at", "1", "s"] -> [("amplitude", ["15deg"]), ("at", ["1", "s"])]."""
    parts: list[tuple[str, list[str]]] = [(amplitude, [])]
    for word in words:
        key = _meant(word)
        if key in keys:
            parts.append((key, []))
        else:
            parts[-1][1].append(word)
    return parts


def _quantity(text: str, said: str, unit: str) -> float:
    """What is said, in SI. An angle must have its unit: who writes 15 means degrees, not 15 rad."""
    try:
        value = parse(said, unit)
    except SpecError as trouble:
        raise SpecError(f"The input {text!r} cannot be read. {trouble}") from trouble
    if unit == "rad" and _is_number(said):
        raise SpecError(f"The input {text!r} does not say the unit of {said}. Write {said}deg, or {said}rad.")
    return value


def _meant(word: str) -> str:
    return _MEANT.get(word.lower(), word.lower())


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True
