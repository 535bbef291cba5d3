"""What the examples of docstrings find: the name they use, and a folder for their files."""

from pathlib import Path
from typing import Any

import pytest

import pforms as pf


@pytest.fixture(autouse=True)
def _surroundings(
    doctest_namespace: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    doctest_namespace["pf"] = pf
    monkeypatch.chdir(tmp_path)
