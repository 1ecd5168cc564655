"""What steady flight is asked for: the request itself, how it is read from words, and which requests contradict
themselves.

A flight is fixed by its speed, height, path, turn, sideslip and pitch rate. What is asked for in place of one of these
(a bank, a load factor, a throttle, an angle of attack) leaves that one to follow from the flight that is found.
"""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from fdes.analysis.airspeeds import airspeeds
from fdes.elementary import atan2, sqrt
from fdes.errors import NoSuchPart, SpecError
from fdes.units import DEG, parse

STEEPEST = 80.0 * DEG
MOST_BANK = 85.0 * DEG
MOST_LOAD = 20.0
LOWEST, HIGHEST = -1000.0, 80000.0  # m
UNITS = {
    "V": "m/s",
    "M": "1",
    "mach": "1",
    "CAS": "m/s",
    "EAS": "m/s",
    "alpha": "rad",
    "h": "m",
    "gamma": "rad",
    "climb": "m/s",
    "throttle": "1",
    "turn": "rad/s",
    "bank": "rad",
    "q": "rad/s",
    "n": "1",
    "beta": "rad",
    "n_y": "1",
}
# What follows, where this is asked for in its place.
FOLLOWS = {
    "n": "q",
    "n_turn": "turn",
    "n_y": "beta",
    "bank": "turn",
    "slip_bank": "beta",
    "throttle": "gamma",
    "alpha": "V",
}
AIRSPEEDS = {"M": "mach", "mach": "mach", "CAS": "cas", "EAS": "eas"}
# Of each row at most one can be asked for: each of the others follows from it.
EITHER = (
    (("V", "M", "mach", "CAS", "EAS", "alpha"), "how fast it flies"),
    (("gamma", "climb", "throttle"), "how steeply it climbs"),
    (("turn", "q", "n"), "how its path bends"),
    (("bank", "q", "n"), "how its path bends"),
    (("beta", "n_y"), "how it sideslips"),
    (("bank", "turn", "beta"), "bank, turn and sideslip: two of them fix the third"),
    (("bank", "turn", "n_y"), "bank, turn and side force: two of them fix the third"),
)


class TrimSpec(NamedTuple):
    """The steady flight that is asked for. SI; `turn` is the rate of the heading, to the right.

    q: of a pull-up (below zero, a push-over): the pitch rate of the path, which bends in the plane of symmetry.
    In place of one of these: n, the normal load factor n_z of a pull-up (of q); n_turn, that of a turn, negative to the
    left (of turn); bank (of turn); slip_bank, that of a straight sideslip (of beta); n_y, the side force that pilots
    feel (of beta); throttle from 0 to 1 (of gamma); alpha (of V, which then is where the search begins).
    """

    V: float
    h: float
    gamma: float = 0.0
    turn: float = 0.0
    beta: float = 0.0
    q: float = 0.0
    n: float | None = None
    n_turn: float | None = None
    n_y: float | None = None
    bank: float | None = None
    slip_bank: float | None = None
    throttle: float | None = None
    alpha: float | None = None

    def flight(self) -> dict[str, float]:
        """The quantities that fix a flight, those at zero left out from the fourth on."""
        always = {"V": self.V, "h": self.h, "gamma": self.gamma, "turn": self.turn, "beta": self.beta}
        return {**always, "q": self.q} if self.q else always

    def asked(self) -> dict[str, float]:
        """`flight`, with what is asked for in place of some of it."""
        instead = {"n": self.n, "n_turn": self.n_turn, "n_y": self.n_y, "bank": self.bank}
        instead |= {"slip_bank": self.slip_bank, "throttle": self.throttle, "alpha": self.alpha}
        freed = {FOLLOWS[name] for name in instead if instead[name] is not None}
        kept = {name: value for name, value in self.flight().items() if name not in freed}
        return kept | {name: value for name, value in instead.items() if value is not None}


