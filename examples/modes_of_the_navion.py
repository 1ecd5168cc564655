"""The natural modes of the NAVION in three forms of the equations of motion."""

import fdes

navion = fdes.load("NAVION").at("M0.158_SL", variant="printed")
for form in ("paper", "nelson", "full"):
    print(f"\nform {form}")
    for mode in fdes.modes(navion, form=form):
        period = f"period {mode.period:5.2f} s" if mode.period else ""
        print(f"  {mode.name:13} {mode.eigenvalue:+.4f} 1/s  zeta {mode.zeta:5.3f}  {period}")
