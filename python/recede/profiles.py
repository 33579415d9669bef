"""Moduli and Poisson's ratios as functions of the depth, for `Graded`.

Written by make_items.py from the JSON Schema of scenes."""

from __future__ import annotations

from typing import Any

from ._text import Item


class Profile(Item):
    """A function of the depth d below the top face of a layer."""

    __slots__ = ()


class Constant(Profile):
    """The same at any depth.

    Args:
        rows: Allowed: a finite number > 0.
    """

    __slots__ = ()

    def __init__(self, rows: Any) -> None:
        super().__init__(rows=rows)


class Linear(Profile):
    """Linear from the top face to the bottom face.

    Args:
        top: Value at the top face. Allowed: a finite number > 0.
        bottom: Value at the bottom face. Allowed: a finite number > 0.
    """

    __slots__ = ()

    def __init__(self, *, top: Any, bottom: Any) -> None:
        super().__init__(top=top, bottom=bottom)


class Power(Profile):
    """A power law, surface (1 + d/length)^exponent.

    Args:
        surface: Value at the top face. Allowed: a finite number > 0.
        length: Length over which the value varies first, in length. Allowed: a finite number > 0.
        exponent: Exponent m, dimensionless. Allowed: a finite number.
    """

    __slots__ = ()

    def __init__(self, *, surface: Any, length: Any, exponent: Any) -> None:
        super().__init__(surface=surface, length=length, exponent=exponent)


class Exponential(Profile):
    """An exponential, surface exp(beta d).

    Args:
        surface: Value at the top face. Allowed: a finite number > 0.
        beta: Grading exponent, in 1/length; positive: larger with depth. Allowed: a finite number.
    """

    __slots__ = ()

    def __init__(self, *, surface: Any, beta: Any) -> None:
        super().__init__(surface=surface, beta=beta)


class Sigmoid(Profile):
    """A smooth step, top + (bottom − top)/(1 + exp((centre − d)/width)).

    Args:
        top: Value far above the step. Allowed: a finite number > 0.
        bottom: Value far below the step. Allowed: a finite number > 0.
        centre: Depth of the middle of the step, in length. Allowed: a finite number.
        width: Width of the step, in length. Allowed: a finite number > 0.
    """

    __slots__ = ()

    def __init__(self, *, top: Any, bottom: Any, centre: Any, width: Any) -> None:
        super().__init__(top=top, bottom=bottom, centre=centre, width=width)


class Table(Profile):
    """Values at depths from 0 down to the thickness or beyond, linear in between: `[(depth, value), ...]`.

    Args:
        rows: Allowed: [(depth, value), ...], two or more with increasing depths, the first 0.
    """

    __slots__ = ()

    def __init__(self, rows: Any) -> None:
        super().__init__(rows=rows)


__all__ = [
    "Constant",
    "Exponential",
    "Linear",
    "Power",
    "Profile",
    "Sigmoid",
    "Table",
]
