"""The F-16's control system in NASA's check cases: a state-feedback stabilizer, and an autopilot that gives it goals.

It holds altitude by pitch attitude, course by bank, and airspeed by throttle, at 10,013 ft and 565.7 ft/s. Its gains
are of that condition and of that aircraft alone, so it is no part of the shelf `laws`.

Source: E. B. Jackson, F-16 simple control system, DAVE-ML file F16_control.dml, revision F, 2013, of
NASA/TM-2015-218675; its gains are per degree, knot, foot and rad/s, its outputs shares of full stick.
"""

from dataclasses import dataclass
from math import pi, remainder

import numpy as np

from fdes.control.law import SURFACES, UNITS, Stick
from fdes.control.linear import LinearModel
from fdes.physics.signals import Outputs, Surfaces
from fdes.units import DEG, FOOT, KNOT, Meter, MeterPerSecond, Number, Radian

FULL_ELEVATOR, FULL_AILERON, FULL_RUDDER = -25.0 * DEG, 21.5 * DEG, -30.0 * DEG  # at full aft, right, right
INTERCONNECT = -0.008  # rudder per aileron, right wing down positive

PITCH_PER_HEIGHT = -0.05 * DEG / FOOT  # of attitude commanded, per altitude in excess
MOST_PITCH = 5.0 * DEG
BANK_PER_COURSE = -10.0  # of bank commanded, per course in excess
MOST_BANK = 30.0 * DEG

# Shares of full stick and throttle, each to be taken off: per airspeed, angle of attack, pitch rate, pitch attitude.
STICK = (-0.063009074230494 / KNOT, 0.113230403179271 / DEG, 10.113432224566077, 3.154983341632913 / DEG)
THROTTLE = (0.997260602961658 / KNOT, -0.025467711176391 / DEG, 1.213308488207827, 0.208744369535208 / DEG)
# The same of lateral stick and pedals: per bank, sideslip, roll rate, yaw rate.
ROLL = (3.078043941515770 / DEG, 0.032365863044163 / DEG, 4.557858908828332, 0.589443156647647)
PEDALS = (-0.705817452754520 / DEG, -0.256362860634868 / DEG, -1.073666149713151, 0.822114635953878)

MEASURED = ("eas", "alpha", "q", "theta", "phi", "beta", "p", "r", "h", "psi")


@dataclass(frozen=True)
class F16Autopilot:
    """What is commanded, and the steady flight about which the gains hold.

    altitude, course, airspeed (equivalent): to be held. alpha, theta: of the steady flight; elevator, throttle: what
    trims it, from neutral and of the whole lever. The pilot's controls are not listened to.
    """

    altitude: Meter
    course: Radian
    airspeed: MeterPerSecond
    alpha: Radian
    theta: Radian
    elevator: Radian
    throttle: Number

    def start(self, y: Outputs, stick: Stick) -> None:
        """Nothing to remember."""

    def step(self, y: Outputs, stick: Stick, memory: None, dt: float) -> tuple[Surfaces, None]:
        """Goals first, then feedback of what is off them, then the surfaces for that stick."""
        pitch = self.theta + _within(PITCH_PER_HEIGHT * (y.h - self.altitude), MOST_PITCH)
        bank = _within(BANK_PER_COURSE * remainder(y.psi + y.beta - self.course, 2.0 * pi), MOST_BANK)
        forward = (y.eas - self.airspeed, y.alpha - self.alpha, y.q, y.theta - pitch)
        sideways = (y.phi - bank, y.beta, y.p, y.r)
        aft = _within(self.elevator / FULL_ELEVATOR - _sum(STICK, forward), 1.0)
        lever = min(max(self.throttle - _sum(THROTTLE, forward), 0.0), 1.0)
        right, pedals = _within(-_sum(ROLL, sideways), 1.0), _within(-_sum(PEDALS, sideways), 1.0)
        aileron = FULL_AILERON * right
        rudder = FULL_RUDDER * pedals + INTERCONNECT * aileron
        return Surfaces(FULL_ELEVATOR * aft - self.elevator, aileron, rudder, lever), None

    def linear(self, dt: float | None = None) -> LinearModel:
        """The gains on each surface, away from all limits."""
        forward = dict(zip(("eas", "alpha", "q", "theta"), np.array([STICK, THROTTLE]).T, strict=True))
        forward["h"] = -PITCH_PER_HEIGHT * forward["theta"]
        sideways = dict(zip(("phi", "beta", "p", "r"), np.array([ROLL, PEDALS]).T, strict=True))
        off_course = -BANK_PER_COURSE * sideways["phi"]
        sideways["psi"], sideways["beta"] = off_course, sideways["beta"] + off_course
        D = np.zeros((len(SURFACES), len(MEASURED)))
        for name, (aft, lever) in forward.items():
            D[0, MEASURED.index(name)], D[3, MEASURED.index(name)] = -FULL_ELEVATOR * aft, -lever
        for name, (right, pedals) in sideways.items():
            aileron = -FULL_AILERON * right
            D[1, MEASURED.index(name)] = aileron
            D[2, MEASURED.index(name)] = -FULL_RUDDER * pedals + INTERCONNECT * aileron
        units = {name: UNITS[name] for name in (*SURFACES, *MEASURED)}
        nothing = np.zeros((0, 0))
        return LinearModel(
            nothing,
            np.zeros((0, len(MEASURED))),
            (),
            MEASURED,
            units,
            {},
            SURFACES,
            np.zeros((len(SURFACES), 0)),
            D,
            dt,
        )


def _sum(gains: tuple[float, ...], off: tuple[float, ...]) -> float:
    return sum(gain * value for gain, value in zip(gains, off, strict=True))


def _within(value: float, most: float) -> float:
    return min(max(value, -most), most)
