"""What a notebook shows of a mode and of a flight."""

import numpy as np

import fdes
from fdes.flight import Clock
from fdes.flight.recording import Recording
from fdes.physics.signals import Channel

NAVION = fdes.load("NAVION").at(variant="printed")


def test_a_mode_shows_what_applies_to_it() -> None:
    short_period, *_, spiral = fdes.modes(NAVION, form="nelson")
    shown = short_period._repr_html_()
    assert "<caption>short period, longitudinal: u " in shown
    assert "-2.51 ± 2.592i rad/s" in shown
    assert "<th>period</th><td>2.424 s</td>" in shown
    assert "<th>period</th>" not in spiral._repr_html_()


def test_a_recording_shows_what_moved_and_how_far() -> None:
    flight = fdes.simulate(NAVION, initial=["beta=5deg"], clock=Clock(0.01, duration=1.0))
    shown = flight._repr_html_()
    assert "NAVION M0.158_SL: 101 rows, 0 to 1 s; " in shown
    assert repr(flight) == "<Recording NAVION M0.158_SL: 101 rows, 0 to 1 s>"
    assert "<td>beta</td><td>rad</td>" in shown
    assert "<td>elevator</td>" not in shown


def test_a_recording_that_was_cut_off_says_so_and_names_are_escaped() -> None:
    time = (Channel("t", "s", "time"),)
    shown = Recording({"aircraft": "<mine>"}, time, np.empty((0, 1)), (), complete=False)._repr_html_()
    assert "&lt;mine&gt;: no rows" in shown
    assert "its end is missing" in shown