def spec_of(text: str, default: TrimSpec) -> TrimSpec:
    """Read a request such as ``"CAS=250 kt h=20000 ft bank=45 deg"``; what is not said is that of `default`.

    Speed: V (true), M, CAS, EAS, or alpha. Path: gamma, climb, or throttle. Turn: turn, bank, or a load factor as in
    ``turn=2 g``, minus to the left. Pull-up: q or n. Sideslip: beta or n_y; with bank and turn=0, it follows.
    Raises SpecError, NoSuchPart.

    >>> round(spec_of("V=100 kt gamma=3 deg", TrimSpec(V=50.0, h=1000.0)).V, 6)
    51.444444
    >>> spec_of("turn=-2 g", TrimSpec(V=50.0, h=1000.0)).n_turn
    -2.0
    """
    said: dict[str, float] = {}
    for name, value in _assignments(text):
        if name not in UNITS:
            raise NoSuchPart("quantity of a trim", name, UNITS)
        if name in said or (name == "turn" and "n_turn" in said):
            raise SpecError(f"The trim gives {name} twice: give it once.")
        loaded = name == "turn" and value.endswith("g") and not value.endswith("deg")
        if UNITS[name] != "1" and value[-1:].isdigit() and not (name == "turn" and parse(value, "1") == 0.0):
            raise SpecError(f"{name}={value} has no unit. Write it like '{name}={value} {UNITS[name]}'.")
        if loaded:
            said["n_turn"] = parse(value.removesuffix("g"), "1")
        else:
            said[name] = parse(value.removesuffix("g") if name == "n" else value, UNITS[name])
    spec = default._replace(**_in_si(said, default))
    must_be_possible(spec)
    return spec


def _in_si(said: dict[str, float], default: TrimSpec) -> dict[str, float]:
    """What was said, as fields of a `TrimSpec`. Raises SpecError for contradictions."""
    _must_agree(said)
    h = said.get("h", default.h)
    _must_be_between("height", h, LOWEST, HIGHEST, "m")
    for name, kind in AIRSPEEDS.items():
        if name in said:
            said["V"] = airspeeds(kind, said.pop(name), h).tas
    if "climb" in said:
        climb, V = said.pop("climb"), said.get("V", default.V)
        if "alpha" in said:
            raise SpecError("Both climb and alpha are given for the trim, and no speed: give gamma instead of climb.")
        if not abs(climb) < V:
            raise SpecError(f"A climb of {climb:.4g} m/s is asked for at {V:.4g} m/s: it must be less than the speed.")
        said["gamma"] = _asin(climb / V)
    if "bank" in said and said.get("turn") == 0.0:
        said["slip_bank"] = said.pop("bank")
    return said


def _asin(x: float) -> float:
    angle: float = atan2(x, sqrt(1.0 - x * x))
    return angle


def _must_agree(said: Mapping[str, float]) -> None:
    names = {"turn" if name == "n_turn" else name for name in said}
    for rivals, what in EITHER:
        both = [name for name in rivals if name in names]
        most = 2 if len(rivals) == 3 and "bank" in rivals and "turn" in rivals else 1
        if len(both) > most:
            listed = f"Both {both[0]} and {both[1]}" if len(both) == 2 else ", ".join(both)
            raise SpecError(f"{listed} are given for the trim ({what}): leave one of them out.")
    if "bank" in names and "turn" in names and said.get("turn") != 0.0:
        raise SpecError(
            "Both bank and turn are given for the trim: at one speed each follows from the other. Leave one of them "
            "out, or say turn=0 for a straight sideslip with that bank."
        )


def _assignments(text: str) -> Iterable[tuple[str, str]]:
    """``"V=502 ft/s h=0 ft"`` in pairs: a name stands before each equals sign."""
    before, *parts = text.replace(",", " ").replace(";", " ").split("=")
    name = before.strip()
    if not parts:
        raise SpecError(f"The trim {text!r} is not understood. Write it like 'V=170 kt h=5000 ft gamma=3 deg'.")
    for k, part in enumerate(parts):
        words = part.split()
        last = k == len(parts) - 1
        value = " ".join(words if last else words[:-1])
        if not value:
            raise SpecError(f"The trim {text!r} gives no value for {name!r}. Write it like 'V=170 kt h=5000 ft'.")
        yield name, value
        name = "" if last else words[-1]


