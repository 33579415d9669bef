"""Columns of numbers and texts."""

from __future__ import annotations

import csv
import os
import pathlib
import tempfile
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _html
from ._recede import arrow_stream

#: Rows that are shown in a notebook.
SHOWN = 20


class Columns(Mapping[str, Any]):
    """Rows of a sweep as columns: `table["force"]` is an array of doubles, `table["status"]` a list of texts.

    What a row does not have is NaN. Programs that know the Arrow PyCapsule interface take it as it is, without copies of numbers:
    `pyarrow.table(table)`, `polars.DataFrame(table)`, `pandas.DataFrame.from_arrow(table)` or
    `pyarrow.table(table).to_pandas()`.
    """

    #: The scene as a text, the version of the package and the tolerance, which files and other programs get, too.
    metadata: dict[str, str]

    def __init__(
        self, columns: Mapping[str, NDArray[np.float64] | list[str]], metadata: Mapping[str, str] | None = None
    ) -> None:
        self.columns = dict(columns)
        self.metadata = dict(metadata or {})

    def __getitem__(self, name: str) -> Any:
        return self.columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    @property
    def rows(self) -> int:
        """The number of rows."""
        return len(next(iter(self.columns.values()), []))

    @property
    def solved(self) -> NDArray[np.bool_]:
        """Which rows have a solution; the column `message` says why others have none."""
        return np.array([status == "solved" for status in self.columns["status"]], dtype=bool)

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """A stream of one batch, for other programs."""
        return arrow_stream(list(self.columns), list(self.columns.values()), self.metadata)

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """Writes comma-separated values as `recede sweep` does, to a temporary file that is then renamed."""

        def write(temporary: str) -> None:
            with open(temporary, "w", encoding="utf-8", newline="") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerow(self.columns)
                columns = [_written(column) for column in self.columns.values()]
                writer.writerows(zip(*columns, strict=True))

        _replace(path, write)

    def to_parquet(self, path: str | os.PathLike[str]) -> None:
        """Writes a Parquet file with the scene, the version and the tolerance in its metadata; needs `pyarrow`."""
        import pyarrow  # type: ignore[import-untyped, unused-ignore]
        import pyarrow.parquet  # type: ignore[import-untyped, unused-ignore]

        _replace(path, lambda temporary: pyarrow.parquet.write_table(pyarrow.table(self), temporary))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Columns) or list(self.columns) != list(other.columns):
            return False
        pairs = zip(self.columns.values(), other.columns.values(), strict=True)
        return all(np.array_equal(a, b, equal_nan=not isinstance(a, list)) for a, b in pairs)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<Columns: {self.rows} rows: {', '.join(self.columns)}>"

    def _repr_html_(self) -> str:
        rows = [[column[k] for column in self.columns.values()] for k in range(min(self.rows, SHOWN))]
        more = f"<p>{self.rows} rows in all</p>" if self.rows > SHOWN else ""
        return _html.table(list(self.columns), [[_plain(cell) for cell in row] for row in rows]) + more


def _replace(path: str | os.PathLike[str], write: Callable[[str], None]) -> None:
    """Writes a temporary file next to the one that is meant, and renames it."""
    path = pathlib.Path(path)
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=path.name, suffix=".part")
    os.close(handle)
    try:
        write(temporary)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


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
        parts = [table.columns[name] for table in tables]
        if isinstance(parts[0], list):
            return [text for part in parts for text in part]
        return np.concatenate(parts)

    return Columns({name: column(name) for name in tables[0].columns}, tables[0].metadata)
