"""Checks the built book: python3 ci/book_links.py target/book.

Every link and picture of every page leads to a file of the book, every `#place` to an element there. Links to the net are not followed.
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """What a page points to, and the places that it has."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.targets: list[str] = []
        self.places: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            if value is None:
                continue
            if name == "id" or (tag == "a" and name == "name"):
                self.places.add(value)
            elif (tag, name) in {("a", "href"), ("img", "src"), ("link", "href"), ("script", "src")}:
                self.targets.append(value)


def main() -> int:
    book = Path(sys.argv[1]).resolve()
    # The page for printing holds all others again.
    left_out = {"print.html", "404.html", "toc.html"}
    pages = {path: Page(path.read_text()) for path in sorted(book.rglob("*.html")) if path.name not in left_out}
    dead, checked = [], 0
    for path, page in pages.items():
        for target in page.targets:
            parts = urlsplit(target)
            if parts.scheme or parts.netloc:
                continue
            checked += 1
            to = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not to.is_file() or book not in to.parents:
                dead.append(f"{path.relative_to(book)}: {target}: no such file in the book")
            elif parts.fragment and to in pages and unquote(parts.fragment) not in pages[to].places:
                dead.append(f"{path.relative_to(book)}: {target}: no such place in that page")
    print(*dead, sep="\n", end="\n" if dead else "")
    print(f"book: {len(pages)} pages, {checked} links within it checked, {len(dead)} dead")
    return 1 if dead or checked < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