def must_be_possible(spec: TrimSpec) -> None:
    """Raises SpecError where the request makes no sense for any aircraft, or contradicts itself."""
    if not spec.V > 0.0:
        raise SpecError(f"A trim at {spec.V:g} m/s is asked for; the speed must be greater than zero.")
    _must_be_between("height", spec.h, LOWEST, HIGHEST, "m")
    angles = (("flight-path angle", spec.gamma, STEEPEST), ("sideslip", spec.beta, STEEPEST))
    bank = spec.bank or spec.slip_bank or 0.0
    more = (("bank", bank, MOST_BANK), ("angle of attack", spec.alpha or 0.0, STEEPEST))
    for name, angle, most in (*angles, *more):
        if not abs(angle) <= most:
            raise SpecError(
                f"A trim with a {name} of {angle / DEG:.3g} deg is asked for; at most {most / DEG:.0f} deg make sense."
            )
    for name, load in (("load factor", spec.n), ("load factor of a turn", spec.n_turn), ("side force", spec.n_y)):
        if load is not None and not abs(load) <= MOST_LOAD:
            raise SpecError(f"A trim with a {name} of {load:g} is asked for; at most {MOST_LOAD:g} make sense.")
    if spec.n_turn is not None and not abs(spec.n_turn) > 1.0:
        raise SpecError(
            f"A turn with a load factor of {abs(spec.n_turn):g} is asked for; level turns have more than 1. "
            "For a push-over, say n instead of turn."
        )
    if spec.throttle is not None and not 0.0 <= spec.throttle <= 1.0:
        raise SpecError(f"A trim with a throttle of {spec.throttle:g} is asked for; it must be from 0 to 1.")
    _must_not_contradict(spec)


def _must_not_contradict(spec: TrimSpec) -> None:
    bent = {"q": bool(spec.q) or spec.n is not None, "turn": bool(spec.turn) or spec.n_turn is not None}
    banked = spec.bank is not None or spec.slip_bank is not None
    if (bent["q"] and (bent["turn"] or banked)) or (spec.q and spec.n is not None):
        raise SpecError("A pull-up is in wings-level flight: give one of q, n, turn, n_turn and bank.")
    if spec.turn and spec.n_turn is not None:
        raise SpecError("Both turn and n_turn are given for the trim: leave one of them out.")
    if banked and bent["turn"]:
        raise SpecError("Both bank and turn are given for the trim: leave one of them out.")
    for name in ("n_y", "slip_bank", "throttle"):
        if getattr(spec, name) is not None and getattr(spec, FOLLOWS[name]):
            raise SpecError(f"Both {name} and {FOLLOWS[name]} are given for the trim: leave one of them out.")
    if spec.slip_bank is not None and (spec.bank is not None or spec.n_y is not None):
        raise SpecError("The bank of a straight sideslip fixes it: leave bank and n_y out of the trim.")


def _must_be_between(name: str, value: float, low: float, high: float, unit: str) -> None:
    if not low <= value <= high:
        raise SpecError(
            f"A trim at {value:,.0f} {unit} is asked for; the {name} must be from {low:,.0f} {unit} to "
            f"{high:,.0f} {unit}."
        )


def in_words(spec: TrimSpec) -> str:
    """Such as ``100 m/s, 1,000 m, climbing 3 deg, turning 2 deg/s``."""
    alpha = f"an angle of attack of {(spec.alpha or 0.0) / DEG:.3g} deg"
    said = [f"{spec.V:.4g} m/s" if spec.alpha is None else alpha, f"{spec.h:,.0f} m"]
    if spec.throttle is not None:
        said.append(f"throttle {spec.throttle:.3g}")
    else:
        steep = f"{'climbing' if spec.gamma > 0.0 else 'descending'} {abs(spec.gamma) / DEG:.3g} deg"
        said.append(steep if spec.gamma else "level")
    if spec.n_turn is not None:
        said.append(f"turning {'left' if spec.n_turn < 0.0 else 'right'} at {abs(spec.n_turn):.3g} g")
    if spec.turn:
        said.append(f"turning {spec.turn / DEG:.3g} deg/s")
    if spec.q:
        said.append(f"pitching {spec.q / DEG:.3g} deg/s")
    if spec.n is not None:
        said.append(f"at a load factor of {spec.n:.3g}")
    bank = spec.slip_bank if spec.bank is None else spec.bank
    if bank is not None:
        said.append(f"banked {bank / DEG:.3g} deg")
    if spec.beta:
        said.append(f"sideslipping {spec.beta / DEG:.3g} deg")
    if spec.n_y is not None:
        said.append(f"with a side force of {spec.n_y:.3g} g")
    return ", ".join(said)
