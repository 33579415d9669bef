"""Exceptions and warnings."""

from __future__ import annotations

import warnings as _warnings


class Error(Exception):
    """What went wrong, with the place in the scene's text if it is known.

    Attributes:
        message: what was found, and what is allowed.
        hint: what to do about it, or None.
        line, column: place in the text of the scene, from 1, or None.
        excerpt: the line in question with a caret below the column, or None.
    """

    message: str
    hint: str | None
    line: int | None
    column: int | None
    excerpt: str | None

    def __init__(
        self,
        message: str,
        hint: str | None = None,
        line: int | None = None,
        column: int | None = None,
        excerpt: str | None = None,
    ) -> None:
        super().__init__(message, hint, line, column, excerpt)
        self.message, self.hint = message, hint
        self.line, self.column, self.excerpt = line, column, excerpt

    def __str__(self) -> str:
        place = "" if self.line is None else f" (line {self.line}, column {self.column} of the scene)"
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
