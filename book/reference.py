"""The part of the manual that the catalogue writes: how each operator is called."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TypedDict


class Words(TypedDict):
    """A text in both languages."""

    en: str
    fr: str


class Range(TypedDict):
    """What numbers are allowed; None where there is no bound."""

    least: float | None
    most: float | None


class Parameter(TypedDict):
    """What an operator takes."""

    name: Words
    takes: str
    default: str | None
    variadic: bool
    range: Range | None
    choices: list[Words]
    help: Words


class Entry(TypedDict):
    """An operator, as `pforms operators --json` describes it."""

    name: str
    english: list[str]
    french: list[str]
    group: str
    summary: Words
    help: Words
    parameters: list[Parameter]
    gives: str
    example: str
    see: list[str]
    exact: bool


def load(path: Path) -> list[Entry]:
    """Reads what `make book` has asked the command line for."""
    entries: list[Entry] = json.loads(path.read_text())
    return entries


def section(entry: Entry, pages: set[str]) -> str:
    """Says how one operator is called: the end of its page."""
    see = [f"[{name}]({name}.md)" if name in pages else f"`{name}`" for name in entry["see"]]
    lines = [
        "## Reference",
        "",
        f"`{signature(entry)}`",
        "",
        entry["help"]["en"],
        "",
        *table(entry),
        f"Gives: {entry['gives']}. "
        + ("Works in exact mode." if entry["exact"] else "Floating point only."),
        "",
        f"Example: `{entry['example']}`",
        "",
    ]
    if see:
        lines += ["See " + ", ".join(see) + ".", ""]
    return "\n".join(lines)


def group(entries: list[Entry]) -> str:
    """Lists operators that share a page."""
    lines = ["| formula | French | | example |", "| --- | --- | --- | --- |"]
    for entry in entries:
        french = ", ".join(f"`{name}`" for name in entry["french"])
        lines.append(
            f"| `{signature(entry)}` | {french} | {cell(entry['summary']['en'])} "
            f"| `{cell(entry['example'])}` |"
        )
    return "\n".join([*lines, ""])


def signature(entry: Entry) -> str:
    """Writes a call with its parameters; what may be left out stands in brackets."""
    return f"{entry['english'][0]}({', '.join(map(argument, entry['parameters']))})"


def argument(parameter: Parameter) -> str:
    """Writes one parameter of a call."""
    text = parameter["name"]["en"] + (", …" if parameter["variadic"] else "")
    return text if parameter["default"] is None else f"[{text}]"


def table(entry: Entry) -> list[str]:
    """Tells what each parameter is."""
    if not entry["parameters"]:
        return []
    rows = ["| parameter | takes | | |", "| --- | --- | --- | --- |"]
    for parameter in entry["parameters"]:
        name = f"`{parameter['name']['en']}`"
        rows.append(
            f"| {name} | {parameter['takes']} | {cell(parameter['help']['en'])} "
            f"| {cell(bounds(parameter))} |"
        )
    return [*rows, ""]


def bounds(parameter: Parameter) -> str:
    """Says what is allowed, and what is meant when nothing is said."""
    parts = []
    if parameter["range"] is not None:
        least, most = parameter["range"]["least"], parameter["range"]["most"]
        low = "" if least is None else f"from {least:.10g}"
        high = "" if most is None else f"to {most:.10g}"
        parts.append(f"{low} {high}".strip())
    if parameter["choices"]:
        parts.append(", ".join(f"`{choice['en']}`" for choice in parameter["choices"]))
    if parameter["default"] is not None:
        parts.append(f"else `{parameter['default']}`")
    return "; ".join(parts)


def cell(text: str) -> str:
    """Keeps a text from breaking a table."""
    return text.replace("|", "\\|").replace("\n", " ")
