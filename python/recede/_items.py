"""Items of scenes: names with fields. What is legal is known by the reader of scenes alone."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any, ClassVar

from ._errors import InputError
from ._recede import CompiledTop, Scene
from ._values import Number, Written, hints, is_record, kept, members, written

#: What the reader of scenes calls the item that it reads.
OWNER = r"(?:layer \d+(?: \".*\")? \(\w+\)|the (?:springs|interface|gap) below layer \d+|the punch|the load|punch \d+)"
#: Units for numbers that have one.
UNITS = 'units: (length: "m", force: "N"), '
PUNCH = "punch: Parabola(radius: 1.0)"
GROUND = "HalfPlane(shear_modulus: 1.0, poisson: 0.25)"


class Item(Written):
    """A layer, an interface, a punch, a load or a profile: a name with fields.

    Its fields are attributes, None where they are not given, and cannot be changed. They are checked when it is made.

    Raises:
        InputError: if a number is not legal.
    """

    __slots__ = ("_compiled",)
    _compiled: CompiledTop
    #: What stands before its name in Python.
    _module: ClassVar[str] = ""

    def _set(self, **fields: Any) -> None:
        """Keeps and checks the fields."""
        types = hints(type(self))
        self._keep({name: kept(one, types[name], f"{type(self).__name__}.{name}") for name, one in fields.items()})
        # a name alone is legal
        if fields:
            self._check()

    def _keep(self, fields: Mapping[str, Any]) -> None:
        for name, value in fields.items():
            object.__setattr__(self, name, value)

    def _fields(self) -> dict[str, Any]:
        """The fields that are given."""
        fields = {name: getattr(self, name) for name in type(self).__slots__}
        return {name: value for name, value in fields.items() if value is not None}

    def _scenes(self) -> list[str]:
        """Scenes about the item alone; it is legal if it is in one of them, and the first one says what is wrong."""
        return []

    def _check(self) -> None:
        first: InputError | None = None
        for text in self._scenes():
            try:
                Scene.from_ron(text)
            except InputError as error:
                first = first or error
            else:
                return
        if first is not None:
            raise self._about(first)

    def _about(self, error: InputError) -> InputError:
        """An error of a scene about the item alone, in words of the item."""
        name = type(self).__name__
        message = re.sub(rf"`([\w.]+)` of {OWNER}", lambda found: f"`{self._path(found[1])}`", error.message)
        message = re.sub(OWNER, f"`{name}`", message)
        hint = error.hint and re.sub(r"`(\w+): \.\.\.`", r"`\1=...`", error.hint)
        return InputError(message if f"`{name}" in message else f"`{name}`: {message}", hint)

    def _path(self, field: str) -> str:
        return f"{type(self).__name__}.{field}"

    def ron(self) -> str:
        """As it is written in a scene."""
        if not type(self).__slots__:
            return type(self).__name__
        fields = (written(one) if name in UNNAMED else f"{name}: {written(one)}" for name, one in self._fields().items())
        return f"{type(self).__name__}({', '.join(fields)})"

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("items cannot be changed; make another one")

    def __delattr__(self, name: str) -> None:
        raise AttributeError("items cannot be changed; make another one")

    def __reduce__(self) -> tuple[Any, ...]:
        return again, (type(self), {name: getattr(self, name) for name in type(self).__slots__})

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Item) and self.ron() == other.ron()

    def __hash__(self) -> int:
        return hash(self.ron())

    def __repr__(self) -> str:
        fields = (f"{name}={value!r}" for name, value in self._fields().items())
        return f"{self._module}{type(self).__name__}({', '.join(fields)})"


#: Fields whose names are not written in a scene.
UNNAMED = ("rows", "value")


def again(kind: type[Item], fields: dict[str, Any]) -> Item:
    """An item that was pickled."""
    item = kind.__new__(kind)
    item._keep(fields)
    return item


def alone(geometry: str, top: str, stack: str) -> str:
    """A scene about an item."""
    units = UNITS if '"' in top or '"' in stack else ""
    return f"Scene(geometry: {geometry}, {units}{top}, force: 1.0, stack: [{stack}])"


class StackItem(Item):
    """An item of a stack."""

    __slots__ = ()

    def ron(self) -> str:
        # an interface may have a field, or none
        return super().ron() if self._fields() else type(self).__name__

    def _scenes(self) -> list[str]:
        return [alone(geometry, PUNCH, self.ron()) for geometry in ("PlaneStrain", "Axisymmetric")]


class _Top(Item):
    """What presses on top."""

    __slots__ = ()
    #: The key under which it stands in a scene.
    _key: ClassVar[str] = "punch"
    #: The fields that it may have, by geometry.
    _geometries: ClassVar[dict[str, tuple[str, ...]]] = {}

    def _scenes(self) -> list[str]:
        given = set(self._fields())
        fitting = [geometry for geometry, fields in self._geometries.items() if given <= set(fields)]
        chosen = fitting or list(self._geometries)
        return [alone(one, f"{self._key}: {self.ron()}", GROUND) for one in chosen]


class Punch(_Top):
    """A punch."""

    __slots__ = ()


class Load(_Top):
    """A given pressure in place of a punch."""

    __slots__ = ()
    _key = "load"


class Tilt(Item):
    """Whether a punch turns, by small angles."""

    __slots__ = ()

    def _scenes(self) -> list[str]:
        punches = f"punches: [(shape: Parabola(radius: 1.0), at: 0.0, force: 1.0, tilt: {self.ron()})]"
        return [f"Scene(geometry: PlaneStrain, {UNITS}{punches}, stack: [{GROUND}])"]

    def _path(self, field: str) -> str:
        # the first one is the field of the punch
        return ".".join([type(self).__name__, *field.split(".")[1:]])


class Fixed(Tilt):
    """A punch is turned by a small angle, which is added to its slope, and cannot turn farther.

    Args:
        value: the angle, in radians. Allowed: a finite number.
    """

    __slots__ = ("value",)
    value: float | str

    def __init__(self, value: Number) -> None:
        self._set(value=value)


class Free(Tilt):
    """A punch turns freely until the pressures under it have the moment of its force.

    Args:
        eccentricity: how far to the right of its tip its force acts, in length. Allowed: a finite number.
    """

    __slots__ = ("eccentricity",)
    eccentricity: float | str

    def __init__(self, *, eccentricity: Number) -> None:
        self._set(eccentricity=eccentricity)


class Profile(Item):
    """A function of the depth d below the top face of a layer."""

    __slots__ = ()
    _module = "profiles."

    def _scenes(self) -> list[str]:
        places = (f"shear_modulus: {self.ron()}, poisson: 0.3", f"shear_modulus: Constant(1.0), poisson_profile: {self.ron()}")
        stacks = (f"Graded(thickness: 0.0, {place})" for place in places)
        return [alone("PlaneStrain", PUNCH, stack) for stack in stacks]

    def _path(self, field: str) -> str:
        # the first one is the field of the layer
        return ".".join([type(self).__name__, *field.split(".")[1:]])


def named(base: type[Item], data: Any) -> Item:
    """The item of a scene in JSON."""
    name, inner = next(iter(data.items())) if isinstance(data, dict) else (data, {})
    kind: Any = next(kind for kind in base.__subclasses__() if kind.__name__ == name)
    if not isinstance(inner, dict):
        return kind(_value(inner, object))  # type: ignore[no-any-return]
    types = hints(kind)
    return kind(**{field: _value(one, types[field]) for field, one in inner.items()})  # type: ignore[no-any-return]


def _value(data: Any, hint: Any) -> Any:
    """A value in JSON, of a field of this type."""
    bases = [kind for kind in members(hint) if isinstance(kind, type) and issubclass(kind, Item)]
    # what stands in rows has no type: names there are names of loads, punches or layers
    bases = bases if bases or hint is not object else [Load, Punch, StackItem]
    is_item = isinstance(data, str) or isinstance(data, dict) and len(data) == 1 and next(iter(data))[0].isupper()
    if is_item:
        name = data if isinstance(data, str) else next(iter(data))
        for base in bases:
            if any(kind.__name__ == name for kind in base.__subclasses__()):
                return named(base, data)
    if isinstance(data, list):
        return [_value(one, object) for one in data]
    if isinstance(data, dict):
        records = [kind for kind in members(hint) if is_record(kind)]
        types = hints(records[0]) if records else {}
        return {name: _value(one, types.get(name, object)) for name, one in data.items()}
    return data
