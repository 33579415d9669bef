"""The reference of the Python package as a page: classes, functions and their docstrings, read from its sources without running them."""

import ast
import inspect
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent.parent / "python" / "recede"
# titles and files, in the order of the page
PARTS = [
    ("Scenes, models and solutions", "_recede.pyi"),
    ("Stacks and layers of your own", "_text.py"),
    ("Many solutions", "_solutions.py"),
    ("Sweeps", "_sweep.py"),
    ("Tables", "_table.py"),
    ("Errors and warnings", "_errors.py"),
    ("What all items have", "_items.py"),
    ("Units", "_values.py"),
    ("Layers, interfaces, bases, punches and loads", "items.py"),
    ("Moduli as functions of depth", "profiles.py"),
]


def exported() -> set[str]:
    """The names that the package shows, but for those of items."""
    tree = ast.parse((PACKAGE / "__init__.py").read_text(encoding="utf-8"))
    names = [name for node in tree.body if isinstance(node, ast.ImportFrom) for name in node.names]
    return {name.asname for name in names if name.asname}


def signature(node: ast.FunctionDef) -> str:
    """A function's head, without `self`."""
    arguments = ast.unparse(node.args).removeprefix("self, ").removeprefix("cls, ")
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    return f"{node.name}({'' if arguments in ('self', 'cls') else arguments}){returns}"


def prose(text: str) -> str:
    """A docstring: what follows `Args:` and the like as a list."""
    lines = []
    for line in inspect.cleandoc(text).splitlines():
        name, _, rest = line.strip().partition(": ")
        if line.startswith("    ") and not line.startswith("     ") and rest:
            line = f"* `{name}`: {rest}"
        elif line.endswith(":") and not line.startswith(" "):
            line = f"\n{line}\n"
        lines.append(line.strip() if line.startswith("     ") else line)
    return "\n".join(lines).replace("<", "&lt;")


def of_class(node: ast.ClassDef) -> list[str]:
    """A class with what it has."""
    page = [f"### {node.name}", prose(ast.get_docstring(node) or "")]
    functions = [each for each in node.body if isinstance(each, ast.FunctionDef) and not each.name.startswith("_")]
    overloads: list[str] = []
    for each in functions:
        is_property = any(ast.unparse(decorator) == "property" for decorator in each.decorator_list)
        overloads.append(each.name if is_property else signature(each))
        text = ast.get_docstring(each)
        if text:
            page.append("<br>".join(f"`{one}`" for one in overloads) + "\n\n" + prose(text))
            overloads = []
    return page


def reference() -> str:
    """The page below its first paragraph."""
    names, page = exported(), []
    for title, file in PARTS:
        page.append(f"## {title}")
        for node in ast.parse((PACKAGE / file).read_text(encoding="utf-8")).body:
            shown = file in ("items.py", "profiles.py") or getattr(node, "name", None) in names
            if isinstance(node, ast.ClassDef) and shown:
                page += of_class(node)
            elif isinstance(node, ast.FunctionDef) and shown and ast.get_docstring(node):
                page += [f"### {node.name}", f"`{signature(node)}`", prose(ast.get_docstring(node) or "")]
    return "\n\n".join(page) + "\n"
