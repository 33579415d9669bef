"""A preprocessor of mdbook that takes the TeX sources out of formulas that mdbook-katex has set.

A source may have underscores and asterisks, which would be emphasis in Markdown and tear the formula apart.
"""

import json
import re
import sys


def clean(node: object) -> None:
    """Cleans all chapters below a part of a book."""
    if isinstance(node, dict):
        if "content" in node:
            node["content"] = re.sub(r"<annotation .*?</annotation>", "", node["content"], flags=re.DOTALL)
        node = list(node.values())
    if isinstance(node, list):
        for part in node:
            clean(part)


if __name__ == "__main__":
    # mdbook asks first whether a renderer is supported: all are.
    if sys.argv[1:2] != ["supports"]:
        context, book = json.load(sys.stdin)
        clean(book)
        json.dump(book, sys.stdout)
