"""Writes recede/items.py and recede/profiles.py, a class for everything that may be written in a scene, from the JSON Schema of scenes, and
into the type stubs of the compiled part the docstrings that it has.

    python make_items.py           after the package has been installed
    python make_items.py --check   whether the files are what would be written
"""

from __future__ import annotations

import ast
import inspect
import json
import pathlib
import sys
import textwrap
from typing import Any, NamedTuple

import recede._recede

HERE = pathlib.Path(__file__).parent / "recede"
WIDTH = 120
# fields without names in a scene
UNNAMED = {"rows", "value"}


def alternatives(schema: Any) -> list[dict[str, Any]]:
    """All objects and names of a schema that is a choice."""
    found = []
    for key in ("oneOf", "anyOf"):
        for one in schema.get(key, []):
            found += alternatives(one) if ("oneOf" in one or "anyOf" in one) else [one]
    return found or [schema]


class Form(NamedTuple):
    """A name with what follows it."""

    description: str
    #: Schemas of the fields by geometry; "" where there is but one form.
    fields: dict[str, dict[str, Any]]
    #: Fields that are always there.
    required: set[str]

    def all_fields(self) -> dict[str, Any]:
        """The fields of all geometries, those first that are always there."""
        every: dict[str, Any] = {}
        for fields in self.fields.values():
            for name, about in fields.items():
                every.setdefault(name, about)
        return {name: every[name] for name in sorted(every, key=lambda name: name not in self.required)}


def named(schemas: list[dict[str, Any]], geometry: str = "", known: dict[str, Form] | None = None) -> dict[str, Form]:
    """Forms by name; forms of one name, of different geometries, are put together."""
    names = {} if known is None else known

    def add(name: str, description: str, fields: dict[str, Any], required: set[str]) -> None:
        old = names.get(name, Form(description, {}, required))
        names[name] = Form(old.description, {**old.fields, geometry: fields}, old.required & required)

    for one in schemas:
        for literal in [one["const"]] if "const" in one else one.get("enum", []):
            add(literal, one.get("description", ""), {}, set())
        for name, body in one.get("properties", {}).items():
            description = one.get("description") or body.get("description", "")
            records = [about for about in alternatives(body) if "properties" in about]
            if records:
                add(name, description, records[0]["properties"], set(records[0].get("required", [])))
            else:
                field = "value" if "number" in kinds(body) else "rows"
                add(name, description, {field: body}, {field})
    return names


def kinds(schema: dict[str, Any]) -> set[str]:
    """The types of JSON that a schema allows."""
    found = schema.get("type", [])
    return set([found] if isinstance(found, str) else found)


def is_name(name: str) -> bool:
    return name[:1].isupper()


