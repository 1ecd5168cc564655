"""Control laws designed for an aircraft in its flight condition: gains for what is wanted of a mode.

`law_for("yaw_damper zeta=0.4", condition)` is the law; beside it stands what was wanted, what the gain gives where it
was designed, and what is flown at the step of the flight: a command held through a frame comes half a frame late, and
that costs damping. Sensors and actuators are in the design. What is out of reach is said, with the best there is.
"""

from collections.abc import Callable, Mapping
from dataclasses import MISSING, fields, replace
from typing import Any, NamedTuple

import numpy as np

from fdes.aircraft import FlightCondition
from fdes.analysis.closed_loop import close
from fdes.analysis.command_settings import command_settings
from fdes.analysis.design_rules import PAIR_ZETA, RULES, Rule, fair_wish, wishes_of
from fdes.analysis.designed import Achieved, Designed
from fdes.analysis.margins import without_sensors
from fdes.analysis.mode_names import OSCILLATIONS, decoupled, states_beside
from fdes.analysis.modes import Mode, modes
from fdes.analysis.placement import Quantity, followed_root, measure, nearest_root, one_gain, stable, two_gains
from fdes.control import Law, LinearModel
from fdes.control.laws.direct import Direct
from fdes.control.laws.sensors import Sensors
from fdes.control.spoken import WISHES, Loop, loops, units_of
from fdes.errors import SpecError
from fdes.physics.actuators import Actuators
from fdes.physics.derivatives import Form

FRAME = 1.0 / 120.0  # s: of the cockpit


class _Closed(NamedTuple):
    """One loop closed round those inside it, and what becomes of the mode: `alone` is without actuators and sensors."""

    law: Law
    settings: dict[str, float]
    achieved: Achieved | None
    root: complex
    notes: list[str]
    alone: complex = 0j


class _Around(NamedTuple):
    """What a loop is closed round, and behind which sensors: their settings, none without."""

    condition: FlightCondition
    form: Form
    dt: float | None
    actuators: Actuators | None
    sensors: Mapping[str, float]

    def close(self, law: Law) -> LinearModel:
        """The closed loop of `law` with all there is between air and surface."""
        late = Sensors(law, **self.sensors) if self.sensors and not isinstance(law, Sensors) else law
        return close(self.condition, late, self.dt, self.actuators, self.form)


def law_for(
    text: str,
    condition: FlightCondition,
    form: Form = "full",
    dt: float | None = None,
    frame: float | None = None,
    own: Mapping[str, Any] | None = None,
    actuators: Actuators | None = None,
) -> Designed:
    """The law that `text` names, for that aircraft: gains given, or designed for what is wished, or for a fair default.

    With `dt` [s] it is designed in z at that step, else in s. `frame` [s] is the step it is flown at: `dt` unless said,
    else that of the cockpit. `own` are laws beside those of the shelf, by name. Loops are closed in the order in which
    they are said, each designed with those before it closed, with `actuators` where there are any, and behind sensors
    that are said last. Raises SpecError, NoSuchPart.

    >>> import fdes
    >>> designed = law_for("yaw_damper zeta=0.4", fdes.load("A-4D").at("M0.4_SL"))
    >>> round(designed.achieved[0].continuous, 4)
    0.4
    """
    step = frame or dt or FRAME
    law: Law = Direct(condition.full_stick)
    steps: list[tuple[Loop, _Closed]] = []
    spoken = loops(text, own)
    around = _Around(condition, form, dt, actuators, dict(spoken[-1].settings) if spoken[-1].part is Sensors else {})
    for loop in spoken:
        closed = _close_loop(loop, law, around)
        law = closed.law
        steps.append((loop, closed))
    alone = close(condition, without_sensors(law), form=form)
    whole = close(condition, law, None, actuators, form)
    flown = close(condition, law, step, actuators, form)
    achieved, notes = [], []
    for _, closed in steps:
        notes += closed.notes
        if closed.achieved is None:
            continue
        mode, quantity = closed.achieved.mode, closed.achieved.quantity
        s = nearest_root(decoupled(whole, mode), closed.root)
        z = nearest_root(decoupled(flown, mode), s)
        by_itself = measure(nearest_root(decoupled(alone, mode), closed.alone), quantity)
        achieved.append(
            replace(closed.achieved, alone=by_itself, continuous=measure(s, quantity), flown=measure(z, quantity))
        )
    notes += _parted({one.mode for one in achieved if one.mode in OSCILLATIONS}, modes(whole))
    bare = [m.eigenvalue for m in modes(condition, form)]
    if not stable(whole, bare):
        notes.append("With these gains the closed loop has a mode that grows faster than any of the bare aircraft.")
    elif not stable(flown, bare):
        notes.append(f"Flown at {1.0 / step:g} frames a second, the closed loop is unstable: take smaller gains.")
    return Designed(
        law=law,
        text="; ".join(_said(loop.name, closed.settings) for loop, closed in steps),
        gains={loop.name: closed.settings for loop, closed in steps},
        achieved=tuple(achieved),
        notes=tuple(notes),
        frame=step,
    )


