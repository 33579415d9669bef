"""Texts of scenes from objects: what is legal is known by the reader of scenes alone."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ._recede import Model, Scene, Solution

INDENT = "    "


def value(found: Any) -> str:
    """A value as it is written in a scene."""
    if isinstance(found, Item):
        return found.ron()
    if isinstance(found, bool | np.bool_):
        return "true" if found else "false"
    if isinstance(found, str):
        return json.dumps(found, ensure_ascii=False)
    if isinstance(found, int | np.integer):
        return str(int(found))
    if isinstance(found, float | np.floating):
        return _number(float(found))
    if isinstance(found, tuple):
        return f"({', '.join(value(one) for one in found)})"
    if isinstance(found, np.ndarray):
        found = found.tolist()
    if isinstance(found, Iterable) and not isinstance(found, Mapping | bytes):
        return f"[{', '.join(_row(one) for one in found)}]"
    raise TypeError(f"{found!r} cannot be written in a scene; numbers, texts such as '26 GPa', lists and items can")


def _number(number: float) -> str:
    if number != number:
        return "NaN"
    if number in (float("inf"), float("-inf")):
        return "inf" if number > 0 else "-inf"
    return repr(number)


def _row(one: Any) -> str:
    # rows of tables are pairs, also those of arrays
    return value(tuple(one)) if isinstance(one, list) else value(one)


class Item:
    """A layer, an interface, a punch, a load or a profile: a name with fields. Its fields are attributes, and cannot be changed."""

    __slots__ = ("_fields", "_compiled")
    _fields: dict[str, Any]

    def __init__(self, **fields: Any) -> None:
        given = {name: field for name, field in fields.items() if field is not None}
        object.__setattr__(self, "_fields", given)

    def ron(self) -> str:
        """As it is written in a scene."""
        if not self._fields:
            return type(self).__name__
        fields = ", ".join(self._written(name, field) for name, field in self._fields.items())
        return f"{type(self).__name__}({fields})"

    @staticmethod
    def _written(name: str, field: Any) -> str:
        return value(field) if name == "rows" else f"{name}: {value(field)}"

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self._fields[name]
        except KeyError:
            raise AttributeError(f"{type(self).__name__} has no {name!r}") from None

    def __setattr__(self, name: str, field: Any) -> None:
        if name != "_compiled":
            raise AttributeError("items cannot be changed; make another one")
        object.__setattr__(self, name, field)

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (type(self), self._fields)

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Item) and self.ron() == other.ron()

    def __hash__(self) -> int:
        return hash(self.ron())

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={field!r}' for name, field in self._fields.items())})"


def _again(kind: type[Item], fields: dict[str, Any]) -> Item:
    item = kind.__new__(kind)
    Item.__init__(item, **fields)
    return item


class FunctionLayer(Item):
    """A layer whose material is a function of the depth below its top face.

    Args:
        thickness: thickness h, in length.
        material: a function that returns (shear modulus in stress, Poisson's ratio) at a depth in length. It is to be smooth, and is
            called some hundreds of times for each stack. An exception that it raises is raised by whoever uses the layer.

    `recede.examine(layer)` checks the laws of elasticity that hold for all layers.
    """

    __slots__ = ()

    def __init__(self, thickness: float, material: Any) -> None:
        if not callable(material):
            raise TypeError(f"`material` has to be a function of the depth, not {material!r}")
        super().__init__(thickness=thickness, material=material)

    def ron(self) -> str:
        # in place of the function something legal, for messages about the rest
        return f"Homogeneous(thickness: {value(self.thickness)}, shear_modulus: 1.0, poisson: 0.0)"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, FunctionLayer) and self._fields == other._fields

    def __hash__(self) -> int:
        return hash((self.thickness, self.material))


class Stack:
    """Layers and the interfaces between them from the top down, ending in a base.

    Args:
        items: such as `[Homogeneous(thickness=1, young=200, poisson=0.3), Receding(), HalfPlane(young=70, poisson=0.3)]`.
        geometry: "PlaneStrain", "PlaneStress" or "Axisymmetric".

    Raises:
        InputError: if a number is not legal, or items do not fit together; with the item in question.
    """

    def __init__(self, items: Iterable[Item], geometry: str = "PlaneStrain") -> None:
        self._items = tuple(items)
        self._geometry = geometry
        # punch and force are those of whoever presses
        self._scene = Scene(self._items, ANY_PUNCH, 1.0, geometry=geometry)

    @property
    def items(self) -> tuple[Item, ...]:
        """The items from the top down."""
        return self._items

    @property
    def geometry(self) -> str:
        """"PlaneStrain", "PlaneStress" or "Axisymmetric"."""
        return self._geometry

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Stack) and (self._items, self._geometry) == (other._items, other._geometry)

    def __hash__(self) -> int:
        return hash((self._items, self._geometry))

    def __repr__(self) -> str:
        return f"Stack([{', '.join(map(repr, self._items))}], geometry={self._geometry!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return Stack, (self._items, self._geometry)


class _AnyPunch(Item):
    __slots__ = ()

    def ron(self) -> str:
        return "Parabola(radius: 1.0)"


ANY_PUNCH = _AnyPunch()


def scene(
    stack: Stack | Iterable[Item],
    punch: Item | None,
    force: Any,
    *,
    load: Item | None = None,
    half_length: Any = None,
    depth: Any = None,
    geometry: str | None = None,
    name: str | None = None,
    description: str | None = None,
    units: tuple[str, str] | None = None,
) -> tuple[str, list[tuple[int, float, Any]]]:
    """The text of a scene, and which items of the stack are functions."""
    items = stack.items if isinstance(stack, Stack) else tuple(stack)
    if isinstance(stack, Stack) and geometry not in (None, stack.geometry):
        raise ValueError(f"`geometry` is {geometry!r}, but that of the stack is {stack.geometry!r}")
    for item in items:
        if not isinstance(item, Item):
            raise TypeError(f"{item!r} is no item of a stack, such as `Homogeneous(...)`, `Receding()` or `HalfPlane(...)`")
    for given, called in ((punch, "punch"), (load, "load")):
        if given is not None and not isinstance(given, Item):
            raise TypeError(f"`{called}` has to be one such as `Cylinder(radius=...)`, not {given!r}")
    for given, called in ((force, "force"), (half_length, "half_length"), (depth, "depth")):
        if given is not None and not isinstance(given, int | float | str | np.number) or isinstance(given, bool):
            raise TypeError(f"`{called}` has to be a number, or a text such as '2 kN', not {given!r}")
    chosen = geometry or (stack.geometry if isinstance(stack, Stack) else "PlaneStrain")
    fields = {"name": name, "description": description}
    lines = [f"{INDENT}{key}: {value(text)}," for key, text in fields.items() if text is not None]
    if units is not None:
        lines.append(f"{INDENT}units: {_units(units)},")
    lines.append(f"{INDENT}geometry: {chosen},")
    numbers = {"punch": punch, "load": load, "force": force, "half_length": half_length, "depth": depth}
    lines += [f"{INDENT}{key}: {value(one)}," for key, one in numbers.items() if one is not None]
    lines += [f"{INDENT}stack: [", *(f"{2 * INDENT}{item.ron()}," for item in items), f"{INDENT}],"]
    functions = [
        (place, float(item.thickness), item.material) for place, item in enumerate(items) if isinstance(item, FunctionLayer)
    ]
    return "\n".join(["Scene(", *lines, ")"]), functions


def _units(units: tuple[str, str]) -> str:
    length, force = units
    return f"(length: {value(length)}, force: {value(force)})"


def with_punch(punch: Any, geometry: str, units: tuple[str, str] | None) -> str:
    """The text of a scene with this punch, or load, on any stack."""
    if not isinstance(punch, Item):
        raise TypeError(f"`punch` has to be one such as `Cylinder(radius=...)`, not {punch!r}")
    own, load = (None, punch) if getattr(type(punch), "_is_load", False) else (punch, None)
    return scene([_Ground()], own, 1.0, load=load, geometry=geometry, units=units)[0]


class _Ground(Item):
    __slots__ = ()

    def ron(self) -> str:
        return "HalfPlane(shear_modulus: 1.0, poisson: 0.25)"


def scene_of(stack: Any) -> Scene:
    """The scene of a stack, with whatever punch."""
    if isinstance(stack, Scene):
        return stack
    if isinstance(stack, Stack):
        return stack._scene
    raise TypeError(f"a model is made of a `Stack` or a `Scene`, not of {stack!r}")


def model(scene: Scene, many_loads: bool) -> Model:
    """A model that was pickled."""
    return Model(scene, many_loads=many_loads)


def solve_text(text: str, tolerance: float) -> Solution:
    """A solution that was pickled: it is computed again, to the same bits."""
    return Scene.from_ron(text).solve(tolerance=tolerance)
