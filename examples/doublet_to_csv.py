"""The response of the A-4D to a doublet on its elevator, as a CSV file with the unit of every column."""

import sys
from pathlib import Path

import fdes
from fdes.flight import Clock

target = Path(sys.argv[1] if len(sys.argv) > 1 else "doublet.csv")
a4d = fdes.load("A-4D").at("M0.4_SL")
flight = fdes.simulate(a4d, ["doublet elevator 2deg at 1s for 2s"], clock=Clock(0.01, duration=10.0))
with target.open("w", encoding="utf-8", newline="\n") as file:
    flight.to_csv(file)
print(f"{target}: pitch rate from {flight['q'].min():.3f} to {flight['q'].max():.3f} rad/s")
