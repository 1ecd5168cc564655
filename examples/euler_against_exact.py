"""Figures 8, 10 and 11 of Mansor and Perumal: what a step of the integrator does to a step of the aileron."""

import sys

from matplotlib.figure import Figure

import fdes
from fdes.flight import Clock

target = sys.argv[1] if len(sys.argv) > 1 else "euler_against_exact.png"
a4d = fdes.load("A-4D").at("M0.4_SL", variant="printed")
figure = Figure(figsize=(7.0, 3.6), layout="constrained")
axes = figure.subplots()
lines = (("euler", 0.1, "-"), ("euler", 0.04, "-"), ("kutta_merson", 0.1, "o"), ("exact", 0.01, "-"))
for integrator, dt, line in lines:
    clock = Clock(dt, duration=6.0)
    flight = fdes.simulate(a4d, ["step aileron 0.2618rad"], clock=clock, form="paper", integrator=integrator)
    axes.plot(flight["t"], flight["p"], line, linewidth=1.2, markersize=3, label=f"{integrator}, {dt:g} s")
axes.set(xlabel="t [s]", ylabel="p, roll rate [rad/s]", title="A-4D, Mach 0.4: 15 degrees of aileron", xlim=(0, 6))
axes.grid(alpha=0.3)
axes.legend()
figure.savefig(target)
print(target)