class Writer:
    """Classes of items, and of what is in their fields."""

    def __init__(self) -> None:
        #: Classes of records by their fields, with their texts.
        self.records: dict[str, tuple[str, str]] = {}
        #: Groups of the choices in fields.
        self.choices: dict[str, dict[str, Form]] = {}

    def types(self, owner: str, field: str, schema: dict[str, Any]) -> tuple[str, str]:
        """The types of an attribute, and of the argument that it is given by."""
        plain = {"number": ("float | str", "Number"), "integer": ("int", "int"), "boolean": ("bool", "bool"), "string": ("str", "str")}
        if schema.get("$ref", "").endswith("stack/items"):
            return "StackItem", "StackItem"
        choices = [one for one in alternatives(schema) if one.get("type") != "null"]
        if any(is_name(name) for one in choices for name in (*one.get("properties", {}), *one.get("enum", []), one.get("const", ""))):
            group = self.group(field, named(choices))
            return group, group
        about = choices[0] if choices else schema
        if "properties" in about:
            return self.record(owner + camel(field), about, schema.get("description", ""))
        if "array" in kinds(about) and "items" in about:
            kept, given = self.types(owner, field, about["items"])
            return f"tuple[{kept}, ...]", f"Iterable[{given}]"
        found = [kind for name, kind in plain.items() if name in kinds(about)]
        # where there are numbers, texts are numbers with a unit
        return found[0] if found else ("tuple[Row, ...]", "Rows")

    def group(self, field: str, forms: dict[str, Form]) -> str:
        """The base class of the forms of a field."""
        same = [name for name, known in self.choices.items() if set(known) == set(forms)]
        name = same[0] if same else ("Profile" if field == "shear_modulus" else camel(field))
        self.choices.setdefault(name, forms)
        return name

    def record(self, name: str, schema: dict[str, Any], description: str) -> tuple[str, str]:
        """A class with fields, for an attribute; the argument may also be its values, or a mapping."""
        fields = schema["properties"]
        required = schema.get("required", [])
        order = sorted(fields, key=lambda field: field not in required)
        types = {field: self.types(name, field, fields[field]) for field in order}
        key = json.dumps(fields, sort_keys=True)
        if key not in self.records:
            lines = [f"class {name}(NamedTuple):", *docstring(description or f"`{name}`.", fields, order), ""]
            for field in order:
                lines.append(f"    {field}: {types[field][0]}" + ("" if field in required else " | None = None"))
            self.records[key] = (name, "\n".join(lines))
        name = self.records[key][0]
        given = [types[field][1] for field in order]
        return name, f"{name} | tuple[{', '.join(given)}] | Mapping[str, {' | '.join(dict.fromkeys(given))}]"

    def item(self, name: str, form: Form, base: str) -> str:
        """The class of a form."""
        fields = form.all_fields()
        lines = [f"class {name}({base}):", *docstring(form.description or f"`{name}` of a scene.", fields, list(fields)), ""]
        slots = "".join(f'"{field}", ' for field in fields)
        lines.append(f"    __slots__ = ({slots.rstrip(' ') if len(fields) == 1 else slots.removesuffix(', ')})")
        if len(form.fields) > 1 or "" not in form.fields:
            of = {geometry: tuple(own) for geometry, own in form.fields.items()}
            lines += wrapped("    _geometries = {", [f"{geometry!r}: {own!r}".replace("'", '"') for geometry, own in of.items()], "}")
        if not fields:
            return "\n".join([*lines, "", "    def __init__(self) -> None:", "        self._set()"])
        types = {field: self.types(name, field, about) for field, about in fields.items()}
        optional = {field: "" if field in form.required else " | None" for field in fields}
        lines += [f"    {field}: {types[field][0]}{optional[field]}" for field in fields]
        given = [f"{field}: {types[field][1]}{optional[field]}{' = None' if optional[field] else ''}" for field in fields]
        # what has no name in a scene is given by its place
        signature = ["self", *given] if set(fields) <= UNNAMED else ["self", "*", *given]
        lines += ["", *wrapped("    def __init__(", signature, ") -> None:")]
        lines += wrapped("        self._set(", [f"{field}={field}" for field in fields], ")")
        return "\n".join(lines)


def camel(field: str) -> str:
    return "".join(part.capitalize() for part in field.split("_"))


def wrapped(head: str, parts: list[str], tail: str) -> list[str]:
    """In one line, or in a line for each part."""
    one = head + ", ".join(parts) + tail
    indent = " " * (len(head) - len(head.lstrip()))
    return [one] if len(one) <= WIDTH else [head, *(f"{indent}    {part}," for part in parts), indent + tail]


def sentence(text: str) -> str:
    """The first paragraphs of a description, without its examples."""
    return " ".join(text.split("```")[0].split()).replace("\\", "\\\\")


def docstring(description: str, fields: dict[str, Any], order: list[str]) -> list[str]:
    head = textwrap.fill(f'"""{sentence(description)}', WIDTH, initial_indent="    ", subsequent_indent="    ", break_long_words=False)
    if not order:
        return [head + '"""']
    lines = [head, "", "    Args:"]
    for field in order:
        text = f"{field}: {sentence(fields[field].get('description', '')) or 'see docs/formats.md.'}"
        lines.append(textwrap.fill(text, WIDTH, initial_indent=" " * 8, subsequent_indent=" " * 12))
    return [*lines, '    """']


def module(title: str, groups: dict[str, dict[str, Form]], own: dict[str, str] | None = None) -> str:
    """A module with the classes of some groups; `own` are base classes that it has itself, with what they are."""
    writer, parts, names = Writer(), [], list(groups)
    # a field may be one of a group
    writer.choices.update(groups)
    for base, forms in groups.items():
        if base in (own or {}):
            parts.append(f'class {base}(Item):\n    """{(own or {})[base]}"""\n\n    __slots__ = ()')
        parts += [writer.item(name, form, base) for name, form in forms.items()]
        names += forms
    # base classes of choices in fields that are in no other module
    for base, forms in writer.choices.items():
        if base not in BASES:
            parts.insert(0, f'class {base}(Item):\n    """A choice in a field."""\n\n    __slots__ = ()')
            parts += [writer.item(name, form, base) for name, form in forms.items()]
            names += [base, *forms]
    parts = [text for _, text in writer.records.values()] + parts
    names += [name for name, _ in writer.records.values()]
    bases = sorted({base for base in (*groups, *writer.choices) if base in BASES and base not in (own or {})})
    text = "\n\n\n".join(parts)
    collected = [name for name in ("Iterable", "Mapping") if f"{name}[" in text]
    values = [name for name in ("Number", "Row", "Rows") if any(mark in text for mark in (f"{name} ", f"{name},", f"{name})", f"{name}]"))]
    head = [f'"""{title}\n\nWritten by make_items.py from the JSON Schema of scenes."""', "", "from __future__ import annotations", ""]
    head += [f"from collections.abc import {', '.join(collected)}"] if collected else []
    head += ["from typing import NamedTuple"] if writer.records else []
    head += [""] if collected or writer.records else []
    items = bases + (["Item"] if "(Item)" in text else [])
    head += [f"from ._items import {', '.join(sorted(items))}"] if items else []
    head += [f"from ._values import {', '.join(values)}"] if values else []
    every = ",\n".join(f'    "{name}"' for name in sorted(names))
    return "\n".join(head) + f"\n\n\n{text}\n\n\n__all__ = [\n{every},\n]\n"


