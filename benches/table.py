"""Tables of a run: on the screen, and as a page of the book.

python benches/table.py RESULTS.json PAGE.md    writes the table between the page's two marks
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import Any

Entry = dict[str, Any]
Record = dict[str, Any]

BEGIN, END = "<!-- measured: begin -->", "<!-- measured: end -->"
CACHED = 32e6
"""Bytes: results up to here are written to memory that is used again and stays in the cache."""


def text(record: Record) -> str:
    """Draws the whole run."""
    lines = []
    for (question, variant), entries in grouped(record):
        lines.append(f"{question}, {variant}")
        lines += [f"  {row}" for row in aligned(rows(entries, record))]
        lines.append("")
    return "\n".join(lines)


def line(entry: Entry) -> str:
    """Says in one line how a contender did."""
    who = (
        f"{entry['question']:12} {entry['variant']:28} {entry['contender']:12} ×{entry['threads']}"
    )
    if entry["status"] != "right":
        return f"{who}  {entry['status']}: {entry['note']}"
    return f"{who}  {duration(entry['median'])}  {rate(entry)}"


def grouped(record: Record) -> Iterator[tuple[tuple[str, str], list[Entry]]]:
    def kind(entry: Entry) -> tuple[str, str]:
        return entry["question"], entry["variant"]

    for key, entries in groupby(record["results"], kind):
        yield key, list(entries)


HEAD = ["contender", "threads", "a call", "an item", "rate", "ours is", "of the limit", "error"]


def rows(entries: list[Entry], record: Record) -> list[list[str]]:
    """The table of one question: fastest first, then those without a time."""
    right = [entry for entry in entries if entry["status"] == "right"]
    right.sort(key=per_item)
    body = [row(entry, reference(entries, entry["threads"]), record) for entry in right]
    others = [entry for entry in entries if entry["status"] not in ("right", "missing")]
    notes = [[entry["contender"], str(entry["threads"]), entry["note"]] for entry in others]
    return [HEAD, *body, *notes]


def row(entry: Entry, ours: Entry | None, record: Record) -> list[str]:
    times = f"{per_item(entry) / per_item(ours):.3g} ×" if ours else ""
    return [
        entry["contender"],
        str(entry["threads"]),
        duration(entry["median"]),
        f"{duration(per_item(entry))}/{entry['unit']}",
        rate(entry),
        times if entry is not ours else "",
        limit(entry, record),
        f"{entry['error']:.0e}",
    ]


def reference(entries: list[Entry], threads: int) -> Entry | None:
    """Our fastest answer with as many threads."""
    ours = [e for e in entries if e["contender"].startswith("pforms") and e["threads"] == threads]
    return min((e for e in ours if e["status"] == "right"), key=per_item, default=None)


def per_item(entry: Entry) -> float:
    """Seconds per item."""
    return float(entry["median"] / entry["items"])


def rate(entry: Entry) -> str:
    """Items per second."""
    return f"{1 / per_item(entry):.3g}/s"


def duration(seconds: float) -> str:
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def limit(entry: Entry, record: Record) -> str:
    """Share of the time that the machine's limits alone would take, and which limit counts."""
    limits = record["limits"].get(str(entry["threads"]))
    if not limits or not entry["stored"]:
        return ""
    stores = "stores_again" if entry["stored"] * entry["items"] <= CACHED else "stores"
    needed = {
        "stores": entry["stored"] / limits[stores],
        "arithmetic": entry["operations"] / limits["multiply_add"],
    }
    which = max(needed, key=lambda name: needed[name])
    return f"{needed[which] / per_item(entry):.0%} {which}"


def aligned(cells: list[list[str]]) -> Iterator[str]:
    """Columns of equal width."""
    widths = [max(len(row[k]) for row in cells if len(row) == len(HEAD)) for k in range(len(HEAD))]
    for row in cells:
        yield "  ".join(
            cell.ljust(width) for cell, width in zip(row, widths, strict=False)
        ).rstrip()


def markdown(record: Record) -> str:
    """The run as a section of a page."""
    lines = [f"Measured on {record['machine']['processor']}, {record['machine']['system']}.", ""]
    lines += ["| limit | " + " | ".join(f"{n} threads" for n in record["limits"]) + " |"]
    lines += ["|---|" + "---|" * len(record["limits"])]
    for name in next(iter(record["limits"].values()), {}):
        numbers = [f"{rates[name] / 1e9:.3g}e9/s" for rates in record["limits"].values()]
        lines.append(f"| {name.replace('_', ' ')} | " + " | ".join(numbers) + " |")
    for (question, variant), entries in grouped(record):
        lines += ["", f"### {question}, {variant}", ""]
        head, *body = rows(entries, record)
        lines += ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
        lines += ["| " + " | ".join(row + [""] * (len(head) - len(row))) + " |" for row in body]
    return "\n".join(lines)


def main() -> None:
    results, page = map(Path, sys.argv[1:])
    record = json.loads(results.read_text())
    before, rest = page.read_text().split(BEGIN)
    _, after = rest.split(END)
    page.write_text(f"{before}{BEGIN}\n\n{markdown(record)}\n\n{END}{after}")


if __name__ == "__main__":
    main()
