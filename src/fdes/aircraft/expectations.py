"""What derivatives are expected to be, and what it would mean in flight if they were not. Data for `check`.

Signs are those of docs/symbols.md. Bounds are the extremes of the hangar (R. C. Nelson, Flight Stability and Automatic
Control, 2nd ed., McGraw-Hill 1998, appendix B) and of airplanes in NASA CR-2144 and in J. Roskam, Airplane Flight
Dynamics and Automatic Flight Controls, part I, 1995, widened generously: at the end of each line stand those extremes.
"""

from typing import NamedTuple


class Sign(NamedTuple):
    """The sign that a derivative must have, and what the other sign, or zero, means in flight."""

    derivative: str
    positive: bool
    meaning: str


class Range(NamedTuple):
    """Between which bounds a coefficient is plausible, and what less (`below`) and more (`above`) mean in flight."""

    derivative: str
    low: float
    high: float
    below: str
    above: str


class Ratio(NamedTuple):
    """Between which bounds minus one derivative by another is plausible: mostly a lever arm, `unit` says in what."""

    rule: str
    moment: str
    by: str
    low: float
    high: float
    unit: str
    meaning: str


# fmt: off
SIGNS = (
    Sign("CL_alpha", True,  "Raising the nose loses lift: the aircraft sinks when it is pulled up."),  # Nelson, ch. 2
    Sign("Cm_alpha", False, "Unstable in pitch: once disturbed, the nose runs away by itself."),  # Nelson, ch. 2
    Sign("Cm_q",     False, "Pitching is driven, not damped: the short period lingers or grows."),  # Nelson, ch. 3
    Sign("CL_de",    True,  "Aft stick lifts the aircraft at once, as only a canard does."),  # Nelson, ch. 2
    Sign("Cm_de",    False, "Aft stick lowers the nose: the elevator acts the wrong way round."),  # Nelson, ch. 2
    Sign("Cy_beta",  False, "Air from the right pushes to the right: sideslip is not damped."),  # Nelson, ch. 3
    Sign("Cl_beta",  False, "No dihedral effect: a dropped wing stays down or drops further."),  # Nelson, ch. 2
    Sign("Cn_beta",  True,  "No weathercock: the nose leaves the wind, and it departs in yaw."),  # Nelson, ch. 2
    Sign("Cl_p",     False, "Rolling feeds itself: the stick centered, it rolls ever faster."),  # Nelson, ch. 5
    Sign("Cn_r",     False, "Yawing is driven, not damped: the Dutch roll lingers or grows."),  # Nelson, ch. 5
    Sign("Cl_da",    True,  "Right stick rolls left."),  # Nelson, ch. 2
    Sign("Cy_dr",    True,  "The rudder pushes the tail the way its yaw says it should not."),  # Nelson, ch. 3
    Sign("Cn_dr",    False, "Right pedal yaws left."),  # Nelson, ch. 2
)
# fmt: on

# What a source of dimensional derivatives gives in their place, and whether its sign is the opposite: Z points down.
DIMENSIONAL: dict[str, tuple[tuple[str, ...], bool]] = {
    "CL_alpha": (("Z_w",), True),
    "Cm_alpha": (("M_w",), False),
    "Cm_q": (("M_q",), False),
    "CL_de": (("Z_de", "CZ_de"), True),
    "Cm_de": (("M_de", "Cm_de"), False),
    "Cy_beta": (("Y_v",), False),
    "Cl_beta": (("L_beta", "L_v"), False),
    "Cn_beta": (("N_beta", "N_v"), False),
    "Cl_p": (("L_p",), False),
    "Cn_r": (("N_r",), False),
    "Cl_da": (("L_da", "Cl_da"), False),
    "Cy_dr": (("Ystar_dr", "Cy_dr"), False),
    "Cn_dr": (("N_dr", "Cn_dr"), False),
}