def _parted(followed: set[str], closed: list[Mode]) -> list[str]:
    """Where the other half of an oscillation is that a loop has split: one half alone was followed."""
    return [
        f"The {mode.replace('_', ' ')} has split. Its other half is in the {other.name.replace('_', ' ')}, "
        f"zeta {other.zeta:.3g} at {other.omega_n:.3g} rad/s."
        for mode in sorted(followed)
        for other in closed
        if other.oscillatory and mode in other.name and other.name != mode and mode not in {m.name for m in closed}
    ]


def _said(name: str, settings: Mapping[str, float]) -> str:
    """The law in words that give the same numbers again."""
    angles = {"full_rate": "rad/s", "full_bank": "rad"}
    return " ".join([name, *(f"{key}={value!r}{angles.get(key, '')}" for key, value in settings.items())])


def _close_loop(loop: Loop, inner: Law, around: _Around) -> _Closed:
    condition, form, dt = around.condition, around.form, around.dt
    rule = RULES.get(loop.name)
    units = units_of(loop.part)
    settings = dict(loop.settings)
    by_hand = rule is None or any(name in settings for name in rule.gains)
    if by_hand and loop.wishes:
        wish = next(iter(loop.wishes))
        why = (
            "FDES knows no design for it"
            if rule is None
            else f"its {next(n for n in rule.gains if n in settings)} is given"
        )
        raise SpecError(f"{loop.name} cannot be designed for {wish}: {why}. Say the gains, or what you want of them.")
    settings = command_settings(loop.name, condition, form) | settings
    if by_hand and rule is not None:
        settings |= {name: 0.0 for name in rule.gains if name not in settings}
    missing = [
        f.name
        for f in fields(loop.part)
        if f.name in units and f.default is MISSING and f.name not in settings and not (rule and f.name in rule.gains)
    ]
    if missing:
        raise SpecError(f"{loop.name} needs {missing[0]}: write '{loop.name} {missing[0]}=...' [{units[missing[0]]}].")

    def made(**gains: float) -> Law:
        given = {
            name: value for name, value in (("inner", inner), ("full_stick", condition.full_stick)) if _has(loop, name)
        }
        law: Law = loop.part(**given, **(settings | gains))
        return law

    if rule is None:
        return _Closed(made(), _all_settings(loop, settings, {}), None, 0j, _notes(made()))
    beside = states_beside(around.close(made(**dict.fromkeys(rule.gains, 1.0))), rule.mode)

    def closed(**gains: float) -> LinearModel:
        model = around.close(made(**gains))
        return model.part(beside, model.inputs)  # a root of the other axis may lie nearer than what is looked for

    zero = dict.fromkeys(rule.gains, 0.0)
    without = closed(**zero)
    bare = _root_of(close(condition, made(**zero), dt, form=form), rule.mode)
    begin = nearest_root(without, bare)
    damped = loop.name == "pitch_rate_pi" and begin.imag != 0.0 and not {"omega", "time_constant"} & set(loop.wishes)
    if by_hand:
        s = followed_root(without, closed(), begin)
        shown = _achieved(loop, rule, rule.wishes[0], None, begin, s, reached=True)
        done = _Closed(made(), _all_settings(loop, settings, {}), shown, s, [])
    elif len(rule.gains) == 1 or damped:
        done = _design_one(loop, rule, begin, closed, made, settings)
    else:
        done = _design_two(loop, rule, begin, closed, made, settings)
    return done._replace(alone=_alone(made(**zero), done.law, bare, rule.mode, around))


def _alone(before: Law, after: Law, root: complex, mode: str, around: _Around) -> complex:
    """What becomes of the mode's root from the law `before` to that `after`, without actuators and sensors."""
    one, other = (close(around.condition, without_sensors(law), form=around.form) for law in (before, after))
    states = states_beside(other, mode)
    return followed_root(one.part(states, one.inputs), other.part(states, other.inputs), root)


def _design_one(
    loop: Loop,
    rule: Rule,
    begin: complex,
    closed: Callable[..., LinearModel],
    made: Callable[..., Law],
    settings: dict[str, float],
) -> _Closed:
    """One gain; of two, the second in proportion, so that the zero of a PI lies at half the natural frequency."""
    gain, *second = rule.gains
    quantity = rule.wishes[0]
    has = measure(begin, quantity)
    wanted = wishes_of(loop, rule).get(quantity) or (PAIR_ZETA if second else fair_wish(rule.mode, quantity, has))

    def gains(k: float) -> dict[str, float]:
        return {gain: k, **{name: 0.5 * abs(begin) * k for name in second}}

    found = one_gain(lambda k: closed(**gains(k)), begin, quantity, wanted)
    notes, unit = [], f" {WISHES[quantity]}".removesuffix(" 1")
    what = f"{loop.name}: {quantity} {wanted:.3g}{unit}"
    if not found.reached and found.gain == 0.0:
        without = f"the {has:.3g}{unit} of the {_words(rule.mode)} without it"
        better = has <= wanted if quantity == "time_constant" else has >= wanted
        why = f"is no better than {without}" if better else f"is out of reach, any gain being worse than {without}"
        notes.append(f"{what} {why}: the gain is 0.")
    elif not found.reached:
        best = measure(found.root, quantity)
        why = (
            " With more gain another mode would come within 6 dB of growing." if found.gain > 0.95 * found.limit else ""
        )
        notes.append(
            f"{what} is out of reach. The best that a positive gain attains is {best:.3g}{unit}, at gain "
            f"{found.gain:.4g}, which is taken.{why}"
        )
    taken = gains(found.gain)
    root = nearest_root(closed(**taken), found.root)
    shown = _achieved(loop, rule, quantity, wanted, begin, root, reached=found.reached)
    return _Closed(made(**taken), _all_settings(loop, settings, taken), shown, root, notes)


