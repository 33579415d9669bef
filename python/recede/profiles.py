"""Moduli and Poisson's ratios as functions of the depth, for `Graded`.

Written by make_items.py from the JSON Schema of scenes."""

from __future__ import annotations

from ._items import Profile
from ._values import Number, Row, Rows


class Constant(Profile):
    """The same at any depth.

    Args:
        value: Allowed: a finite number > 0.
    """

    __slots__ = ("value",)
    value: float | str

    def __init__(self, value: Number) -> None:
        self._set(value=value)


class Linear(Profile):
    """Linear from the top face to the bottom face.

    Args:
        top: Value at the top face. Allowed: a finite number > 0.
        bottom: Value at the bottom face. Allowed: a finite number > 0.
    """

    __slots__ = ("top", "bottom")
    top: float | str
    bottom: float | str

    def __init__(self, *, top: Number, bottom: Number) -> None:
        self._set(top=top, bottom=bottom)


class Power(Profile):
    """A power law, surface (1 + d/length)^exponent.

    Args:
        surface: Value at the top face. Allowed: a finite number > 0.
        length: Length over which the value varies first, in length. Allowed: a finite number > 0.
        exponent: Exponent m, dimensionless. Allowed: a finite number.
    """

    __slots__ = ("surface", "length", "exponent")
    surface: float | str
    length: float | str
    exponent: float | str

    def __init__(self, *, surface: Number, length: Number, exponent: Number) -> None:
        self._set(surface=surface, length=length, exponent=exponent)


class Exponential(Profile):
    """An exponential, surface exp(beta d).

    Args:
        surface: Value at the top face. Allowed: a finite number > 0.
        beta: Grading exponent, in 1/length; positive: larger with depth. Allowed: a finite number.
    """

    __slots__ = ("surface", "beta")
    surface: float | str
    beta: float | str

    def __init__(self, *, surface: Number, beta: Number) -> None:
        self._set(surface=surface, beta=beta)


class Sigmoid(Profile):
    """A smooth step, top + (bottom − top)/(1 + exp((centre − d)/width)).

    Args:
        top: Value far above the step. Allowed: a finite number > 0.
        bottom: Value far below the step. Allowed: a finite number > 0.
        centre: Depth of the middle of the step, in length. Allowed: a finite number.
        width: Width of the step, in length. Allowed: a finite number > 0.
    """

    __slots__ = ("top", "bottom", "centre", "width")
    top: float | str
    bottom: float | str
    centre: float | str
    width: float | str

    def __init__(self, *, top: Number, bottom: Number, centre: Number, width: Number) -> None:
        self._set(top=top, bottom=bottom, centre=centre, width=width)


class Table(Profile):
    """Values at depths from 0 down to the thickness or beyond, linear in between: `[(depth, value), ...]`.

    Args:
        rows: Allowed: [(depth, value), ...], two or more with increasing depths, the first 0.
    """

    __slots__ = ("rows",)
    rows: tuple[Row, ...]

    def __init__(self, rows: Rows) -> None:
        self._set(rows=rows)


class RelativeTable(Profile):
    """The same with depths in parts of the thickness, from 0 down to 1 or beyond: `[(depth/thickness, value), ...]`.

    Args:
        rows: Allowed: [(depth, value), ...], two or more with increasing depths, the first 0.
    """

    __slots__ = ("rows",)
    rows: tuple[Row, ...]

    def __init__(self, rows: Rows) -> None:
        self._set(rows=rows)


__all__ = [
    "Constant",
    "Exponential",
    "Linear",
    "Power",
    "Profile",
    "RelativeTable",
    "Sigmoid",
    "Table",
]
