"""Writes recede/items.py and recede/profiles.py: a class for everything that may be written in a scene, from the JSON Schema of scenes.

    python make_items.py           after the package has been installed
    python make_items.py --check   whether the files are what would be written
"""

from __future__ import annotations

import json
import pathlib
import sys
import textwrap
from typing import Any

import recede._recede

HEAD = '"""{}\n\nWritten by make_items.py from the JSON Schema of scenes."""\n\nfrom __future__ import annotations\n\nfrom typing import Any\n\nfrom ._text import Item\n\n'
HERE = pathlib.Path(recede.__file__).parent if "--check" in sys.argv else pathlib.Path(__file__).parent / "recede"
# fields whose values are not numbers
ROWS = "rows"


def alternatives(schema: Any) -> list[dict[str, Any]]:
    """All objects and names of a schema that is a choice."""
    found = []
    for key in ("oneOf", "anyOf"):
        for one in schema.get(key, []):
            found += alternatives(one) if ("oneOf" in one or "anyOf" in one) else [one]
    return found or [schema]


def named(schemas: list[dict[str, Any]]) -> dict[str, dict[str, Any]]:
    """Names with their descriptions and fields; several of one name, of different geometries, are put together."""
    names: dict[str, dict[str, Any]] = {}
    for one in schemas:
        if "const" in one:
            names.setdefault(one["const"], {"description": one.get("description", ""), "fields": {}, "required": None})
        for literal in one.get("enum", []):
            names.setdefault(literal, {"description": one.get("description", ""), "fields": {}, "required": None})
        for name, body in one.get("properties", {}).items():
            own = names.setdefault(name, {"description": "", "fields": {}, "required": None})
            own["description"] = own["description"] or one.get("description") or body.get("description", "")
            bodies = [b for b in alternatives(body) if "properties" in b]
            if not bodies and body.get("type") != "null":
                bodies = [{"properties": {ROWS: body}, "required": [ROWS]}]
            for b in bodies:
                required = set(b.get("required", []))
                own["required"] = required if own["required"] is None else own["required"] & required
                for field, about in b["properties"].items():
                    own["fields"].setdefault(field, about)
    return names


def sentence(text: str) -> str:
    text = " ".join(text.split("```")[0].split())
    return text.replace("\\", "\\\\")


def class_text(name: str, about: dict[str, Any], base: str) -> str:
    required = [field for field in about["fields"] if field in (about["required"] or set())]
    optional = [field for field in about["fields"] if field not in required]
    lines = [f"class {name}({base}):"]
    description = sentence(about["description"]) or f"`{name}` of a scene."
    lines += [textwrap.fill(f'"""{description}', 120, initial_indent="    ", subsequent_indent="    ", break_long_words=False)]
    if about["fields"]:
        lines += ["", "    Args:"]
        for field in required + optional:
            text = f"{field}: {sentence(about['fields'][field].get('description', '')) or 'see docs/formats.md.'}"
            lines.append(textwrap.fill(text, 120, initial_indent=" " * 8, subsequent_indent=" " * 12))
        lines.append('    """')
    else:
        lines[-1] += '"""'
    lines += ["", "    __slots__ = ()"]
    if not about["fields"]:
        lines += ["", "    def __init__(self) -> None:", "        super().__init__()"]
        return "\n".join(lines)
    if required == [ROWS]:
        # the only field of a list is given by its place
        signature = f"self, {ROWS}: Any"
    else:
        fields = [f"{field}: Any" for field in required] + [f"{field}: Any = None" for field in optional]
        signature = ", ".join(["self", "*", *fields])
    passed = ", ".join(f"{field}={field}" for field in required + optional)
    one = f"    def __init__({signature}) -> None:"
    if len(one) > 120:
        inside = "".join(f"        {part},\n" for part in signature.split(", "))
        one = f"    def __init__(\n{inside}    ) -> None:"
    lines += ["", one]
    call = f"        super().__init__({passed})"
    if len(call) > 120:
        call = "        super().__init__(\n" + "".join(f"            {part},\n" for part in passed.split(", ")) + "        )"
    lines.append(call)
    return "\n".join(lines)


def module(title: str, groups: list[tuple[str, str, bool, dict[str, dict[str, Any]]]]) -> str:
    parts, names = [HEAD.format(title).rstrip() + "\n"], []
    for base, what, is_load, members in groups:
        mark = "\n    _is_load = True\n" if is_load else ""
        parts.append(f'\n\nclass {base}(Item):\n    """{what}"""\n\n    __slots__ = ()\n{mark}')
        for name, about in members.items():
            parts.append("\n\n" + class_text(name, about, base) + "\n")
            names.append(name)
        names.append(base)
    every = ",\n".join(f'    "{name}"' for name in sorted(names))
    return "".join(parts) + f"\n\n__all__ = [\n{every},\n]\n"


def files() -> dict[str, str]:
    schema = json.loads(recede._recede.schema())
    stack = named(alternatives(schema["properties"]["stack"]["items"]))
    punches, loads = {}, {}
    all_of: dict[str, list[dict[str, Any]]] = {"punch": [], "load": []}
    for geometry in schema["anyOf"]:
        for key in all_of:
            if key in geometry.get("properties", {}):
                all_of[key] += [one for one in alternatives(geometry["properties"][key]) if one.get("type") != "null"]
    punches, loads = named(all_of["punch"]), named(all_of["load"])
    profiles = named(alternatives(stack["Graded"]["fields"]["shear_modulus"]))
    profiles = {name: about for name, about in profiles.items() if name[0].isupper()}
    both = set(stack) & (set(punches) | set(loads)) | set(punches) & set(loads)
    assert not both, f"one name, two things: {both}"
    items = module(
        "Layers, interfaces, bases, punches and loads.\n\nNumbers may be texts with a unit, such as '26 GPa', where the scene names its units.",
        [
            ("StackItem", "An item of a stack.", False, stack),
            ("Punch", "A punch.", False, punches),
            ("Load", "A given pressure in place of a punch.", True, loads),
        ],
    )
    return {
        "items.py": items,
        "profiles.py": module(
            "Moduli and Poisson's ratios as functions of the depth, for `Graded`.",
            [("Profile", "A function of the depth d below the top face of a layer.", False, profiles)],
        ),
    }


if __name__ == "__main__":
    for name, text in files().items():
        if "--check" in sys.argv:
            if (HERE / name).read_text() != text:
                sys.exit(f"recede/{name} is not what make_items.py writes: run it")
        else:
            (HERE / name).write_text(text)
