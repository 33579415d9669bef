"""Values of fields: how they are kept, and how they are written in a scene."""

from __future__ import annotations

import dataclasses
import types
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple, TypeAlias, Union, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import NDArray

#: A number, or a text with a unit such as "26 GPa".
Number: TypeAlias = float | str | np.floating[Any] | np.integer[Any]
#: A row of a table: a number, some numbers, or values by name.
Row: TypeAlias = Number | Iterable[Number] | Mapping[str, object] | NDArray[np.floating[Any]] | NDArray[np.integer[Any]]
#: Rows of a table, such as `[(0.0, 1.0), (0.5, 2.0)]` or an array of two columns.
Rows: TypeAlias = Iterable[Row] | NDArray[np.floating[Any]] | NDArray[np.integer[Any]]


class Units(NamedTuple):
    """Labels of the units of a scene, such as `Units("mm", "N")`.

    Args:
        length: label of the unit of length.
        force: label of the unit of force.
    """

    length: str
    force: str


class PlacedLoad(NamedTuple):
    """One of several loads of a scene, such as `PlacedLoad(Uniform(half_width=0.2), at=1.0, force=0.8)`.

    Args:
        load: what presses there.
        at: where its middle is on x, in length; in axisymmetric scenes the place (x, y) of its axis.
        force: its resultant, force per unit length out of the plane.
    """

    load: Written
    at: Number | tuple[Number, Number]
    force: Number


class Pressed(NamedTuple):
    """One of several punches of a scene, such as `Pressed(Flat(half_width=0.5), at=3.0, force=0.001, tilt=Free(eccentricity=0.1))`.

    Args:
        shape: the punch.
        at: where its tip is on x, in length.
        force: the force on it, per unit length out of the plane.
        tilt: None if it cannot turn, `Fixed(angle)` if it is turned by a small angle, `Free(eccentricity=...)` if it turns freely.
        depth: in place of the force: how far it sinks, in length.
        left: in place of the force: where its contact begins on x, in length.
        right: in place of the force: where its contact ends on x, in length.
    """

    shape: Written
    at: Number
    force: Number | None = None
    tilt: Written | None = None
    depth: Number | None = None
    left: Number | None = None
    right: Number | None = None


class Written:
    """What has a text of its own in a scene."""

    __slots__ = ()

    def ron(self) -> str:
        """As it is written in a scene."""
        raise NotImplementedError


def is_record(kind: Any) -> bool:
    """Whether it is a tuple whose members have names."""
    return isinstance(kind, type) and issubclass(kind, tuple) and hasattr(kind, "_fields")


#: Types of fields that are known already, by class.
_KNOWN: dict[type, dict[str, Any]] = {}


def hints(kind: type) -> dict[str, Any]:
    """The types of the fields of a class."""
    if kind not in _KNOWN:
        _KNOWN[kind] = get_type_hints(kind)
    return _KNOWN[kind]


def members(hint: Any) -> tuple[Any, ...]:
    """The types that a type allows."""
    return get_args(hint) if get_origin(hint) in (Union, types.UnionType) else (hint,)


def kept(found: Any, hint: Any, what: str) -> Any:
    """A value of a field of this type as it is kept: plain numbers and tuples, and what has fields by their names.

    Fields may be given as a mapping, as an object of a dataclass, or in their order."""
    if found is None or isinstance(found, float | int | str | Written) and not isinstance(found, np.generic):
        return found
    record = next((kind for kind in members(hint) if is_record(kind)), None)
    of_list = next((get_args(kind)[0] for kind in members(hint) if get_origin(kind) is tuple), object)
    if dataclasses.is_dataclass(found) and not isinstance(found, type):
        found = {field.name: getattr(found, field.name) for field in dataclasses.fields(found)}
    elif is_record(type(found)):
        found = found._asdict()
    if isinstance(found, Mapping):
        if record is not None:
            return _record(record, (), found, what)
        return {_name(name, what): kept(one, object, f"{what}.{name}") for name, one in found.items()}
    if isinstance(found, np.ndarray | np.generic):
        found = found.tolist()
    if isinstance(found, int | float | str):
        return found
    if isinstance(found, Iterable) and not isinstance(found, bytes):
        if record is not None:
            return _record(record, tuple(found), {}, what)
        return tuple(kept(one, of_list, f"{what}[{place}]") for place, one in enumerate(found))
    raise TypeError(f"`{what}` cannot be {found!r}; numbers, texts such as '26 GPa', lists and items can be written in a scene")


def _record(record: Any, values: tuple[Any, ...], named: Mapping[str, Any], what: str) -> Any:
    types = hints(record)
    try:
        made = record(*values, **named)
    except TypeError:
        given = ", ".join(map(str, named)) if named else f"{len(values)} values"
        raise TypeError(f"`{what}` has the fields {', '.join(record._fields)}; found {given}") from None
    return record(*(kept(one, types[name], f"{what}.{name}") for name, one in zip(record._fields, made, strict=True)))


def _name(name: Any, what: str) -> str:
    if isinstance(name, str) and name.isidentifier():
        return name
    raise TypeError(f"`{what}` cannot have a field {name!r}")


def written(value: Any, in_list: bool = False) -> str:
    """A value that is kept, as it is written in a scene. A list within a list is a row."""
    if isinstance(value, Written):
        return value.ron()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return quoted(value)
    if isinstance(value, float):
        return "NaN" if value != value else repr(value)
    if is_record(type(value)):
        value = value._asdict()
    if isinstance(value, Mapping):
        return f"({', '.join(f'{name}: {written(one)}' for name, one in value.items() if one is not None)})"
    if isinstance(value, tuple):
        inner = ", ".join(written(one, not in_list) for one in value)
        return f"({inner})" if in_list else f"[{inner}]"
    return str(value)


def quoted(text: str) -> str:
    """A text in double quotes, whatever it contains."""
    signs = {'"': '\\"', "\\": "\\\\", "\n": "\\n"}
    shown = (signs.get(c) or (c if c.isprintable() or ord(c) > 0x9F else f"\\u{{{ord(c):x}}}") for c in text)
    return f'"{"".join(shown)}"'
