"""What the examples of docstrings find: the name they use, and a folder for their files."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pforms as pf


@pytest.fixture(autouse=True)
def _surroundings(
    doctest_namespace: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    doctest_namespace["pf"] = pf
    doctest_namespace["np"] = np
    monkeypatch.chdir(tmp_path)
