"""Numbers from Python's values, checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

_NUMBERS = "fiu"


def numbers(values: Any, name: str) -> NDArray[np.float64]:
    """An array of doubles; not of texts, truth values, complex numbers or anything else."""
    found = np.asarray(values)
    if found.dtype.kind not in _NUMBERS:
        raise TypeError(f"`{name}` has to be a number or an array of numbers, not {_kind(values, found)}")
    return np.ascontiguousarray(found, dtype=np.float64).reshape(found.shape)


def _kind(values: Any, found: NDArray[Any]) -> str:
    if isinstance(values, str | bytes):
        return f"the text {values!r}"
    if found.dtype == object:
        wrong = [value for value in found.ravel() if not isinstance(value, int | float)]
        return f"one with {wrong[0]!r} in it" if wrong else f"{type(values).__name__}"
    return f"an array of {found.dtype}" if found.ndim else f"{values!r}"


def places(x: Any, depth: Any, y: Any) -> list[NDArray[np.float64]]:
    """Places and depths of the same shape."""
    given = {name: numbers(values, name) for name, values in (("x", x), ("depth", depth), ("y", y))}
    try:
        fitted = np.broadcast_arrays(*given.values())
    except ValueError:
        shapes = [f"`{name}` of shape {values.shape}" for name, values in given.items() if values.shape or name != "y"]
        raise ValueError(f"{' and '.join(shapes)} do not fit together") from None
    return [np.ascontiguousarray(one).reshape(one.shape) for one in fitted]


def line(values: Any, name: str) -> NDArray[np.float64]:
    """An array of one dimension."""
    found = numbers(values, name)
    if found.ndim != 1:
        raise ValueError(f"`{name}` has to be an array of one dimension, not of shape {found.shape}")
    return found


class Fields(Mapping[str, Any]):
    """Stresses and displacements by name: `fields["sigma_xx"]` or `fields.sigma_xx`, arrays of the shape that was asked for, and with them
    the places `x`, `depth` and `layer`."""

    def __init__(self, columns: Mapping[str, Any]) -> None:
        self._columns = dict(columns)

    def __getitem__(self, name: str) -> Any:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self._columns[name]
        except KeyError:
            raise AttributeError(f"there is no {name!r}; there are {', '.join(self)}") from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self]

    def __repr__(self) -> str:
        return f"Fields({', '.join(f'{name}={value!r}' for name, value in self.items())})"


def fields(columns: Mapping[str, NDArray[Any]], shape: tuple[int, ...]) -> Fields:
    """Columns in the shape that was asked for; numbers where that has no dimension."""
    columns = {**columns, "layer": columns["layer"].astype(np.int64)}
    shaped = {name: column.reshape(shape) for name, column in columns.items()}
    return Fields({name: value.item() if shape == () else value for name, value in shaped.items()})