# base classes in recede/_items.py, which know how their items are checked
BASES = ("StackItem", "Punch", "Load", "Profile")


def modules(schema: dict[str, Any]) -> dict[str, str]:
    """The modules for scenes of this schema."""
    stack = named(alternatives(schema["properties"]["stack"]["items"]))
    tops: dict[str, dict[str, Form]] = {"punch": {}, "load": {}}
    for one in schema["anyOf"]:
        geometry = one["properties"]["geometry"]["enum"][0]
        for key, forms in tops.items():
            choices = [about for about in alternatives(one["properties"].get(key, {})) if about.get("type") != "null"]
            named(choices, geometry, forms)
    both = set(stack) & (set(tops["punch"]) | set(tops["load"])) | set(tops["punch"]) & set(tops["load"])
    assert not both, f"one name, two things: {both}"
    items = {"StackItem": stack, "Punch": tops["punch"], "Load": tops["load"]}
    finder = Writer()
    for forms in items.values():
        for name, form in forms.items():
            finder.item(name, form, "")
    return {
        "items.py": module(
            "Layers, interfaces, bases, punches and loads.\n\n"
            "Numbers may be texts with a unit, such as '26 GPa', where the scene names its units.",
            items,
        ),
        "profiles.py": module(
            "Moduli and Poisson's ratios as functions of the depth, for `Graded`.", {"Profile": finder.choices.get("Profile", {})}
        ),
    }


def with_docstrings(stubs: str) -> str:
    """The type stubs, with the docstrings of the compiled part."""
    lines = stubs.splitlines()
    edits: list[tuple[ast.FunctionDef | ast.ClassDef, str]] = []

    def visit(body: list[ast.stmt], owner: Any) -> None:
        last = {node.name: node for node in body if isinstance(node, ast.FunctionDef | ast.ClassDef)}
        for node in last.values():
            found = vars(owner).get(node.name) if isinstance(owner, type) else getattr(owner, node.name)
            text = inspect.getdoc(found.__func__ if isinstance(found, staticmethod) else found)
            if isinstance(node, ast.ClassDef):
                visit(node.body, found)
            if text and not node.name.startswith("__"):
                edits.append((node, text))

    visit(ast.parse(stubs).body, recede._recede)
    for node, text in sorted(edits, key=lambda edit: -edit[0].lineno):
        indent = " " * (node.col_offset + 4)
        doc = textwrap.indent(f'"""{text}' + ('\n"""' if "\n" in text else '"""'), indent).splitlines()
        doc = [line.rstrip() for line in doc]
        first = node.body[0]
        has_doc = ast.get_docstring(node) is not None
        is_empty = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
        if isinstance(node, ast.ClassDef) and not is_empty:
            lines[first.lineno - 1 : first.lineno - 1] = [*doc, ""]
        elif has_doc or lines[first.lineno - 1].strip() == "...":
            lines[first.lineno - 1 : first.end_lineno] = doc
        else:
            # the body stands behind the colon
            head = lines[first.lineno - 1]
            lines[first.lineno - 1 : first.end_lineno] = [head[: head.rindex("...")].rstrip(), *doc]
    return "\n".join(lines) + "\n"


def files() -> dict[str, str]:
    """All files by name."""
    stubs = (HERE / "_recede.pyi").read_text(encoding="utf-8")
    return {**modules(json.loads(recede._recede.schema())), "_recede.pyi": with_docstrings(stubs)}


if __name__ == "__main__":
    for name, text in files().items():
        if "--check" in sys.argv:
            if (HERE / name).read_text(encoding="utf-8") != text:
                sys.exit(f"recede/{name} is not what make_items.py writes: run it")
        else:
            (HERE / name).write_text(text, encoding="utf-8")
