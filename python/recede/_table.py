"""Columns of numbers and texts."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _html, _recede
from ._plots import curves

#: Rows that are shown in a notebook.
SHOWN = 20


class Columns(dict[str, Any]):
    """Columns by name: `table["force"]` is an array of doubles, `table["status"]` a list of texts. What a row does not have is NaN.

    It is a dictionary, which other programs make tables of: `pandas.DataFrame(table)`, `polars.DataFrame(table)`, and
    `pyarrow.table(table, metadata=table.metadata)`, which shares the memory of the numbers. Where `pyarrow` is installed, it has the Arrow
    PyCapsule interface, too.
    """

    #: The scene as a text, the version of the package and the tolerance, which files and other programs get, too.
    metadata: dict[str, str]

    def __init__(
        self, columns: Mapping[str, NDArray[np.float64] | list[str]], metadata: Mapping[str, str] | None = None
    ) -> None:
        super().__init__(columns)
        self.metadata = dict(metadata or {})

    @property
    def rows(self) -> int:
        """The number of rows."""
        return len(next(iter(self.values()), []))

    @property
    def solved(self) -> NDArray[np.bool_]:
        """Which rows have a solution; the column `message` says why others have none."""
        return np.array([status == "solved" for status in self["status"]], dtype=bool)

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """A stream of one batch, for other programs; needs `pyarrow`."""
        return self._arrow().__arrow_c_stream__(requested_schema)

    def _arrow(self) -> Any:
        import pyarrow  # type: ignore[import-untyped, unused-ignore]

        return pyarrow.table(dict(self), metadata=self.metadata)

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """Writes comma-separated values as `recede sweep` does. A regular file appears when it is complete, and keeps its permissions."""
        file = io.StringIO()
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(self)
        columns = [_written(column) for column in self.values()]
        writer.writerows(zip(*columns, strict=True))
        _recede.replace(os.fspath(path), file.getvalue().encode())

    def to_parquet(self, path: str | os.PathLike[str]) -> None:
        """Writes a Parquet file with the scene, the version and the tolerance in its metadata; needs `pyarrow`."""
        import pyarrow.parquet  # type: ignore[import-untyped, unused-ignore]

        file = io.BytesIO()
        pyarrow.parquet.write_table(self._arrow(), file)
        _recede.replace(os.fspath(path), file.getvalue())

    def to_pandas(self) -> Any:
        """The table as a data frame; needs `pandas`."""
        import pandas  # type: ignore[import-untyped, unused-ignore]

        frame = pandas.DataFrame(self)
        frame.attrs.update(self.metadata)
        return frame

    def plot(self, x: str | None = None, y: str | Sequence[str] | None = None, ax: Any = None) -> Any:
        """Draws columns over another one with `matplotlib`, points marked, and returns the axes.

        Args:
            x: the column along x; the first one that varies if not given.
            y: one column or several; how far the first contact reaches if not given.
            ax: axes to draw on; new ones if not given.
        """
        return curves(self, x, y, ax)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Columns) or list(self) != list(other):
            return False
        pairs = zip(self.values(), other.values(), strict=True)
        return all(np.array_equal(a, b, equal_nan=not isinstance(a, list)) for a, b in pairs)

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __repr__(self) -> str:
        return f"<Columns: {self.rows} rows: {', '.join(self)}>"

    def _repr_html_(self) -> str:
        rows = [[column[k] for column in self.values()] for k in range(min(self.rows, SHOWN))]
        more = f"<p>{self.rows} rows in all</p>" if self.rows > SHOWN else ""
        return _html.table(list(self), [[_plain(cell) for cell in row] for row in rows]) + more


def _plain(cell: Any) -> Any:
    return float(cell) if isinstance(cell, np.floating) else cell


def _written(column: NDArray[np.float64] | list[str]) -> list[str]:
    if isinstance(column, list):
        return column
    # as the command writes numbers: all digits, and nothing for what is not there
    return [_number(number) for number in column.tolist()]


def _number(number: float) -> str:
    if not np.isfinite(number):
        return ""
    text = repr(number)
    mantissa, _, exponent = text.partition("e")
    return f"{mantissa}e{int(exponent)}" if exponent else text


def joined(tables: list[Columns]) -> Columns:
    """Tables of the same columns one below the other."""

    def column(name: str) -> NDArray[np.float64] | list[str]:
        parts = [table[name] for table in tables]
        if isinstance(parts[0], list):
            return [text for part in parts for text in part]
        return np.concatenate(parts)

    return Columns({name: column(name) for name in tables[0]}, tables[0].metadata)
