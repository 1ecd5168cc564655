"""`fdes shelves`: the parts that can be named, and that anybody may add to."""

from fdes.cli.options import AsJson


def shelves(json: AsJson = False) -> None:
    """Integrators, control laws, inputs and criteria by name. One file each: CONTRIBUTING.md says how to add one.

    Of a law its settings with their units too: what `--law "NAME SETTING=VALUE"` says.
    """
    from fdes.cli.output import print_json, screen
    from fdes.shelf import SHELVES, shelf

    parts = {name: shelf(name).names() for name in SHELVES}
    if json:
        print_json(parts | {"settings_of_laws": {law: _settings(law) for law in parts["laws"]}})
        return
    from rich.table import Table
    from rich.text import Text

    show = screen()
    for name, names in parts.items():
        grid = Table.grid(padding=(0, 2))
        for part in names:
            grid.add_row(f"  {part}", _said_of(name, part))
            if name == "laws" and (settings := _settings(part)):
                grid.add_row("", Text(", ".join(f"{field} [{unit}]" for field, unit in settings.items()), "dim"))
        show.print(name, style="bold")
        show.print(grid)


def _settings(law: str) -> dict[str, str]:
    """The settings of a law of the shelf, with their units."""
    from fdes.control.spoken import units_of
    from fdes.shelf import shelf

    return units_of(shelf("laws").get(law))


def _said_of(shelf_name: str, part: str) -> str:
    """The first line of the part's file."""
    from importlib import import_module
    from importlib.util import find_spec

    from fdes.shelf import SHELVES

    module = f"{SHELVES[shelf_name]}.{part}"
    if find_spec(module) is None:
        return "from another distribution"
    return (import_module(module).__doc__ or "").partition("\n")[0]
