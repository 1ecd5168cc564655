"""User settings: what the commands take for granted where nothing else is said.

One TOML file, a table per command, a key per option as ``--help`` names it:

    [fly]
    aircraft = "NAVION"
    port = 9000

    [simulate]
    units = "us"

What is said on the command line goes before it. FDES_SETTINGS names another file.
"""

import os
import tomllib
from pathlib import Path
from typing import Any

import typer

from fdes.cli.options import AsJson
from fdes.errors import SpecError, nearest

NOT_A_SETTING = {"help", "json", "inputs", "out"}


def settings_file() -> Path:
    """Where the settings are: FDES_SETTINGS, else in the platform's folder for configuration."""
    named = os.environ.get("FDES_SETTINGS")
    if named:
        return Path(named)
    from platformdirs import user_config_path

    return user_config_path("fdes", appauthor=False) / "settings.toml"


def read_settings(path: Path, commands: dict[str, list[str]]) -> dict[str, dict[str, Any]]:
    """The settings in `path`, checked against the options of each of `commands`; none where there is no file.

    Raises SpecError for what cannot be read, and for a command or an option that does not exist.
    """
    try:
        found = tomllib.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}
    except (OSError, UnicodeDecodeError) as trouble:
        raise SpecError(f"The settings in {path} cannot be read: {trouble}.") from trouble
    except tomllib.TOMLDecodeError as trouble:
        raise SpecError(f"The settings in {path} are not TOML: {trouble}.") from trouble
    for command, options in found.items():
        if command not in commands or not isinstance(options, dict):
            raise SpecError(_unknown(path, "command", command, commands))
        for option in options:
            if option not in commands[command]:
                raise SpecError(_unknown(path, f"option of {command}", option, commands[command]))
    return found


def _unknown(path: Path, kind: str, name: str, known: Any) -> str:
    near = nearest(name, known)
    hint = f" Did you mean {near!r}?" if near else ""
    return f"The settings in {path} name {name!r}, which is no {kind}.{hint} Known: {', '.join(sorted(known))}."


def settings(ctx: typer.Context, json: AsJson = False) -> None:
    """Where your settings are, and what they say."""
    from fdes.cli.output import print_json, screen

    path, found = settings_file(), ctx.find_root().default_map or {}
    if json:
        print_json({"path": str(path), "settings": found})
        return
    show = screen()
    show.print(str(path), soft_wrap=True)
    if not found:
        show.print('There are none. Write a table per command there, such as\n\n[fly]\naircraft = "NAVION"')
    for command, options in found.items():
        show.print(f"\n[{command}]")
        for option, value in options.items():
            show.print(f"{option} = {value!r}")
