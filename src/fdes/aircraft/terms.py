"""Aerodynamics as tables and sums of terms in an aircraft file, under [terms], in the units and signs of the source.

    [terms.axes]                                                   # what tables are read over
    alpha = { signal = "alpha", unit = "deg", breakpoints = [-10, 0, 10] }
    [terms.signals]                                                # of the source: a signal of FDES per some unit
    dail  = { signal = "aileron", per = "20 deg", reversed = true }
    [terms.tables]
    Cl_p  = { axes = ["alpha"], values = [-0.36, -0.44, -0.38] }
    [terms.sums]                                                   # CX, CY, CZ, Cl, Cm, Cn, about the moment reference
    Cl    = [{ gain = 1, table = "Cl_p", times = ["p_hat"] }, { gain = -0.05, times = ["dail"] }]

Signals of FDES are those of `fdes.physics.terms.SIGNALS`, in rad or as numbers, with the signs of docs/symbols.md.
Nothing is evaluated: a term is a gain, at most one table, and signals, multiplied.
"""

from collections.abc import Iterable, Mapping
from itertools import pairwise
from typing import Annotated, Any, Literal, Self

from pydantic import Field, field_validator, model_validator

from fdes.aircraft.number import Part, Ratio
from fdes.errors import SpecError, nearest
from fdes.physics.tables import Axis
from fdes.physics.terms import FORCES_AND_MOMENTS, SIGNALS, SignalAxis, Table, Term, TermAero
from fdes.units import Meter, Meter2, parse, si_unit, to_si

Row = Annotated[tuple[float, ...], Field(strict=False)]
Names = Annotated[tuple[str, ...], Field(strict=False)]
ANGLES = frozenset({"alpha", "beta", "elevator", "aileron", "rudder"})


def rising(breakpoints: Row) -> Row:
    """Breakpoints that tables can be read over. Raises ValueError for others."""
    if len(breakpoints) < 2:
        raise ValueError(f"needs two breakpoints at least, and has {len(breakpoints)}")
    for before, after in pairwise(breakpoints):
        if after <= before:
            raise ValueError(f"must rise from breakpoint to breakpoint, and {after:g} follows {before:g}")
    return breakpoints


def known(name: str, names: Iterable[str], what: str) -> str:
    """`name`, which is one of `names`. Raises ValueError with the nearest one."""
    names = list(names)
    if name not in names:
        near = nearest(name, names)
        hint = f"Did you mean {near!r}?" if near else f"Known: {', '.join(names)}"
        raise ValueError(f"{name!r} is no {what}. {hint}")
    return name


def a_signal(name: str) -> str:
    """`name`, which is a signal of FDES. Raises ValueError with the nearest one."""
    return known(name, SIGNALS, "signal")


class TableAxis(Part):
    """What tables are read over: a signal, in a unit of the source.

    mirrored: the tables hold for positive values, and change sign with the signal. reversed: the source's sign is the
    opposite of that of FDES.
    """

    signal: str
    unit: str = "1"
    breakpoints: Row
    mirrored: bool = False
    reversed: bool = False

    _known = field_validator("signal")(a_signal)
    _rising = field_validator("breakpoints")(rising)

    @model_validator(mode="after")
    def _of_its_unit(self) -> Self:
        fitting = "rad" if self.signal in ANGLES else "1"
        try:
            unit = si_unit(self.unit)
        except SpecError as error:
            raise ValueError(str(error)) from None
        if unit != fitting:
            raise ValueError(f"is in {self.unit!r}, but {self.signal} is in {fitting!r}, or what converts to it")
        if self.mirrored and self.breakpoints[0] != 0.0:
            raise ValueError(f"is mirrored, and so must begin at 0, not at {self.breakpoints[0]:g}")
        return self


class SourceSignal(Part):
    """A signal as the source has it: one of FDES divided by `per`, such as "25 deg", and with its own sign."""

    signal: str
    per: str = "1"
    reversed: bool = False

    _known = field_validator("signal")(a_signal)

    @model_validator(mode="after")
    def _of_its_unit(self) -> Self:
        if self.gain() == 0.0:
            raise ValueError("is per 0: give a number greater than zero")
        return self

    def gain(self) -> float:
        """What the signal of FDES is multiplied by. Raises ValueError where `per` cannot be read."""
        try:
            per = parse(self.per, "rad" if self.signal in ANGLES else "1")
        except SpecError as error:
            raise ValueError(str(error)) from None
        return (-1.0 if self.reversed else 1.0) / per if per else 0.0


