"""Writes the reference of the command line from the commands themselves, so that it cannot say anything else.

A line such as `<!-- fdes simulate -->` becomes what that command knows, and `<!-- fdes, the rest -->` a section for
each command that the page does not mention.
"""

import re
from collections.abc import Iterator
from typing import Any

import typer.main

from fdes.cli import app

PLACE = re.compile(r"^<!-- fdes ([a-z ]+) -->$", re.MULTILINE)
REST = "<!-- fdes, the rest -->"


def on_page_markdown(markdown: str, **_: Any) -> str:
    """MkDocs calls this for each page."""
    if REST not in markdown:
        return markdown
    commands = dict(all_commands(typer.main.get_command(app)))
    rest = [name for name in commands if f"<!-- fdes {name} -->" not in markdown]
    markdown = markdown.replace(REST, "\n\n".join(f"## fdes {name}\n\n<!-- fdes {name} -->" for name in rest))
    return PLACE.sub(lambda place: described(commands[place[1]]), markdown)


def all_commands(group: Any, before: str = "") -> Iterator[tuple[str, Any]]:
    """All commands by the words that call them; of a group its commands."""
    for name, command in group.commands.items():
        if hasattr(command, "commands"):
            yield from all_commands(command, f"{before}{name} ")
        else:
            yield before + name, command


def described(command: Any) -> str:
    """What a command does, its arguments and options, and its example, as Markdown."""
    lines = [command.help, "", "| argument or option | what it says | usually |", "|---|---|---|"]
    lines += [f"| {spelled(p)} | {escaped(p.help or '')} | {usual(p)} |" for p in command.params]
    if command.epilog:
        lines += ["", command.epilog.replace("Example: ", "Example: `", 1) + "`"]
    return "\n".join(lines if command.params else [command.help, *lines[4:]])


def spelled(parameter: Any) -> str:
    """How it is written: `AIRCRAFT`, or `--condition ID`."""
    if parameter.param_type_name == "argument":
        return f"`{parameter.metavar or parameter.name.upper()}`"
    names = ", ".join(f"`{name}`" for name in (*parameter.opts, *parameter.secondary_opts))
    what = (parameter.metavar or "").strip()
    return f"{names} {escaped(what)}".strip()


def usual(parameter: Any) -> str:
    """The value that it has when nothing is said."""
    if parameter.required:
        return "must be given"
    value = parameter.default
    return f"`{value}`" if isinstance(value, str | float | int) and not isinstance(value, bool) else ""


def escaped(text: str) -> str:
    """Text that may stand in a cell of a table."""
    return text.replace("|", r"\|")
