"""The scripts in examples run as they are, and the notebook gives what it shows.

The notebook's cells are run as plain Python: no Jupyter is needed for that (docs/decisions/0006-documentation-site.md).
What FDES itself draws must be what is stored; figures and other libraries' tables only have to be drawn.
"""

import ast
import contextlib
import io
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import matplotlib as mpl
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
SAYS = {
    "a_pilot_of_your_own.py": "bank at 5 s 15.6 deg, heading at the end 13.9 deg",
    "doublet_to_csv.py": "doublet.csv: pitch rate from -0.124 to 0.204 rad/s",
    "euler_against_exact.py": "euler_against_exact.png",
    "modes_of_the_navion.py": "short_period  -2.5096+2.5919j 1/s  zeta 0.696  period  2.42 s",
}
LEAVES = {
    "a_pilot_of_your_own.py": "banked.fdes",
    "doublet_to_csv.py": "doublet.csv",
    "euler_against_exact.py": "euler_against_exact.png",
}
LARGEST = 300_000  # bytes of a notebook with what it shows


@pytest.mark.parametrize("script", sorted(EXAMPLES.glob("*.py")), ids=lambda script: script.stem)
def test_script(script: Path, tmp_path: Path) -> None:
    run = subprocess.run([sys.executable, script], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert SAYS[script.name] in run.stdout
    left = [path.name for path in tmp_path.iterdir() if path.is_file()]
    assert left == [LEAVES[script.name]] if script.name in LEAVES else not left
    assert len(script.read_text(encoding="utf-8").splitlines()) <= 30


@pytest.mark.parametrize("notebook", sorted(EXAMPLES.glob("*.ipynb")), ids=lambda notebook: notebook.stem)
def test_notebook(notebook: Path) -> None:
    mpl.use("agg")
    names: dict[str, Any] = {}
    text = notebook.read_text(encoding="utf-8")
    cells = [cell for cell in json.loads(text)["cells"] if cell["cell_type"] == "code"]
    assert [cell["execution_count"] for cell in cells] == list(range(1, len(cells) + 1))
    for cell in cells:
        value, printed = run_cell("".join(cell["source"]), names)
        assert printed == "".join("".join(out["text"]) for out in cell["outputs"] if out["output_type"] == "stream")
        if type(value).__module__.startswith("fdes."):
            (stored,) = (out["data"]["text/html"] for out in cell["outputs"])
            assert value._repr_html_() == "".join(stored)
    assert len(text) < LARGEST
    assert not re.search(r"/(home|root|tmp|work|Users)/", text)


def run_cell(source: str, names: dict[str, Any]) -> tuple[Any, str]:
    """Run a cell: the value of its last line, if that is an expression, and what was printed."""
    *body, last = ast.parse(source).body
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        if not isinstance(last, ast.Expr):
            exec(source, names)
            return None, printed.getvalue()
        exec(compile(ast.Module(body, []), "cell", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    return value, printed.getvalue()