class TableValues(Part):
    """A table over one axis, or over two: then a row of values over the second for each breakpoint of the first."""

    axes: Names = Field(min_length=1, max_length=2)
    values: Annotated[tuple[Row, ...], Field(strict=False)]
    source: str | None = None

    @field_validator("values", mode="before")
    @classmethod
    def _rows(cls, values: Any) -> Any:
        flat = isinstance(values, list | tuple) and values and not any(isinstance(v, list | tuple) for v in values)
        return [values] if flat else values


class TermOf(Part):
    """gain times table times signals."""

    gain: float = 1.0
    table: str | None = None
    times: Names = ()


Sum = Annotated[tuple[TermOf, ...], Field(strict=False)]


class Sums(Part):
    """The coefficients: of forces along body axes, of moments about the moment reference in body axes."""

    CX: Sum
    CY: Sum
    CZ: Sum
    Cl: Sum
    Cm: Sum
    Cn: Sum


class Terms(Part):
    """The whole of [terms].

    lineage: which of the versions that circulate, and where others differ. reference: of the moments, as a fraction of
    the mean chord, as cg is. beyond: what tables do beyond their ends.
    """

    source: str
    sources: Names = ()
    lineage: str = Field(min_length=1)
    reference: Ratio
    beyond: Literal["hold", "extrapolate"] = "hold"
    axes: Mapping[str, TableAxis]
    signals: Mapping[str, SourceSignal] = Field(default_factory=dict)
    tables: Mapping[str, TableValues]
    sums: Sums

    @field_validator("signals")
    @classmethod
    def _new_names(cls, signals: Mapping[str, SourceSignal]) -> Mapping[str, SourceSignal]:
        twice = next((name for name in signals if name in SIGNALS), None)
        if twice:
            raise ValueError(f"{twice!r} is a signal of FDES already: give that of the source another name")
        return signals

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        for name, table in self.tables.items():
            try:
                sizes = [len(self.axes[known(a, self.axes, "axis of [terms.axes]")].breakpoints) for a in table.axes]
            except ValueError as error:
                raise ValueError(f"table {name!r}: {error}") from None
            rows, columns = sizes if len(sizes) == 2 else (1, *sizes)
            found = [len(row) for row in table.values]
            if found != [columns] * rows:
                needs = f"{rows} x {columns}" if len(sizes) > 1 else f"{columns}"
                has = f"{len(found)} rows of {', '.join(str(n) for n in sorted(set(found)))}"
                raise ValueError(f"table {name!r} needs {needs} values for its axes, and has {has}")
        names = (*SIGNALS, *self.signals)
        for coefficient in FORCES_AND_MOMENTS:
            for term in getattr(self.sums, coefficient):
                try:
                    if term.table is not None:
                        known(term.table, self.tables, "table of [terms.tables]")
                    for signal in term.times:
                        known(signal, names, "signal")
                except ValueError as error:
                    raise ValueError(f"sum {coefficient}: {error}") from None
        used = {t.table for c in FORCES_AND_MOMENTS for t in getattr(self.sums, c)}
        idle = sorted(set(self.tables) - used)
        if idle:
            raise ValueError(f"table {idle[0]!r} is used in no sum: use it, or leave it out")
        return self

    def aero(self, S: Meter2, b: Meter, c: Meter, cg: float) -> TermAero:
        """What flies: in SI, with the center of gravity at `cg` mean chords."""
        axis_numbers = {name: k for k, name in enumerate(self.axes)}
        table_numbers = {name: k for k, name in enumerate(self.tables)}
        return TermAero(
            S=S,
            b=b,
            c=c,
            arm=(self.reference.si("corrected") - cg) * c,
            axes=tuple(self._axis(axis) for axis in self.axes.values()),
            tables=tuple(
                Table(tuple(axis_numbers[a] for a in t.axes), t.values if len(t.axes) > 1 else t.values[0])
                for t in self.tables.values()
            ),
            sums=tuple(
                tuple(self._term(term, table_numbers) for term in getattr(self.sums, coefficient))
                for coefficient in FORCES_AND_MOMENTS
            ),
        )

    def _axis(self, axis: TableAxis) -> SignalAxis:
        breakpoints = tuple(to_si(b, axis.unit) for b in axis.breakpoints)
        sign = -1.0 if axis.reversed else 1.0
        return SignalAxis(
            Axis(breakpoints, held=self.beyond == "hold"), SIGNALS.index(axis.signal), sign, mirrored=axis.mirrored
        )

    def _term(self, term: TermOf, tables: Mapping[str, int]) -> Term:
        gain, factors = term.gain, []
        for name in term.times:
            own = self.signals.get(name)
            gain *= own.gain() if own else 1.0
            factors.append(SIGNALS.index(own.signal if own else name))
        return Term(gain, None if term.table is None else tables[term.table], tuple(factors))
