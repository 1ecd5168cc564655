"""The default form is the one that meets published modes best; the guide prints the errors that are computed."""

import inspect
import re
from pathlib import Path

from fdes.analysis import modes
from fdes.analysis.form_comparison import form_errors
from fdes.physics.derivatives import FORMS

GUIDE = Path(__file__).parents[2] / "docs" / "guide" / "3-derivatives-and-forms.md"


def test_the_default_form_has_the_smallest_mean_error_over_all_sources() -> None:
    mean = {form: error for form, (_, error, _) in form_errors()["all"].items()}
    assert min(mean, key=lambda form: mean[form]) == inspect.signature(modes).parameters["form"].default


def test_the_guide_prints_these_errors() -> None:
    text = GUIDE.read_text(encoding="utf-8")
    for source, row in (("nelson_1998", "Nelson"), ("heffley_jewell_1972", "Heffley"), ("all", "all")):
        (line,) = re.findall(rf"^\| {row}.*%.*$", text, re.MULTILINE)
        errors = form_errors()[source]
        cells = [
            f"{100 * mean:.1f} %, {100 * largest:.{1 if largest < 0.1 else 0}f} %"
            for _, mean, largest in map(errors.__getitem__, FORMS)
        ]
        assert [cell.strip() for cell in line.split("|")[2:5]] == cells
