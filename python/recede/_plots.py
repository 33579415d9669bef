"""Pictures on axes of matplotlib, which is imported when one is asked for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

#: Places along x and depths of a map of each layer.
PLACES = 201
DEPTHS = 81


def _axes(ax: Any) -> Any:
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt  # type: ignore[import-not-found, unused-ignore]

    return plt.subplots()[1]


def _label(name: str, unit: str) -> str:
    return f"{name}, {unit}" if unit else name


def pressures(profile: Mapping[str, Any], ax: Any, along: str, units: tuple[str, str]) -> Any:
    """The pressures of all contacts along x."""
    ax = _axes(ax)
    length, stress = units
    for name, values in profile.items():
        owner, found, _ = name.partition("_pressure")
        if found:
            known = np.where(np.isfinite(values), values, np.nan)
            ax.plot(profile["x"], known, label=owner.replace("contact_", "").replace("_", "|"))
    ax.set_xlabel(_label(along, length))
    ax.set_ylabel(_label("pressure", stress))
    ax.set_ylim(bottom=0.0)
    ax.legend()
    return ax


def field_map(field: Any, quantity: str, ax: Any, x: Any, depth: Any, along: str, unit: tuple[str, str]) -> Any:
    """A quantity in all layers, in colours, with the interfaces as lines."""
    (left, right), (top, bottom) = field.window()
    xs = np.linspace(left, right, PLACES) if x is None else np.asarray(x, dtype=float)
    depths = np.linspace(top, bottom, DEPTHS) if depth is None else np.asarray(depth, dtype=float)
    grids = field.by_layer(xs, depths)
    if quantity not in grids[0]:
        raise KeyError(f"there is no {quantity!r}; there are {', '.join(grids[0])}")
    values = [grid[quantity] for grid in grids]
    known = np.concatenate([value[np.isfinite(value)] for value in values])
    low, high = (known.min(), known.max()) if known.size else (0.0, 1.0)
    options: dict[str, Any] = {"vmin": low, "vmax": high, "cmap": "viridis"}
    if low < 0.0 < high:
        # what has both signs is white at zero
        options = {"vmin": -max(-low, high), "vmax": max(-low, high), "cmap": "RdBu_r"}
    ax = _axes(ax)
    for grid, value in zip(grids, values, strict=True):
        shown = np.ma.masked_invalid(value)
        mesh = ax.pcolormesh(grid["x"], grid["depth"], shown, shading="gouraud", rasterized=True, **options)
    for _, top, _ in field.layers[1:]:
        if depths.min() < top < depths.max():
            ax.axhline(top, color="black", linewidth=0.8)
    ax.set_xlim(xs.min(), xs.max())
    ax.set_ylim(depths.max(), depths.min())
    ax.set_xlabel(_label(along, unit[0]))
    ax.set_ylabel(_label("depth", unit[0]))
    ax.figure.colorbar(mesh, ax=ax, label=_label(quantity, unit[1]))
    return ax


def curves(table: Mapping[str, Any], x: str | None, y: str | Sequence[str] | None, ax: Any) -> Any:
    """Columns of a table over another one, points marked."""
    numbers = [name for name, column in table.items() if not isinstance(column, list)]
    if x is None:
        varied = [name for name in numbers if len(np.unique(table[name])) > 1]
        x = (varied or numbers)[0]
    if y is None:
        y = [name for name in numbers if name.endswith("_half_length") or name.endswith("_right")][:1] or numbers[-1:]
    names = [y] if isinstance(y, str) else list(y)
    for name in [x, *names]:
        if name not in numbers:
            raise KeyError(f"there is no column of numbers {name!r}; there are {', '.join(numbers)}")
    ax = _axes(ax)
    for name in names:
        ax.plot(table[x], table[name], marker=".", label=name)
    ax.set_xlabel(x)
    if len(names) == 1:
        ax.set_ylabel(names[0])
    else:
        ax.legend()
    return ax
