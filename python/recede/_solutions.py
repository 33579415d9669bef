"""Solutions for many forces, and the intervals of contacts."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple, SupportsIndex, overload

import numpy as np
from numpy.typing import NDArray

from ._errors import Error
from ._recede import Contact, Solution


class Interval(NamedTuple):
    """An interval in which the bodies of a contact touch, in length, with the force on it and where that acts."""

    left: float
    right: float
    left_error: float
    right_error: float
    force: float
    centroid: float


class Carried(NamedTuple):
    """What one of several punches, or one that is turned or not at x = 0, carries: force and moment about its tip per unit length out of the plane, the
    angle by which it is turned, and how far its tip has moved down, None where that is not defined.
    """

    force: float
    tilt: float
    moment: float
    approach: float | None
    approach_error: float | None


class Opening(NamedTuple):
    """An interval in which two layers that are pressed together far away are apart, in length, with the largest gap and its place."""

    left: float
    right: float
    left_error: float
    right_error: float
    largest_gap: float
    largest_gap_at: float


class ClosedInterface(NamedTuple):
    """An interface that weights, or a pressure on top, keep closed but for openings: its name, its pressure far away, its pressure at x = 0, and the
    smallest pressure outside openings with its place, in stress and length.
    """

    interface: str
    weight: float
    central_pressure: float
    central_pressure_error: float
    smallest_pressure: float
    smallest_at: float
    openings: tuple[Opening, ...]


class Separation(NamedTuple):
    """When layers that weights press together begin to come apart: the force, per unit length out of the plane, the interface, and the place."""

    critical_force: float
    critical_force_error: float
    interface: str
    x: float


class Contacts(tuple[Contact, ...]):
    """Contacts from the top down, by number from 0, or by name: `contacts["punch"]`, `contacts["2|3"]`."""

    __slots__ = ()

    @overload
    def __getitem__(self, which: SupportsIndex | str) -> Contact: ...
    @overload
    def __getitem__(self, which: slice) -> tuple[Contact, ...]: ...
    def __getitem__(self, which: Any) -> Any:
        if not isinstance(which, str):
            return super().__getitem__(which)
        for contact in self:
            if contact.interface == which:
                return contact
        raise KeyError(f"there is no contact {which!r}; there are {', '.join(contact.interface for contact in self)}")


class Solutions:
    """Solutions for many forces, in the order in which these were given. A force without a solution raises its error when it is
    asked for, and is NaN in arrays."""

    def __init__(self, found: list[Solution | Error], numbers: NDArray[np.float64]) -> None:
        self._found = found
        self._shape = numbers.shape

    @property
    def errors(self) -> list[Error | None]:
        """For each force why there is no solution, or None."""
        return [one if isinstance(one, BaseException) else None for one in self._found]

    def __len__(self) -> int:
        return len(self._found)

    def __getitem__(self, index: int) -> Solution:
        found = self._found[index]
        if isinstance(found, BaseException):
            raise found
        return found

    def __iter__(self) -> Iterator[Solution]:
        return (self[index] for index in range(len(self)))

    def _array(self, of: Callable[[Solution], float | None]) -> NDArray[np.float64]:
        values = [np.nan if isinstance(one, BaseException) else of(one) for one in self._found]
        return np.array([np.nan if value is None else value for value in values], dtype=float).reshape(self._shape)

    def _of_contact(self, contact: int | str, of: Callable[[Contact], float | None]) -> NDArray[np.float64]:
        return self._array(lambda one: of(one.contacts[contact]))

    @property
    def force(self) -> NDArray[np.float64]:
        """Forces, in force per length (plane scenes) or force (axisymmetric ones)."""
        return self._array(lambda one: one.force)

    @property
    def approach(self) -> NDArray[np.float64]:
        """How far the punch has sunk, in length; NaN where that is not defined."""
        return self._array(lambda one: one.approach)

    @property
    def stiffness(self) -> NDArray[np.float64]:
        """The derivative of the force with respect to the approach; NaN where it is not known."""
        return self._array(lambda one: one.stiffness)

    def half_length(self, contact: int | str = 0) -> NDArray[np.float64]:
        """Half-lengths of a contact, in length; NaN for several intervals. Contacts are counted from 0 at the punch, or named, as in
        `half_length("1|2")`."""
        return self._of_contact(contact, lambda one: one.half_length)

    def central_pressure(self, contact: int | str = 0) -> NDArray[np.float64]:
        """Pressures at x = 0, in stress."""
        return self._of_contact(contact, lambda one: one.central_pressure)

    def peak_pressure(self, contact: int | str = 0) -> NDArray[np.float64]:
        """Largest pressures, in stress."""
        return self._of_contact(contact, lambda one: one.peak_pressure)

    def __repr__(self) -> str:
        failed = sum(isinstance(one, BaseException) for one in self._found)
        return f"<Solutions: {len(self)}, {failed} of them without solution>"
