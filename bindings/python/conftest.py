"""Names that the examples of docstrings may use."""

from typing import Any

import pytest

import pforms as pf


@pytest.fixture(autouse=True)
def _names(doctest_namespace: dict[str, Any]) -> None:
    doctest_namespace["pf"] = pf
