"""The Python examples of the manual, run: every fence marked `python`."""

import re
import textwrap
from pathlib import Path

import pytest

SOURCES = Path(__file__).parent.parent / "src"
FENCE = re.compile(r"^([ ]*)```python\n(.*?)^\1```$", re.DOTALL | re.MULTILINE)


def examples():
    for page in sorted(SOURCES.rglob("*.md")):
        for number, fence in enumerate(FENCE.finditer(page.read_text())):
            name = f"{page.relative_to(SOURCES)}:{number}"
            yield pytest.param(textwrap.dedent(fence[2]), id=name)


@pytest.mark.parametrize("code", list(examples()))
def test_example_runs(code, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    exec(compile(code, "example", "exec"), {})
