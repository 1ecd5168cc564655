"""Which form of the linear equations meets published modes best: the measure behind the default."""

import statistics
from collections import defaultdict

from fdes.analysis.verify import checks
from fdes.physics.derivatives import FORMS, Form
from fdes.sources import sources


def form_errors() -> dict[str, dict[Form, tuple[float, float, float]]]:
    """Median, mean and largest relative error of each form against the modes of each source; ``all`` is all of them.

    Used is what a source prints of a mode (parts of an eigenvalue, or zeta and omega_n) for an aircraft whose
    nondimensional derivatives FDES has, where it is not known to be incomparable or misprinted.
    """
    found: dict[str, dict[Form, list[float]]] = defaultdict(lambda: defaultdict(list))
    for name, source in sources().items():
        items = [item for item in source.get("modes", []) if _counts(item)]
        for form in FORMS:
            remade = {"citation": source["citation"], "modes": [{**item, "form": form} for item in items]}
            for check in checks({name: remade}) if items else ():
                if check.tolerance is not None and not check.note and check.published:
                    found[name][form].append(check.error)
                    found["all"][form].append(check.error)
    return {
        name: {form: (statistics.median(e), statistics.fmean(e), max(e)) for form, e in forms.items()}
        for name, forms in found.items()
    }


def _counts(item: dict[str, object]) -> bool:
    """Whether each form can be held against the item: not those about a form's own shortcoming or other inertias."""
    from fdes.aircraft import load

    condition = load(str(item["aircraft"])).at(str(item["condition"]))
    return condition.nondimensional and "no_check" not in item and "reference" not in item
