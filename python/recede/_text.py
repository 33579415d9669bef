"""Scenes from objects, and objects from scenes."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np

from ._items import Item, Load, Punch, StackItem, Tilt, named
from ._recede import Model, Scene, Solution
from ._values import PlacedLoad, Pressed, Units, kept, written

INDENT = "    "
KINDS_OF_FORCE = ("force", "half_length", "depth")


class FunctionLayer(Item):
    """A layer whose material is a function of the depth below its top face.

    Args:
        thickness: thickness h, in length.
        material: a function that returns (shear modulus in stress, Poisson's ratio) at a depth in length. It is to be smooth, and is
            called some hundreds of times for each stack. An exception that it raises is raised by whoever uses the layer.

    `recede.examine(layer)` checks the laws of elasticity that hold for all layers.
    """

    __slots__ = ("thickness", "material")
    thickness: float
    material: Callable[[float], tuple[float, float]]

    def __init__(self, thickness: float, material: Callable[[float], tuple[float, float]]) -> None:
        if not callable(material):
            raise TypeError(f"`FunctionLayer.material` has to be a function of the depth, not {material!r}")
        self._keep({"thickness": kept(thickness, float, "FunctionLayer.thickness"), "material": material})
        self._check()

    def _scenes(self) -> list[str]:
        return StackItem._scenes(self)  # type: ignore[arg-type]

    def ron(self) -> str:
        # in place of the function something legal, for messages about the rest
        return f"Homogeneous(thickness: {written(self.thickness)}, shear_modulus: 1.0, poisson: 0.0)"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, FunctionLayer) and self._fields() == other._fields()

    def __hash__(self) -> int:
        return hash((self.thickness, self.material))


class Stack:
    """Layers and the interfaces between them from the top down, ending in a base.

    Args:
        items: such as `[Homogeneous(thickness=1, young=200, poisson=0.3), Receding(), HalfPlane(young=70, poisson=0.3)]`.
        geometry: "PlaneStrain", "PlaneStress" or "Axisymmetric".

    Raises:
        InputError: if items do not fit together; with the item in question.
    """

    def __init__(self, items: Iterable[Item], geometry: str = "PlaneStrain") -> None:
        self._items = tuple(items)
        self._geometry = geometry
        # who presses brings punch and force
        self._scene = Scene(self._items, ANY_PUNCH, 1.0, geometry=geometry)

    @property
    def items(self) -> tuple[Item, ...]:
        """The items from the top down."""
        return self._items

    @property
    def geometry(self) -> str:
        """ "PlaneStrain", "PlaneStress" or "Axisymmetric"."""
        return self._geometry

    def _repr_html_(self) -> str | None:
        return self._scene._repr_html_(top=False)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Stack) and (self._items, self._geometry) == (other._items, other._geometry)

    def __hash__(self) -> int:
        return hash((self._items, self._geometry))

    def __repr__(self) -> str:
        return f"Stack([{', '.join(map(repr, self._items))}], geometry={self._geometry!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return Stack, (self._items, self._geometry)


class _AnyPunch(Punch):
    __slots__ = ()

    def ron(self) -> str:
        return "Parabola(radius: 1.0)"


ANY_PUNCH = _AnyPunch()


class _Ground(Item):
    __slots__ = ()

    def ron(self) -> str:
        return "HalfPlane(shear_modulus: 1.0, poisson: 0.25)"


class Text:
    """The text of a scene, and the object that each line is about."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.objects: list[Any] = []

    def add(self, line: str, about: Any = None) -> None:
        """Adds a line."""
        self.lines.append(line)
        self.objects.append(about)


def scene(
    stack: Stack | Iterable[Item],
    punch: Any,
    force: Any,
    *,
    punches: Any = None,
    load: Any = None,
    loads: Any = None,
    half_length: Any = None,
    depth: Any = None,
    pressure_on_top: Any = None,
    geometry: str | None = None,
    name: str | None = None,
    description: str | None = None,
    units: Any = None,
) -> tuple[str, list[Any], list[tuple[int, float, Any]]]:
    """The text of a scene, what each line of it is about, and which items of the stack are functions."""
    items = stack.items if isinstance(stack, Stack) else tuple(stack)
    if isinstance(stack, Stack) and geometry not in (None, stack.geometry):
        raise ValueError(f"`geometry` is {geometry!r}, but the geometry of the stack is {stack.geometry!r}")
    for item in items:
        if not isinstance(item, Item):
            raise TypeError(f"{item!r} is no item of a stack, such as `Homogeneous(...)`, `Receding()` or `HalfPlane(...)`")
    for given, called in ((punch, "punch"), (load, "load")):
        if given is not None and not isinstance(given, Item):
            raise TypeError(f"`{called}` has to be one such as `Cylinder(radius=...)`, not {given!r}")
    numbers = dict(zip(KINDS_OF_FORCE, (force, half_length, depth), strict=True))
    for called, number in {**numbers, "pressure_on_top": pressure_on_top}.items():
        if number is not None and not isinstance(number, int | float | str | np.number) or isinstance(number, bool):
            raise TypeError(f"`{called}` has to be a number, or a text such as '2 kN', not {number!r}")
    text = Text()
    text.add("Scene(")
    for called, label in (("name", name), ("description", description), ("units", _units(units))):
        if label is not None:
            text.add(f"{INDENT}{called}: {written(label)},", f"{called}={label!r}")
    chosen = geometry or (stack.geometry if isinstance(stack, Stack) else "PlaneStrain")
    text.add(f"{INDENT}geometry: {chosen},", f"geometry={chosen!r}")
    placed = None if loads is None else kept(loads, tuple[PlacedLoad, ...], "loads")
    pressed = None if punches is None else kept(punches, tuple[Pressed, ...], "punches")
    for called, one in {"punch": punch, "punches": pressed, "load": load, "loads": placed, **numbers}.items():
        if one is not None:
            value = kept(one, object, called)
            text.add(f"{INDENT}{called}: {written(value)},", one if isinstance(one, Item) else f"{called}={value!r}")
    if pressure_on_top is not None:
        pressure = kept(pressure_on_top, object, "pressure_on_top")
        text.add(f"{INDENT}pressure_on_top: {written(pressure)},", f"pressure_on_top={pressure!r}")
    text.add(f"{INDENT}stack: [")
    for item in items:
        text.add(f"{2 * INDENT}{item.ron()},", item)
    text.add(f"{INDENT}],")
    text.add(")")
    functions = [
        (place, float(item.thickness), item.material) for place, item in enumerate(items) if isinstance(item, FunctionLayer)
    ]
    return "\n".join(text.lines), text.objects, functions


def _units(units: Any) -> Units | None:
    """Labels of units: a pair, a mapping, or `Units`."""
    if units is None:
        return None
    example = 'such as `Units("mm", "N")`, ("mm", "N") or {"length": "mm", "force": "N"}'
    if isinstance(units, str | bytes) or not isinstance(units, Iterable):
        raise TypeError(f"`units` has to be labels of length and force, {example}, not {units!r}")
    found: Units = kept(units, Units, "units")
    for label in found:
        if not isinstance(label, str):
            raise TypeError(f"`units` has to be labels of length and force, {example}, not {units!r}")
    return found


def about(objects: list[Any], line: int) -> str | None:
    """What a line of the text of a scene is about, in Python; None if that is not known any more."""
    found = objects[line - 1] if line <= len(objects) else None
    return found if found is None or isinstance(found, str) else repr(found)


def with_punch(punch: Any, geometry: str, units: tuple[str, str] | None) -> tuple[str, list[Any]]:
    """The text of a scene with this punch, or load, on any stack, and what each line of it is about."""
    if not isinstance(punch, Item):
        raise TypeError(f"`punch` has to be one such as `Cylinder(radius=...)`, not {punch!r}")
    own, load = (None, punch) if isinstance(punch, Load) else (punch, None)
    return scene([_Ground()], own, 1.0, load=load, geometry=geometry, units=units)[:2]


#: How the parts of a scene that are no plain values are made of its JSON, by the names of the arguments of `Scene`.
MADE: dict[str, Callable[[Any], Any]] = {
    "units": lambda units: Units(**units),
    "punch": lambda punch: named(Punch, punch),
    "punches": lambda punches: tuple(
        Pressed(**one | {"shape": named(Punch, one["shape"]), "tilt": named(Tilt, one["tilt"]) if "tilt" in one else None}) for one in punches
    ),
    "load": lambda load: named(Load, load),
    "loads": lambda loads: tuple(PlacedLoad(named(Load, one["load"]), kept(one["at"], object, "at"), one["force"]) for one in loads),
}


def part(text: str, name: str) -> Any:
    """A part of a scene in JSON, by the name of the argument of `Scene`; None if the scene has none."""
    data: dict[str, Any] = json.loads(text)
    if name == "stack":
        return Stack([named(StackItem, one) for one in data["stack"]], data["geometry"])
    made = data.get(name)
    return made and MADE.get(name, lambda value: value)(made)


def scene_repr(text: str) -> str:
    """A scene in JSON as it is written in Python."""
    first = ", ".join(repr(part(text, name)) for name in ("stack", "punch", "force"))
    names = ("name", "description", "half_length", "depth", "units", "load", "punches", "loads", "pressure_on_top")
    rest = {name: part(text, name) for name in names}
    return f"Scene({first}{''.join(f', {name}={value!r}' for name, value in rest.items() if value is not None)})"


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