RANGES = (
    Range(
        "CL",
        *(0.05, 2.5),  # 0.20 F-104A to 1.11 B747
        "So fast for its wing that the phugoid is too slow to be seen.",
        "More lift than a wing gives without powered flaps: in flight it would have stalled.",
    ),
    Range(
        "CD",
        *(0.01, 0.4),  # 0.024 Convair 880 to 0.263 F-104A
        "It glides like no airplane, and the phugoid hardly dies out.",
        "Throttle closed, it slows down as behind a parachute.",
    ),
    Range(
        "CL_alpha",
        *(1.5, 8.0),  # 2.0 F-104A to 6.5 JetStar
        "It hardly feels gusts, and pulling gives hardly any load factor.",
        "It answers gusts and pulls with more load factor than a wing can give.",
    ),
    Range(
        "CD_alpha",
        *(0.0, 2.0),  # 0.12 S-211 to 1.13 B747-200
        "Pulling up makes it faster.",
        "Every pull costs so much speed that phugoid and short period are hard to tell apart.",
    ),
    Range(
        "Cm_alpha",
        *(-4.0, -0.05),  # -1.89 Beech 99 to -0.098 F-4C
        "So stiff that the nose snaps back: the short period is faster than a pilot can follow.",
        "Almost neutral: the nose stays where a gust leaves it, and trim never settles.",
    ),
    Range(
        "CL_alphadot",
        *(-10.0, 15.0),  # -6.7 B747 in CR-2144 to 7.0 B747-200
        "It heaves as if lighter than it is: gusts jolt it more than its wing can.",
        "It heaves as if heavier than it is: the short period is slowed.",
    ),
    Range(
        "Cm_alphadot",
        *(-20.0, 0.0),  # -12.7 Cessna 310 to -0.95 F-4C
        "The short period is damped dead: the nose creeps to where it should swing.",
        "The lag of the downwash drives the short period instead of damping it.",
    ),
    Range(
        "CL_q",
        *(0.0, 20.0),  # 0 F-104A to 10.0 S-211
        "Pulling the nose up loses lift as long as it moves.",
        "Pitching alone gives more load factor than a tail can.",
    ),
    Range(
        "Cm_q",
        *(-60.0, -1.0),  # -34 Beech 99 to -2.0 F-4C
        "Pitching stops dead: the short period does not swing at all.",
        "The nose bobs long after each pull: the short period is hardly damped.",
    ),
    Range(
        "CL_M",
        *(-1.2, 1.0),  # -0.81 to 0.2, both B747
        "Gaining speed it sinks: the phugoid may turn into a divergence.",
        "Gaining speed it leaps: the phugoid is much too fast.",
    ),
    Range(
        "CD_M",
        *(-0.1, 0.5),  # 0 F-104A to 0.25 B747
        "Drag falls as it speeds up: speed runs away by itself.",
        "Drag rises so steeply that speed cannot change: the phugoid dies at once.",
    ),
    Range(
        "Cm_M",
        *(-0.4, 0.4),  # -0.1 to 0.27, both B747
        "The nose tucks under as it speeds up: it dives away by itself.",
        "The nose rises so much with speed that the phugoid grows.",
    ),
    Range(
        "CL_de",
        *(0.05, 1.2),  # 0.19 Convair 880 to 0.81 Cessna 310
        "The elevator has hardly any force: where does its moment come from?",
        "Aft stick lets the aircraft drop noticeably before it rises.",
    ),
    Range(
        "CD_de",
        *(-0.3, 0.3),  # -0.14 F-4C to 0.06 Cessna 172
        "Moving the elevator pushes the aircraft forward.",
        "The elevator acts as an airbrake.",
    ),
    Range(
        "Cm_de",
        *(-4.0, -0.2),  # -2.26 Cessna 310 to -0.322 F-4C
        "The lightest touch of the stick throws the nose about.",
        "The stick hardly moves the nose.",
    ),
    Range(
        "Cy_beta",
        *(-2.0, -0.15),  # -1.17 F-104A to -0.31 Cessna 172
        "Sideslip is felt as a shove to the side; a steady one needs a steep bank.",
        "It slips sideways almost without side force or bank.",
    ),
    Range(
        "Cl_beta",
        *(-0.4, -0.01),  # -0.281 B747-200 to -0.06 JetStar
        "A little sideslip rolls it over: the Dutch roll is mostly rolling, and poorly damped.",
        "Pedals do not bank it, and a dropped wing does not come up again: the spiral diverges.",
    ),
    Range(
        "Cn_beta",
        *(0.02, 0.75),  # 0.049 NT-33A to 0.5 F-104A
        "The nose wanders: it hardly weathercocks, and the Dutch roll is slow and wide.",
        "The nose snaps into the wind: the Dutch roll is faster than a pilot can follow.",
    ),
    Range(
        "Cy_p",
        *(-0.4, 0.4),  # -0.19 Beech 99 to 0 B747
        "Each roll shoves the aircraft to the side.",
        "Each roll shoves the aircraft to the side.",
    ),
    Range(
        "Cl_p",
        *(-0.9, -0.12),  # -0.57 NT-33A to -0.24 A-4D
        "Rolling meets more resistance than a wing gives: full stick rolls it slowly.",
        "Rolling goes on long after the stick is centered, and full stick rolls it wildly.",
    ),
    Range(
        "Cn_p",
        *(-0.4, 0.15),  # -0.222 B747-200 to 0.09 S-211
        "Each roll swings the nose the other way: turns are entered with a slide.",
        "Each roll drags the nose along and excites the Dutch roll.",
    ),
    Range(
        "Cy_r",
        *(-0.2, 1.0),  # 0 F-4 to 0.61 S-211
        "Yawing shoves the aircraft to the wrong side.",
        "Yawing shoves the aircraft to the side more than a fin can.",
    ),
    Range(
        "Cl_r",
        *(0.0, 0.5),  # 0.04 JetStar to 0.28 Citation 500
        "In a turn the outer wing drops: it rolls out of every turn.",
        "In a turn the outer wing rises: every turn tightens into a spiral dive.",
    ),
    Range(
        "Cn_r",
        *(-1.2, -0.05),  # -0.75 F-104A to -0.099 Cessna 172
        "Yawing meets more resistance than a fin gives: the Dutch roll does not swing.",
        "The nose swings to and fro for long: the Dutch roll is hardly damped.",
    ),
    Range(
        "Cy_da",
        *(-0.1, 0.1),  # -0.036 F-4C to 0.016 F-4
        "Ailerons shove the aircraft to the side.",
        "Ailerons shove the aircraft to the side.",
    ),
    Range(
        "Cl_da",
        *(0.007, 0.4),  # 0.014 B747 to 0.235 Citation 500
        "Full stick hardly rolls it.",
        "The lightest touch of the stick rolls it over.",
    ),
    Range(
        "Cn_da",
        *(-0.08, 0.08),  # -0.053 Cessna 172 to 0.029 Citation 500
        "Stick to one side swings the nose to the other: adverse yaw beyond what pedals can hold.",
        "Stick to one side swings the nose there: ailerons act as a rudder.",
    ),
    Range(
        "Cy_dr",
        *(0.015, 0.6),  # 0.028 S-211 to 0.304 Citation 500
        "The rudder has hardly any force: where does its moment come from?",
        "Pedals shove the aircraft to the side before the nose moves.",
    ),
    Range(
        "Cl_dr",
        *(-0.05, 0.1),  # -0.002 NT-33A to 0.05 S-211
        "Right pedal rolls it to the right at once, like an aileron.",
        "Right pedal first rolls it to the left, as strongly as an aileron would.",
    ),
    Range(
        "Cn_dr",
        *(-0.3, -0.02),  # -0.16 F-104A to -0.037 T-37
        "The lightest touch of a pedal throws the nose about.",
        "Pedals hardly move the nose.",
    ),
)

RATIOS = (
    Ratio(
        "elevator_arm",
        *("Cm_de", "CL_de"),
        *(0.7, 7.0),  # 1.3 F-4C to 4.0 B747
        "mean chords",
        "The elevator's force and moment do not belong to one tail: stick and load factor answer out of step.",
    ),
    Ratio(
        "rudder_arm",
        *("Cn_dr", "Cy_dr"),
        *(0.15, 1.5),  # 0.18 T-37 to 1.2 B747
        "spans",
        "The rudder's force and moment do not belong to one fin: pedals yaw too much or too little for their push.",
    ),
    Ratio(
        "aileron_yaw",
        *("Cn_da", "Cl_da"),
        *(-0.6, 0.6),  # 0.45 against the roll, Convair 880, to 0.30 with it, Cessna 172
        "of the rolling moment",
        "The ailerons yaw the nose almost as much as they roll the wings: no turn is clean.",
    ),
)

# Which derivatives set the modes and the answer to the controls. Nelson, sections 4.5 and 5.3.
GOVERNING = ("CL_alpha", "Cm_alpha", "Cm_q", "Cn_beta", "Cn_r", "Cl_beta", "Cl_p", "Cl_r", "Cm_de", "Cl_da", "Cn_dr")
