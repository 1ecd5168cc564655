"""The list that `fdes verify sixdof` prints."""

import json

import pytest
from typer.testing import CliRunner

from fdes.analysis.six_dof_checks import Property, six_dof_properties
from fdes.cli import app
from fdes.physics.earth import Earth

FOUND = list(six_dof_properties())
run = CliRunner().invoke


@pytest.mark.parametrize("p", FOUND, ids=lambda p: p.says)
def test_property(p: Property) -> None:
    assert p.passed, f"{p.found:.3g}, allowed {p.allowed:g}"


def test_a_wrong_sign_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """The J2 term of the level components, turned round, is found by gravity and by the energy of a fall."""

    def wrong(earth: Earth, x: float, y: float, z: float) -> tuple[float, float, float]:
        r2 = x * x + y * y + z * z
        pull = -earth.GM / (r2 * r2**0.5)
        bulge = 1.5 * earth.J2 * earth.a * earth.a / r2
        level = pull * (1.0 + bulge * (5.0 * z * z / r2 - 1.0))
        return level * x, level * y, pull * z * (1.0 - bulge * (5.0 * z * z / r2 - 3.0))

    real = "fdes.physics.plant.gravitation"
    monkeypatch.setattr(real, lambda earth, *r: (0.0, 0.0, earth.g) if earth.g else wrong(earth, *r))
    monkeypatch.setattr("fdes.analysis.six_dof_checks.gravitation", wrong)
    failed = [p.says for p in six_dof_properties() if not p.passed]
    assert any("gradient of its potential" in says for says in failed)
    assert any("energy of a free fall" in says for says in failed)


def test_on_the_command_line() -> None:
    done = run(app, ["verify", "sixdof"])
    assert done.exit_code == 0, done.output
    assert f"{len(FOUND)} properties: {len(FOUND)} hold, 0 do not" in done.stdout
    assert json.loads(run(app, ["verify", "sixdof", "--json"]).stdout)["failed"] == 0
