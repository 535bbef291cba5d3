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
    """The run as sections of a page: a table for each question."""
    lines = [*machine(record), ""]
    for question, entries in groupby(record["results"], lambda entry: str(entry["question"])):
        table = list(entries)
        unit = next((entry["unit"] for entry in table if "unit" in entry), "item")
        lines += [f"### {question}", "", record["titles"].get(question, ""), ""]
        lines += [*cells(matrix(table, record, f"{unit}s per second, or time")), ""]
    return "\n".join(lines)


def machine(record: Record) -> Iterator[str]:
    """What was measured, and the machine's limits."""
    about, limits = record["machine"], record["limits"]
    yield f"pforms {about['commit']} on {about['processor']}, {about['threads']} processors, "
    yield f"{about['system']}, Python {about['python']}."
    if limits:
        names = list(next(iter(limits.values())))
        head = ["at most", *(plural(int(threads), "thread") for threads in limits)]
        body = [[name.replace("_", " "), *(si(limits[t][name]) for t in limits)] for name in names]
        yield from ["", *cells([head, *body])]


def matrix(entries: list[Entry], record: Record, corner: str) -> list[list[str]]:
    """Contenders by variants, or variants by contenders when there are many."""
    variants = list(dict.fromkeys(entry["variant"] for entry in entries))
    who = list(dict.fromkeys((entry["contender"], entry["threads"]) for entry in entries))
    places = {(e["variant"], e["contender"], e["threads"]): e for e in entries}
    names = [name + (f", {plural(n, 'thread')}" if n > 1 else "") for name, n in who]
    rows = [[corner, *variants]]
    for name, (contender, threads) in zip(names, who, strict=True):
        found = [places.get((variant, contender, threads)) for variant in variants]
        if any(entry and entry["status"] != "missing" for entry in found):
            rows.append([name, *(cell(entry, entries, record) for entry in found)])
    return rows if len(variants) <= 4 else [list(row) for row in zip(*rows, strict=True)]


def cell(entry: Entry | None, entries: list[Entry], record: Record) -> str:
    """A rate; for peers how many times faster we are, for us the share of the limit."""
    if entry is None or entry["status"] != "right":
        return entry["status"] if entry else ""
    same = [e for e in entries if e["variant"] == entry["variant"]]
    ours = reference(same, entry["threads"])
    share = limit(entry, record) if entry["contender"].startswith("pforms") else ""
    times = f"{per_item(entry) / per_item(ours):.3g} ×" if ours and entry is not ours else ""
    note = ", ".join(part for part in (times, share) if part)
    seconds = per_item(entry)
    speed = duration(seconds) if seconds > 1e-3 else si(1 / seconds)
    return speed + (f" ({note})" if note else "")


def plural(count: int, noun: str) -> str:
    return f"{count} {noun}" + ("s" if count > 1 else "")


def si(number: float) -> str:
    """A number with the prefix of its size."""
    for prefix, size in (("G", 1e9), ("M", 1e6), ("k", 1e3)):
        if number >= size:
            return f"{number / size:.3g} {prefix}"
    return f"{number:.3g}"


def cells(rows: list[list[str]]) -> Iterator[str]:
    """A table in Markdown."""
    head, *body = rows
    yield "| " + " | ".join(head) + " |"
    yield "|" + "---|" * len(head)
    for row in body:
        yield "| " + " | ".join(row) + " |"


def main() -> None:
    results, page = map(Path, sys.argv[1:])
    record = json.loads(results.read_text())
    before, rest = page.read_text().split(BEGIN)
    _, after = rest.split(END)
    page.write_text(f"{before}{BEGIN}\n\n{markdown(record)}\n\n{END}{after}")


if __name__ == "__main__":
    main()
