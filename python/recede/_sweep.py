"""Sweeps: a scene for many values of some of its numbers."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Mapping, Sequence
from contextlib import nullcontext
from typing import Any

from ._arrays import line
from ._errors import Interrupted
from ._recede import Rows, Scene, __version__
from ._table import Columns, joined

#: Tasks per worker of an executor: some, so that none waits long for the others.
TASKS = 8
#: Parts after which progress is shown.
SHOWN = 100
#: Rows of a task at least, unless it is told: fewer do not outweigh the way to another process.
LEAST = 50


def sweep(
    scene: Scene,
    vary: Mapping[str, Iterable[float]] | None = None,
    *,
    rows: Any = None,
    approach: bool = False,
    extremes: bool = False,
    at: Sequence[str] = (),
    progress: bool = False,
    tolerance: float = 1e-10,
    threads: int | None = None,
    executor: Any = None,
    chunk: int | None = None,
) -> Columns:
    """Solves a scene for all combinations of some values of its numbers, those given last changing first; or for each row of a table of values.

    Args:
        scene: the scene.
        vary: values by path, such as `{"force": numpy.linspace(1, 10, 10), "layer[1].thickness": [1, 2]}`; `scene.paths` lists paths.
        rows: in place of `vary` a table, each row of which is solved: a data frame, or anything else with columns by path.
        approach: adds the approach of the punch (length) and the stiffness.
        extremes: adds the stresses and strains by which layers and bonds break.
        at: adds stresses, strains or displacements at points, such as `"0,0.2@1=eps_xx"`: x, depth and layer, and a name of `Field.at`.
        progress: shows how far the sweep has come, by `tqdm` if it is there, or else on standard error; not with an executor.
        tolerance: relative error to aim at, 1e-13 to 1e-2.
        threads: threads that compute; as many as there are processors if not given. With an executor: threads of each task, 1 if
            not given.
        executor: anything with the interface of `concurrent.futures`, such as a process pool, or a client of `dask.distributed`.
        chunk: rows of a task of the executor.

    Returns:
        A table with the columns that `recede sweep` writes. A row without solution says why in the column `message`.

    Raises:
        InputError: if there is no number at a path, a value is not legal for it, or columns of `rows` differ in length.
        ValueError: if neither `vary` nor `rows` is given, or both are.
        Interrupted: if interrupted from the keyboard; its `table` has the rows that were complete.
    """
    if not isinstance(scene, Scene):
        raise TypeError(f"a sweep is one of a `Scene`, not of {scene!r}")
    in_step = rows is not None
    if in_step and vary:
        raise ValueError("either `vary` or `rows`, not both")
    columns = {str(path): rows[path] for path in getattr(rows, "columns", rows)} if in_step else vary
    if not columns:
        raise ValueError(f"nothing varies; what can vary in this scene: {', '.join(scene.paths)}")
    axes = [(path, line(list(values), path).tolist()) for path, values in columns.items()]
    rows = Rows(scene, axes, in_step, tolerance, (approach, extremes, list(at)))
    metadata = {"scene": scene.to_ron(), "version": __version__, "tolerance": repr(tolerance)}
    if executor is None:
        table, complete = _all(rows, metadata, threads or os.cpu_count() or 1, SHOWN if progress else 1)
        if not complete:
            raise Interrupted(f"interrupted after {table.rows} of {len(rows)} rows", table)
        return table
    what = (metadata["scene"], axes, in_step, tolerance, (approach, extremes, list(at)))
    size = chunk or max(LEAST, -(-len(rows) // (TASKS * (os.cpu_count() or 1))))
    return _by_executor(executor, what, rows, metadata, size, threads or 1)


def _all(rows: Rows, metadata: Mapping[str, str], threads: int, parts: int) -> tuple[Columns, bool]:
    count = len(rows)
    size = max(-(-count // parts), 1)
    done: list[Columns] = []
    with _bar(count) if parts > 1 else nullcontext() as bar:
        for first in range(0, count, size):
            numbers, texts, complete = rows.run(first, min(first + size, count), threads)
            done.append(_table(rows, metadata, [*numbers, *texts]))
            if bar:
                bar.update(done[-1].rows)
            if not complete:
                break
    return joined(done), complete


class _Lines:
    """How far a sweep has come, in one line on standard error."""

    def __init__(self, total: int) -> None:
        self._total, self._done = total, 0

    def update(self, rows: int) -> None:
        self._done += rows
        print(f"\r{self._done} of {self._total} rows", end="", file=sys.stderr, flush=True)

    def __enter__(self) -> _Lines:
        return self

    def __exit__(self, *_: object) -> None:
        print(file=sys.stderr)


def _bar(total: int) -> Any:
    try:
        from tqdm.auto import tqdm  # type: ignore[import-untyped, import-not-found, unused-ignore]
    except ImportError:
        return _Lines(total)
    return tqdm(total=total, unit="row")


def _table(rows: Rows, metadata: Mapping[str, str], columns: list[Any]) -> Columns:
    count = len(columns[0])
    return Columns(dict(zip(rows.names, [*columns, [rows.fingerprint] * count], strict=True)), metadata)


def _task(what: tuple[Any, ...], first: int, last: int, threads: int) -> list[Any]:
    """Some rows of a sweep in another process: the columns alone, since what they are called is known."""
    text, *others = what
    rows = Rows(Scene.from_ron(text), *others)
    numbers, texts, complete = rows.run(first, last, threads)
    if not complete:
        raise KeyboardInterrupt
    return [*numbers, *texts]


def _by_executor(
    executor: Any, what: tuple[Any, ...], rows: Rows, metadata: Mapping[str, str], size: int, threads: int
) -> Columns:
    count = len(rows)
    starts = range(0, count, size)
    futures = [executor.submit(_task, what, first, min(first + size, count), threads) for first in starts]
    try:
        parts = [_table(rows, metadata, future.result()) for future in futures]
    except KeyboardInterrupt:
        for future in futures:
            future.cancel()
        done = [_table(rows, metadata, future.result()) for future in futures if _is_there(future)]
        table = joined(done) if done else _table(rows, metadata, [[] for _ in rows.names[:-1]])
        raise Interrupted(f"interrupted after {table.rows} of {count} rows", table) from None
    return joined(parts)


def _is_there(future: Any) -> bool:
    return future.done() and not future.cancelled() and future.exception() is None
