"""What the manual needs beyond Markdown.

The order of its chapters; the reference at the end of an operator's page; and formulas without a
script. A formula is written as GitHub reads it, ``$`…`$`` in a line or a fence named ``math``, and
becomes MathML, which browsers draw by themselves.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

from latex2mathml.converter import convert
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.pages import Page

HERE = Path(__file__).parent
sys.path.append(str(HERE))

import reference  # noqa: E402 (it lies beside this file, which MkDocs loads by its path)

CATALOGUE = HERE.parent / ".tools" / "book" / "operators.json"

# Pages and chapters in reading order; a chapter is a folder, its pages in alphabetical order.
CHAPTERS = {
    "index.md": "pforms",
    "start.md": "Start",
    "forms.md": "Forms",
    "splines.md": "Splines",
    "operators": "Operators",
    "formulas.md": "Formulas",
    "sheet.md": "Sheet",
    "studio.md": "Studio",
    "python.md": "Python",
    "command-line.md": "Command line",
    "formats.md": "Formats",
    "tessellating.md": "Tessellating",
    "speed.md": "Speed",
    "decisions": "Decisions",
}

FENCE = re.compile(r"^```math\n(.*?)^```$", re.DOTALL | re.MULTILINE)
INLINE = re.compile(r"\$`([^`]+)`\$")

# While Markdown is read, a formula is a number between two characters that no page uses: Markdown
# would take a line that begins with `<math>` for a paragraph of its own.
MARK = re.compile("\ue000(\\d+)\ue001")
formulas: list[str] = []


def chapter(docs: Path, name: str) -> list[str]:
    """Addresses of a chapter's pages: its index first, the others by name."""
    pages = sorted(page.name for page in (docs / name).glob("*.md"))
    pages.sort(key=lambda page: page != "index.md")
    return [f"{name}/{page}" for page in pages]


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """Puts the chapters that exist in order; other pages follow by name."""
    docs = Path(config["docs_dir"])
    others = sorted(page.name for page in docs.glob("*.md") if page.name not in CHAPTERS)
    nav: list[object] = []
    for name, title in CHAPTERS.items():
        if name.endswith(".md") and (docs / name).exists():
            nav.append({title: name})
        elif pages := chapter(docs, name):
            nav.append({title: pages})
    config["nav"] = nav + others
    return config


def put_by(latex: str, display: str) -> str:
    """Keeps a formula as MathML and returns its mark."""
    formulas.append(convert(latex.strip(), display=display))
    return f"\ue000{len(formulas) - 1}\ue001"


def on_page_markdown(markdown: str, page: Page, **_: object) -> str:
    """Adds what the catalogue says, and puts formulas by."""
    folder, _, name = page.file.src_uri.removesuffix(".md").rpartition("/")
    if folder == "operators":
        markdown += from_catalogue(name)
    formulas.clear()
    blocks = FENCE.sub(lambda found: put_by(found[1], "block"), markdown)
    return INLINE.sub(lambda found: put_by(found[1], "inline"), blocks)


def from_catalogue(name: str) -> str:
    """Writes the reference of an operator, or of a group that shares a page."""
    entries = reference.load(CATALOGUE)
    pages = {page.stem for page in (HERE / "src" / "operators").glob("*.md")}
    for entry in entries:
        if entry["name"] == name:
            return "\n" + reference.section(entry, pages)
    group = [entry for entry in entries if entry["group"] == name]
    return "\n" + reference.group(group) if group else ""


def on_page_content(html: str, **_: object) -> str:
    """Puts the formulas back in."""
    return MARK.sub(lambda found: formulas[int(found[1])], html)
