"""`fdes shelves`: the parts that can be named, and that anybody may add to."""

from fdes.cli.options import AsJson


def shelves(json: AsJson = False) -> None:
    """Integrators, control laws, inputs and criteria by name. One file each: CONTRIBUTING.md says how to add one."""
    from fdes.cli.output import print_json, screen
    from fdes.shelf import SHELVES, shelf

    parts = {name: shelf(name).names() for name in SHELVES}
    if json:
        print_json(parts)
        return
    from rich.table import Table

    show = screen()
    for name, names in parts.items():
        grid = Table.grid(padding=(0, 2))
        for part in names:
            grid.add_row(f"  {part}", _said_of(name, part))
        show.print(name, style="bold")
        show.print(grid)


def _said_of(shelf_name: str, part: str) -> str:
    """The first line of the part's file."""
    from importlib import import_module
    from importlib.util import find_spec

    from fdes.shelf import SHELVES

    module = f"{SHELVES[shelf_name]}.{part}"
    if find_spec(module) is None:
        return "from another distribution"
    return (import_module(module).__doc__ or "").partition("\n")[0]
