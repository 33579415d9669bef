"""Exceptions and warnings."""

from __future__ import annotations

import warnings as _warnings


class Error(Exception):
    """What went wrong, with the object in question, or the place in the text of a scene that was read.

    Attributes:
        message: what was found, and what is allowed.
        hint: what to do about it, or None.
        line, column: place in the text of the scene, from 1; None if it has none.
        excerpt: the line in question with a caret below the column, or the object, as written in Python; or None.
        file: name of the file that was read, or None.
    """

    message: str
    hint: str | None
    line: int | None
    column: int | None
    excerpt: str | None
    file: str | None

    def __init__(
        self,
        message: str,
        hint: str | None = None,
        line: int | None = None,
        column: int | None = None,
        excerpt: str | None = None,
        file: str | None = None,
    ) -> None:
        super().__init__(message, hint, line, column, excerpt, file)
        self.message, self.hint = message, hint
        self.line, self.column, self.excerpt, self.file = line, column, excerpt, file

    def __str__(self) -> str:
        where = f"{self.file}, " if self.file else ""
        place = "" if self.line is None else f" ({where}line {self.line}, column {self.column})"
        text = self.message + place
        if self.excerpt:
            text += "\n" + self.excerpt
        if self.hint:
            text += "\nhint: " + self.hint
        return text


class InputError(Error, ValueError):
    """Something that was given is not legal."""


class NoSolutionError(Error):
    """The scene is legal, but no admissible contact was found."""


class SolutionWarning(UserWarning):
    """What should be known about a solution. `code` stays the same when the sentence changes."""

    code: str

    def __init__(self, message: str, code: str = "") -> None:
        super().__init__(message)
        self.code = code


class Interrupted(KeyboardInterrupt):
    """A sweep was interrupted; `table` has the rows that were complete."""

    def __init__(self, message: str, table: object) -> None:
        super().__init__(message)
        self.table = table


def make(is_input: bool, message: str, **fields: object) -> Error:
    """The exception for an error of the library."""
    return (InputError if is_input else NoSolutionError)(message, **fields)  # type: ignore[arg-type]


def warn(all: list[tuple[str, str]]) -> None:
    """Hands over the warnings of a solution."""
    for code, message in all:
        _warnings.warn(SolutionWarning(message, code), stacklevel=2)


def warn_many(all: list[tuple[str, str, float]], kind: str, count: int) -> None:
    """Hands over the warnings of many solutions: each code once, with the range of numbers that it was told of."""
    for code in dict.fromkeys(code for code, _, _ in all):
        of_code = [(message, number) for found, message, number in all if found == code]
        numbers = [number for _, number in of_code]
        message, first = of_code[0]
        message = f"at {kind} = {first:g}: {message}"
        if len(of_code) > 1:
            message += f" (the like at {len(of_code)} of {count} values, from {min(numbers):g} to {max(numbers):g})"
        _warnings.warn(SolutionWarning(message, code), stacklevel=2)
