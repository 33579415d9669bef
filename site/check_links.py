"""Checks that what the pages of a site point to is there: files, and anchors in pages. Other sites are not asked.

The reference in api/ is pointed to, but its own links are checked by rustdoc, and some of its anchors are made by scripts.
"""

import re
import sys
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """The anchors of a page, and what it points to."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.anchors = {"", "top"}
        self.links: list[tuple[int, str]] = []
        self.is_at_top = False
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        for name, value in attributes:
            if value is None:
                continue
            if tag == "base":
                self.is_at_top |= name == "href"
            elif name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif name in ("href", "src", "data", "poster"):
                self.links.append((self.getpos()[0], value))


@cache
def page(path: Path) -> Page:
    return Page(path.read_text(encoding="utf-8"))


def mistakes(top: Path, path: Path) -> list[str]:
    """What is wrong with the links of a page or of a style sheet."""
    if path.suffix == ".html":
        folder = top if page(path).is_at_top else path.parent
        links = page(path).links
    else:
        folder = path.parent
        text = path.read_text(encoding="utf-8")
        urls = re.finditer(r"url\(\s*['\"]?([^)'\"]+)", text)
        links = [(text.count("\n", 0, url.start()) + 1, url[1]) for url in urls]
    found = []
    for line, link in links:
        parts = urlsplit(link)
        if parts.scheme or parts.netloc:
            continue
        file = unquote(parts.path)
        target = top / file.lstrip("/") if file.startswith("/") else folder / file if file else path
        if target.is_dir():
            target /= "index.html"
        name = f"{path.relative_to(top)}:{line}: {link}"
        if not target.is_file():
            found.append(f"{name}: no such file")
        elif parts.fragment and target.suffix == ".html":
            if unquote(parts.fragment) not in page(target.resolve()).anchors:
                found.append(f"{name}: no such anchor")
    return found


def main(top: Path) -> None:
    paths = [path for path in sorted(top.rglob("*")) if path.suffix in (".html", ".css")]
    paths = [path for path in paths if path.relative_to(top).parts[0] != "api"]
    found = [mistake for path in paths for mistake in mistakes(top, path)]
    for mistake in found:
        print(mistake, file=sys.stderr)
    if found or not paths:
        sys.exit(f"{len(found)} broken links on {len(paths)} pages")
    print(f"no broken links on {len(paths)} pages and style sheets")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
