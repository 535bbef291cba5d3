"""The machine a run was made on: what it is, and what it can do at most."""

from __future__ import annotations

import importlib.metadata
import json
import os
import platform
import subprocess
from collections.abc import Iterable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
PACKAGES = {"occt": "cadquery-ocp"}
"""Peers whose package has another name."""


def description(peers: Iterable[str]) -> dict[str, Any]:
    """Processor, system, and the versions of the peers."""
    return {
        "processor": processor(),
        "threads": os.cpu_count(),
        "system": f"{platform.system()} on {platform.machine()}",
        "python": platform.python_version(),
        "commit": commit(),
        "versions": {peer: version(PACKAGES.get(peer, peer)) for peer in peers},
    }


def processor() -> str:
    """The processor's name and vector instructions."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor()
    facts = dict(line.split(":", 1) for line in reversed(lines) if ":" in line)
    facts = {name.strip(): value.strip() for name, value in facts.items()}
    vectors = [
        flag for flag in ("avx2", "fma", "avx512f") if flag in facts.get("flags", "").split()
    ]
    family = f"family {facts.get('cpu family')} model {facts.get('model')}"
    return f"{facts.get('model name', platform.machine())} ({family}; {', '.join(vectors)})"


def version(package: str) -> str | None:
    """Version of an installed package."""
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return None


def commit() -> str:
    """Which pforms this is."""
    command = ["git", "-C", str(ROOT), "describe", "--always", "--dirty"]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()


def limits() -> dict[str, dict[str, float]]:
    """Highest rates by number of threads, measured by `native/limits.rs`; none without a compiler.

    Bytes per second for stores, operations per second for multiplications and additions.
    """
    command = ["cargo", "run", "--quiet", "--locked", "--release", "--package", "pforms-benches"]
    try:
        run = subprocess.run(
            [*command, "--bin", "limits"], cwd=ROOT, capture_output=True, text=True, check=True
        )
    except (OSError, subprocess.CalledProcessError) as reason:
        print(f"bench: without limits ({reason})")
        return {}
    measured: dict[str, dict[str, float]] = json.loads(run.stdout)
    return measured
