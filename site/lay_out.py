"""Lays out the documents as the source of a book: copies of the pages that SUMMARY.md names, and of the files they point to.

Documents stay where code hosts show them, and their places relative to each other are kept, so links need no change. Files
outside docs/ that a page points to, such as scenes and licences, become part of the site. Two things are changed in the copies: blocks
of formulas stand between `$$`, as mdbook-katex reads them, and a README.md is an index.md, as sites have it.
"""

import re
import shutil
import sys
from pathlib import Path

from python_reference import reference

SITE = Path(__file__).resolve().parent
ROOT = SITE.parent
LINK = re.compile(r"\]\(([^)\s]+)\)")
README = re.compile(r"\bREADME\.md(?=#|$)")
API = """
This site has the reference of both crates: [recede](api/recede/index.html), and
[recede-layers](api/recede_layers/index.html), which a crate with layers of its own needs.
"""


def place(path: Path) -> Path:
    """Where a file lies in the book, relative to its top."""
    place = path.relative_to(SITE if path.is_relative_to(SITE) else ROOT)
    return place.with_name("index.md") if place.name == "README.md" else place


def links(text: str) -> list[str]:
    """Files that a text points to, as written, without anchors."""
    targets = (target.split("#")[0] for target in LINK.findall(text))
    return [target for target in targets if target and "://" not in target]


def with_formulas(text: str) -> str:
    """The text with blocks of formulas between `$$`, in paragraphs of their own."""
    lines = []
    fence = None
    for line in text.splitlines():
        if fence is None and line.startswith("```"):
            fence = "$$" if line == "```math" else "```"
            lines.append("\n$$" if fence == "$$" else line)
        elif fence is not None and line == "```":
            lines.append("$$\n" if fence == "$$" else line)
            fence = None
        else:
            lines.append(line)
    return "\n".join(lines) + "\n"


def with_links(text: str, page: Path) -> str:
    """The text with links as they are in the book; those of a page of site/ count from the top there."""

    def moved(link: re.Match) -> str:
        target = link[1].removeprefix("../") if page.is_relative_to(SITE) else link[1]
        return f"]({re.sub(README, 'index.md', target)})"

    return LINK.sub(moved, text)


def main(book: Path, with_api: bool) -> None:
    shutil.rmtree(book, ignore_errors=True)
    book.mkdir(parents=True)
    summary = SITE / "SUMMARY.md"
    pages = [(SITE / link).resolve() for link in links(summary.read_text(encoding="utf-8"))]
    forgotten = set((ROOT / "docs").rglob("*.md")) - set(pages)
    if forgotten:
        sys.exit(f"site/SUMMARY.md does not name {', '.join(str(place(page)) for page in sorted(forgotten))}")
    files = set()
    for page in [summary, *pages]:
        text = page.read_text(encoding="utf-8")
        found = {(page.parent / link).resolve() for link in links(text)} - set(pages)
        files |= {file for file in found if file.is_file()}
        text = with_formulas(with_links(text, page))
        if with_api and page == SITE / "api.md":
            text += API
        if page == SITE / "python_reference.md":
            text += "\n" + reference()
        copy = book / place(page)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(text, encoding="utf-8")
    files |= set((SITE / "katex").rglob("*.woff2")) | {SITE / "katex/LICENSE"}
    for file in files:
        copy = book / place(file)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, copy)


if __name__ == "__main__":
    main(Path(sys.argv[1]), "--api" in sys.argv[2:])