def _design_two(
    loop: Loop,
    rule: Rule,
    begin: complex,
    closed: Callable[..., LinearModel],
    made: Callable[..., Law],
    settings: dict[str, float],
) -> _Closed:
    """A pair where it is wanted, with both gains positive: else the nearest natural frequency at which they are."""
    first, second = rule.gains
    wished = wishes_of(loop, rule)
    zeta = wished.get("zeta", PAIR_ZETA)
    if not 0.0 < zeta < 1.0:
        raise SpecError(f"{loop.name} cannot be designed for zeta {zeta:g}: a pair has more than 0 and less than 1.")
    omega = wished.get("omega", abs(begin))
    if "time_constant" in wished:
        if "omega" in wished:
            raise SpecError(f"{loop.name} is asked for omega and for time_constant: with zeta, one of them is enough.")
        omega = 1.0 / (zeta * wished["time_constant"])

    placing = two_gains(lambda a, b: closed(**{first: a, second: b}))

    def gains_at(w: float) -> tuple[float, float] | None:
        found = placing(w * complex(-zeta, np.sqrt(1.0 - zeta * zeta)))
        return found if found and min(found) >= 0.0 else None

    found, reached, notes, quantity = gains_at(omega), True, [], rule.wishes[0]
    if found is None:
        near = [w for w in omega * np.geomspace(0.1, 10.0, 401) if gains_at(w)]
        if not near:
            raise SpecError(
                f"{loop.name} cannot give zeta {zeta:.3g}: no natural frequency from {0.1 * omega:.3g} to "
                f"{10.0 * omega:.3g} rad/s has it with positive gains. Ask for another zeta."
            )
        taken = float(min(near, key=lambda w: abs(np.log(w / omega))))
        found, reached = gains_at(taken), False
        notes.append(
            f"{loop.name}: omega {omega:.3g} rad/s with zeta {zeta:.3g} is out of reach with positive gains. "
            f"The nearest is {taken:.3g} rad/s, which is taken."
        )
        omega = taken
    if found is None:
        raise SpecError(f"{loop.name} cannot be designed here: its gains do not move the {_words(rule.mode)}.")
    gains = dict(zip(rule.gains, found, strict=True))
    root = omega * complex(-zeta, np.sqrt(1.0 - zeta * zeta))
    shown = _achieved(loop, rule, quantity, zeta, begin, nearest_root(closed(**gains), root), reached=reached)
    return _Closed(made(**gains), _all_settings(loop, settings, gains), shown, root, notes)


def _achieved(
    loop: Loop, rule: Rule, quantity: Quantity, wanted: float | None, begin: complex, s: complex, *, reached: bool
) -> Achieved:
    has = measure(s, quantity)
    before = measure(begin, quantity)
    return Achieved(loop.name, rule.mode, quantity, WISHES[quantity], wanted, before, has, has, has, has, reached)


def _notes(law: Law) -> list[str]:
    """What should be known of a law that is not designed."""
    if isinstance(law, Sensors) and not law.measured:
        return ["sensors: the laws said before it measure nothing. Say it last, and it delays what they measure."]
    return []


def _root_of(model: LinearModel, mode: str) -> complex:
    """The root that is the mode, or what has become of it."""
    found = modes(model)
    named = [m for m in found if m.name == mode] or [m for m in found if mode in m.name]
    if not named:
        raise SpecError(f"There is no {_words(mode)} to design for: the modes are {', '.join(m.name for m in found)}.")
    return named[0].eigenvalue


def _all_settings(loop: Loop, settings: Mapping[str, float], gains: Mapping[str, float]) -> dict[str, float]:
    """Every setting of the law, what it has by default too."""
    defaults = {
        f.name: f.default for f in fields(loop.part) if f.name in units_of(loop.part) and f.default is not MISSING
    }
    every = defaults | dict(settings) | dict(gains)
    return {name: every[name] for name in units_of(loop.part)}


def _has(loop: Loop, name: str) -> bool:
    return any(f.name == name for f in fields(loop.part))


def _words(mode: str) -> str:
    return mode.replace("_", " ")
