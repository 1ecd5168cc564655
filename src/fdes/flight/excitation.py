"""Test inputs on surfaces and in the air, written as one would say them: "step aileron 15deg at 0s".

>>> excitation = Excitation.parse(["doublet elevator 5deg at 1s for 2s", "step gust_w -3m/s"])
>>> [round(excitation(t).elevator, 4) for t in (0.0, 1.0, 2.0, 3.0)]
[0.0, 0.0873, -0.0873, 0.0]
>>> excitation.gusts(0.0).gust_w
-3.0
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any, NamedTuple, get_type_hints

from fdes.errors import NoSuchPart, SpecError
from fdes.physics.signals import Air, Outputs, Surfaces, channels
from fdes.shelf import shelf
from fdes.units import MeterPerSecond, Radian, parse

# What people say, and the name of what they mean; and what to call it when speaking to them.
_MEANT = {
    "from": "at",
    "for": "lasting",
    "3-2-1-1": "three_two_one_one",
    "3211": "three_two_one_one",
    "1-cosine": "one_minus_cosine",
    "1-cosine-pulse": "one_minus_cosine_pulse",
}
_CHANNEL_MEANT = {"u_gust": "gust_u", "v_gust": "gust_v", "w_gust": "gust_w"}
_SAID = {"lasting": "for"}


class Gusts(NamedTuple):
    """What may be put into the air: the velocity of a gust in body axes, or the angle that it adds to the flow's.

    A vertical gust from below is gust_w < 0, or alpha_g > 0; one from the right is gust_v < 0, or beta_g > 0.
    """

    gust_u: MeterPerSecond = 0.0
    gust_v: MeterPerSecond = 0.0
    gust_w: MeterPerSecond = 0.0
    alpha_g: Radian = 0.0
    beta_g: Radian = 0.0


NO_GUSTS = Gusts()
UNITS = {c.name: c.unit for record in (Surfaces, Gusts) for c in channels(record)}


@dataclass(frozen=True)
class Excitation:
    """Inputs added to what the control law commands, and to the air: the sum, at each time, of all shapes on each
    channel, a field of `Surfaces` or of `Gusts`.
    """

    parts: tuple[tuple[str, Any], ...]

    @classmethod
    def parse(cls, texts: Iterable[str], *, files: bool = False) -> "Excitation":
        """Read descriptions; one text may hold several, separated by semicolons. Raises SpecError or NoSuchPart.

        With `files` they may name a file with a measured history. Never allow it for a text from the network.
        """
        said = [one for text in texts for one in text.rstrip("; ").split(";")]
        return cls(tuple(_parse_one(one, files) for one in said))

    def later(self, t: float) -> "Excitation":
        """The same inputs, begun `t` [s] later."""
        return Excitation(tuple((channel, replace(shape, at=shape.at + t)) for channel, shape in self.parts))

    def over(self, times: Sequence[float]) -> Surfaces:
        """What is added to the surfaces at each of `times` [s]: one list per surface."""
        return Surfaces(*self._columns(Surfaces, times))  # type: ignore[arg-type]  # whole columns

    def gusts_over(self, times: Sequence[float]) -> Gusts:
        """What is added to the air at each of `times` [s]: one list per field."""
        return Gusts(*self._columns(Gusts, times))  # type: ignore[arg-type]  # whole columns

    def __call__(self, t: float) -> Surfaces:
        """What is added to the surfaces at `t` [s]."""
        return Surfaces(*self._sums(Surfaces, t))

    def gusts(self, t: float) -> Gusts:
        """What is added to the air at `t` [s]."""
        return Gusts(*self._sums(Gusts, t))

    def _sums(self, record: type[NamedTuple], t: float) -> Iterable[float]:
        total = dict.fromkeys(record._fields, 0.0)
        for channel, shape in self.parts:
            if channel in total:
                total[channel] += shape(t)
        return total.values()

    def _columns(self, record: type[NamedTuple], times: Sequence[float]) -> Iterable[list[float]]:
        total: dict[str, list[float]] = {name: [0.0] * len(times) for name in record._fields}
        for channel, shape in self.parts:
            if channel in total:
                total[channel] = [sum_so_far + shape(t) for sum_so_far, t in zip(total[channel], times, strict=True)]
        return total.values()


def blown(air: Air, gusts: Gusts, V: float) -> Air:
    """`air` with `gusts` in it, `V` [m/s] being the undisturbed airspeed: alpha_g = -gust_w / V, beta_g = -gust_v / V.

    Numbers, or whole columns of them.
    """
    return air._replace(
        gust_u=air.gust_u + gusts.gust_u,
        gust_v=air.gust_v + gusts.gust_v - V * gusts.beta_g,
        gust_w=air.gust_w + gusts.gust_w - V * gusts.alpha_g,
    )


@dataclass(frozen=True)
class GustyAir:
    """Weather with `gusts`, a function of time, in steady `air`; `V` [m/s] is the undisturbed airspeed.

    What it remembers is the number of the frame, so that it meets the clock without rounding.
    """

    gusts: Callable[[float], Gusts]
    V: float
    air: Air = field(default_factory=Air)

    def start(self) -> tuple[Air, int]:
        """The air of the first frame."""
        return blown(self.air, self.gusts(0.0), self.V), 0

    def step(self, memory: int, y: Outputs, dt: float) -> tuple[Air, int]:
        """The air of the next frame, `dt` [s] later."""
        now = self.gusts((memory + 1) * dt)
        return (self.air if now is NO_GUSTS else blown(self.air, now, self.V)), memory + 1


def _parse_one(text: str, files: bool) -> tuple[str, Any]:
    words = text.split()
    if len(words) < 3:
        raise SpecError(f"The input {text!r} is incomplete. Write it like 'step aileron 15deg at 0s'.")
    kind, channel, *rest = words
    shape = shelf("inputs").get(_meant(kind))
    channel = _CHANNEL_MEANT.get(channel.lower(), channel.lower())
    if channel not in UNITS:
        raise NoSuchPart("input channel", channel, UNITS, _CHANNEL_MEANT)
    if hasattr(shape, "read"):
        return channel, _from_file(text, shape, channel, rest, files)
    amplitude, *keys = [f.name for f in fields(shape)]
    values = _said_values(text, kind, channel, rest, _units(shape, keys) | {amplitude: UNITS[channel]})
    return channel, shape(**values)


def _from_file(text: str, shape: Any, channel: str, rest: list[str], files: bool) -> Any:
    """A shape whose numbers are in a file: ``measured elevator run.csv column elevator at 1s``."""
    if not files:
        raise SpecError(
            f"The input {text!r} names a file, which is read on the command line and in Python only. "
            "In the cockpit choose the file in the tab Inputs: the browser reads it, and sends its numbers."
        )
    parts = dict(_split_at_keywords(rest, "file", ["column", "at"]))
    if not parts["file"] or any(not said for said in parts.values()):
        raise SpecError(
            f"The input {text!r} is incomplete. Write it like 'measured {channel} run.csv column {channel}'."
        )
    when = _quantity(text, " ".join(parts["at"]), "s") if "at" in parts else 0.0
    read = shape.read(" ".join(parts["file"]), " ".join(parts.get("column", [channel])), UNITS[channel])
    return shape(*read, at=when)


def _units(shape: Any, keys: list[str]) -> dict[str, str]:
    hints = get_type_hints(shape, include_extras=True)
    return {key: hints[key].__metadata__[0] for key in keys}


def _said_values(text: str, kind: str, channel: str, rest: list[str], units: dict[str, str]) -> dict[str, float]:
    """The fields of a shape in SI; the last of `units` is that of its amplitude."""
    *keys, amplitude = units
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
    return values


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
