"""What an airplane is for and what it is doing, in the words of MIL-F-8785C: its Class, Category and Flight Phase.

Reference: MIL-F-8785C, Flying Qualities of Piloted Airplanes, 1980, sections 1.3 to 1.5, pages 1 to 4.
"""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

from fdes.errors import NoSuchPart, SpecError

if TYPE_CHECKING:
    from collections.abc import Mapping

AirplaneClass = Literal["I", "II-L", "II-C", "III", "IV"]
Category = Literal["A", "B", "C"]

CLASSES: dict[AirplaneClass, str] = {
    "I": "small, light airplane",
    "II-L": "medium weight, low to medium maneuverability, land-based",
    "II-C": "medium weight, low to medium maneuverability, carrier-based",
    "III": "large, heavy, low to medium maneuverability",
    "IV": "high maneuverability",
}
CATEGORIES: dict[Category, str] = {
    "A": "rapid maneuvering, precision tracking or precise flight-path control",
    "B": "gradual maneuvers without precision tracking",
    "C": "take-off and landing: gradual maneuvers, accurate flight path",
}
PHASES: dict[str, tuple[Category, str]] = {
    "CO": ("A", "air-to-air combat"),
    "GA": ("A", "ground attack"),
    "WD": ("A", "weapon delivery or launch"),
    "AR": ("A", "aerial recovery"),
    "RC": ("A", "reconnaissance"),
    "RR": ("A", "in-flight refueling, receiver"),
    "TF": ("A", "terrain following"),
    "AS": ("A", "antisubmarine search"),
    "FF": ("A", "close formation flying"),
    "CL": ("B", "climb"),
    "CR": ("B", "cruise"),
    "LO": ("B", "loiter"),
    "RT": ("B", "in-flight refueling, tanker"),
    "D": ("B", "descent"),
    "ED": ("B", "emergency descent"),
    "DE": ("B", "emergency deceleration"),
    "AD": ("B", "aerial delivery"),
    "TO": ("C", "take-off"),
    "CT": ("C", "catapult take-off"),
    "PA": ("C", "power approach"),
    "WO": ("C", "wave-off, go-around"),
    "L": ("C", "landing"),
}
# The requirements for Class II differ with where it lands only in Category C; the base need not be given otherwise.
_BASE = {"II": "II-L", "I-L": "I", "I-C": "I", "III-L": "III", "III-C": "III", "IV-L": "IV", "IV-C": "IV"}


@dataclass(frozen=True)
class Role:
    """Class, Category and Flight Phase (a code of `PHASES`, or None), and why these."""

    airplane_class: AirplaneClass
    category: Category
    phase: str | None
    reason: str

    def __str__(self) -> str:
        phase = "" if self.phase is None else f", Flight Phase {self.phase} ({PHASES[self.phase][1]})"
        return f"Class {self.airplane_class}, Category {self.category}{phase}"

    def but(self, airplane_class: str | None = None, category: str | None = None, phase: str | None = None) -> "Role":
        """The same with what is given instead: a Flight Phase brings its Category, another Category drops the phase.

        Raises NoSuchPart for an unknown word, SpecError where phase and Category contradict each other.
        """
        role = self
        if airplane_class is not None:
            role = replace(role, airplane_class=read_class(airplane_class))
        if category is not None:
            wanted = read_category(category)
            role = replace(role, category=wanted, phase=role.phase if wanted == role.category else None)
        if phase is not None:
            code = phase.upper()
            if code not in PHASES:
                raise NoSuchPart("Flight Phase of MIL-F-8785C", phase, PHASES)
            belongs, name = PHASES[code]
            if category is not None and belongs != role.category:
                raise SpecError(
                    f"Flight Phase {code} ({name}) belongs to Category {belongs}, not to Category {role.category}. "
                    "Leave one of the two out."
                )
            role = replace(role, category=belongs, phase=code)
        given = [word for word in (airplane_class, category, phase) if word is not None]
        return replace(role, reason=f"{', '.join(given)} as asked for; the rest: {role.reason}") if given else role


# What holds where nobody says anything else.
STRICTEST = Role("IV", "A", None, "the default, because it is the strictest")


def read_class(text: str) -> AirplaneClass:
    """The Class of that name; Class II without its base is taken as land-based. Raises NoSuchPart."""
    upper = text.upper()
    meant = _BASE.get(upper, upper)
    for known in CLASSES:
        if known == meant:
            return known
    raise NoSuchPart("Class of MIL-F-8785C", text, CLASSES)


def read_category(text: str) -> Category:
    """The Category of that name. Raises NoSuchPart."""
    for known in CATEGORIES:
        if known == text.upper():
            return known
    raise NoSuchPart("Category of MIL-F-8785C", text, CATEGORIES)


def role_of(document: "Mapping[str, Any]", condition: str) -> Role:
    """The role that an aircraft file gives to one of its conditions: the condition's own block, else the file's."""
    conditions = document.get("conditions", ())
    blocks = [c.get("flying_qualities", {}) for c in conditions if c.get("id") == condition]
    general, own = document.get("flying_qualities", {}), blocks[0] if blocks else {}
    said = general | own
    if not said:
        return STRICTEST
    category = said.get("category", STRICTEST.category)
    # A phase of the whole file does not outlive a Category of the condition's own.
    phase = own.get("phase") if "category" in own else said.get("phase")
    return Role(said.get("airplane_class", STRICTEST.airplane_class), category, phase, _reasons(general, own))


def _reasons(general: "Mapping[str, Any]", own: "Mapping[str, Any]") -> str:
    return "; ".join(block["reason"] for block in (general, own) if "reason" in block)
