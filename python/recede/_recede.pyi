"""Compiled part of `recede`."""

import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any, final, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Fields
from ._items import Item, Load, Punch, Tilt
from ._solutions import Carried, ClosedInterface, Contacts, Interval, Separation, Solutions
from ._table import Columns
from ._text import Stack
from ._values import PlacedLoad, Pressed, Units

__all__ = [
    "CompiledTop",
    "Contact",
    "Field",
    "Model",
    "Rows",
    "Scene",
    "Solution",
    "__version__",
    "examine",
    "replace",
    "schema",
]

__version__: str

@final
class Scene:
    """What is pressed by what: a stack, a punch or a load, and a force.

    Args:
        stack: a `Stack`, or its items from the top down.
        punch: such as `Cylinder(radius=500)`; its tip is at x = 0.
        force: the force, per unit length out of the plane, or the whole force in axisymmetric scenes; a number > 0.
        punches: in place of punch and force: several punches, each with the place of its tip on x, its force, and a tilt if it is turned,
            such as `[(Cylinder(radius=100), 0.0, 0.002), (Flat(half_width=0.5), 3.0, 0.001, Free(eccentricity=0.1))]`.
        load: a pressure that is given, in place of the punch.
        loads: in place of punch and force: several loads, each with the place of its middle on x and its force, such as
            `[(Line(), -0.5, 0.2), (Uniform(half_width=0.2), 1.0, 0.8)]`.
        half_length: in place of the force: the half-length (radius) of the contact under the punch, in length.
        depth: in place of the force: how far the punch sinks, in length.
        pressure_on_top: a pressure everywhere on the top face, also under a punch, >= 0, in stress.
        geometry: "PlaneStrain", "PlaneStress" or "Axisymmetric"; a `Stack` brings its own.
        name: a name for reports.
        description: what the scene shows.
        units: labels of the units of length and force, such as `Units("mm", "N")`, `("mm", "N")` or
            `{"length": "mm", "force": "N"}`; numbers may then be texts, such as "26 GPa".

    Raises:
        InputError: with the object in question and a hint, if something is not legal.
    """

    def __new__(
        cls,
        stack: Stack | Iterable[Item],
        punch: Punch | None = None,
        force: float | str | None = None,
        *,
        punches: Iterable[Pressed | tuple[Punch, float, float] | tuple[Punch, float, float, Tilt | None] | Mapping[str, object]] | None = None,
        load: Load | None = None,
        loads: Iterable[PlacedLoad | tuple[Load, float | tuple[float, float], float] | Mapping[str, object]] | None = None,
        half_length: float | str | None = None,
        depth: float | str | None = None,
        pressure_on_top: float | str | None = None,
        geometry: str | None = None,
        name: str | None = None,
        description: str | None = None,
        units: Units | tuple[str, str] | Mapping[str, str] | None = None,
    ) -> Scene: ...
    @staticmethod
    def from_ron(text: str) -> Scene:
        """A scene from a text in RON."""

    @staticmethod
    def from_json(text: str) -> Scene:
        """A scene from a text in JSON."""

    @staticmethod
    def read(path: str | os.PathLike[str]) -> Scene:
        """A scene from a file in RON or JSON.

        Raises:
            OSError: such as `FileNotFoundError`, if the file cannot be read.
            InputError: with file, line and a hint, if something in it is not legal.
        """

    def to_ron(self) -> str:
        """The scene as a text in RON."""

    def to_json(self) -> str:
        """The scene as a text in JSON."""

    @property
    def name(self) -> str:
        """What the scene is called in reports."""

    @property
    def description(self) -> str | None:
        """What the scene shows, or None."""
    @property
    def units(self) -> Units | None:
        """Labels of the units, or None."""
    @property
    def geometry(self) -> str:
        """"PlaneStrain", "PlaneStress" or "Axisymmetric"."""

    @property
    def stack(self) -> Stack:
        """The stack."""
    @property
    def punch(self) -> Punch | None:
        """The punch; None where others, or a load, take its place."""
    @property
    def punches(self) -> tuple[Pressed, ...] | None:
        """The punches, where they are several, or one away from x = 0 or tilted, with their places, forces and tilts; or None."""
    @property
    def load(self) -> Load | None:
        """The load in place of a punch, or None."""
    @property
    def loads(self) -> tuple[PlacedLoad, ...] | None:
        """The loads in place of a punch, where they are several, with their places and forces; or None."""
    @property
    def force(self) -> float | None:
        """The force; None where a half-length or a depth is given."""
    @property
    def pressure_on_top(self) -> float:
        """The pressure everywhere on the top face, in stress; 0 if there is none."""
    @property
    def paths(self) -> list[str]:
        """The paths of all numbers that may vary, such as "force" and "layer[2].beta"."""

    def number(self, path: str) -> float:
        """The number at a path, in the units of the scene."""

    def with_number(self, path: str, value: float) -> Scene:
        """The same scene with another number at a path."""

    def solve(self, *, tolerance: float = 1e-10) -> Solution:
        """Solves the scene.

        Args:
            tolerance: relative error to aim at, 1e-13 to 1e-2.

        Raises:
            NoSolutionError: if no admissible contact was found.
        """

    def _repr_html_(self, *, top: bool = True) -> str | None:
        """The drawing of `recede check`, for notebooks, which show the text of the scene where it cannot be drawn."""
    def __copy__(self) -> Scene: ...
    def __deepcopy__(self, _memo: object) -> Scene: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Model:
    """A stack with its kernels: serves any punch and any force.

    Args:
        stack: a `Stack`, or a `Scene`, of which the stack is taken.
        many_loads: keeps solutions at fixed forces and interpolates between them, for thousands of forces under one punch.
    """

    def __new__(cls, stack: Stack | Scene, *, many_loads: bool = False) -> Model: ...
    @overload
    def press(self, punch: Punch | Load, force: float, *, tolerance: float = 1e-10) -> Solution: ...
    @overload
    def press(self, punch: Punch | Load, force: ArrayLike, *, tolerance: float = 1e-10) -> Solutions: ...
    @overload
    def press(
        self,
        punch: Punch | Load,
        force: None = None,
        *,
        half_length: float | None = None,
        depth: float | None = None,
        tolerance: float = 1e-10,
    ) -> Solution: ...
    @overload
    def press(
        self,
        punch: Punch | Load,
        force: None = None,
        *,
        half_length: ArrayLike | None = None,
        depth: ArrayLike | None = None,
        tolerance: float = 1e-10,
    ) -> Solutions:
        """Presses a punch, or a load, on the stack; other threads of Python go on meanwhile.

        Args:
            punch: such as `Cylinder(radius=500)`, or a load such as `Uniform(half_width=1)`.
            force: force per unit length out of the plane, or the whole force in axisymmetric stacks; a number, or an array of them, in
                which a number that is not legal, or has no solution, has an error of its own.
            half_length: in place of the force: half-length (radius) of the contact under the punch, in length.
            depth: in place of the force: how far the punch sinks, in length.
            tolerance: relative error to aim at, 1e-13 to 1e-2.

        Raises:
            InputError: if a number is not legal.
            NoSolutionError: if no admissible contact was found.
        """

    def field(self, solution: Solution) -> Field:
        """Stresses and displacements, for a solution of this stack."""

    @property
    def geometry(self) -> str:
        """"PlaneStrain", "PlaneStress" or "Axisymmetric"."""

    def _repr_html_(self) -> str: ...
    def __copy__(self) -> Model: ...
    def __deepcopy__(self, _memo: object) -> Model: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Solution:
    """A solved scene. In a notebook it shows a table and the picture."""

    @property
    def scene(self) -> Scene:
        """The scene that was solved."""
    @property
    def punch(self) -> Punch | None:
        """The punch that presses; None where a load takes its place."""
    @property
    def load(self) -> Load | None:
        """The load in place of a punch, or None."""
    @property
    def loads(self) -> tuple[PlacedLoad, ...] | None:
        """The loads in place of a punch, where they are several, with their places and forces; or None."""
    @property
    def contacts(self) -> Contacts:
        """The contacts from the top down, the punch first; `contacts["2|3"]` is the one between the layers 2 and 3."""

    @property
    def force(self) -> float:
        """The force that presses, per unit length out of the plane, or the whole force in axisymmetric scenes."""

    @property
    def force_error(self) -> float:
        """Estimate of its absolute error; 0 if it was given."""

    @property
    def tolerance(self) -> float:
        """The relative error that was aimed at."""

    @property
    def approach(self) -> float | None:
        """How far the punch has sunk, in length; None where that is not defined, such as over a half-plane in plane scenes."""

    @property
    def approach_error(self) -> float | None:
        """Estimate of its absolute error."""

    @property
    def stiffness(self) -> float | None:
        """The derivative of the force with respect to the approach; None where it is not known."""

    @property
    def stiffness_error(self) -> float | None:
        """Estimate of its absolute error."""

    @property
    def carried(self) -> list[Carried]:
        """What each punch carries, from left to right; none for loads, and for one punch at x = 0 that is not turned."""

    @property
    def closed(self) -> list[ClosedInterface]:
        """The interfaces that weights, or a pressure on top, keep closed but for openings, from the top down; they are no contacts."""

    @property
    def separation(self) -> Separation | None:
        """When layers that weights press together begin to come apart, if all forces are scaled together; or None."""

    @property
    def rotations(self) -> list[float]:
        """The angles by which the layers above each receding interface are turned: the means of their slopes far to the left and far to the right."""

    @property
    def min_pressure(self) -> float:
        """Smallest pressure found inside the contacts, in stress."""

    @property
    def min_gap(self) -> float:
        """Smallest gap found outside the contacts, in length."""

    @property
    def modes(self) -> int:
        """Largest number of modes of a pressure."""

    @property
    def wavenumbers(self) -> int:
        """Number of wavenumbers at which the stack was evaluated."""

    @property
    def newton_steps(self) -> int:
        """Newton steps taken."""

    @property
    def seconds(self) -> float:
        """The time that it took, without the kernels of the stack."""

    @property
    def warnings(self) -> list[tuple[str, str]]:
        """(code, sentence) of each warning; they were handed to Python's `warnings`, too."""

    def field(self) -> Field:
        """Stresses and displacements."""

    def profile(self, to: float | None = None, *, points: int = 400) -> Columns:
        """Pressures and gaps of all contacts, displacements and slopes of all faces, along x: a table with the columns of `recede profile`,
        at places that are dense next to the ends of the contacts. Infinite beyond the edge of a punch.

        Args:
            to: how far to go on both sides, in length; twice as far as the bodies touch if not given.
            points: how many places, about.
        """
    def plot(self, ax: Any = None) -> Any:
        """Draws the pressures of all contacts with `matplotlib`, and returns the axes.

        Args:
            ax: axes to draw on; new ones if not given.
        """

    def to_json(self, *, max_shear: bool = False, extremes: bool = False) -> str:
        """All numbers as JSON, as `recede solve --format json` writes them.

        Args:
            max_shear: with the largest shear stress, see `Field.max_shear`.
            extremes: with the stresses by which layers and bonds break, see `Field.extremes`.
        """

    def svg(self) -> str:
        """The stack to scale with its contacts, and the pressures below it, as SVG."""

    def png(self) -> bytes:
        """The same as PNG."""

    def _repr_svg_(self) -> str: ...
    def _repr_html_(self) -> str: ...
    def __copy__(self) -> Solution: ...
    def __deepcopy__(self, _memo: object) -> Solution: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    __hash__: None  # type: ignore[assignment]

@final
class Contact:
    """One contact of a solution. Pressures are positive in compression."""

    @property
    def interface(self) -> str:
        """Which contact: "punch" (or "load"), or "2|3" between the layers 2 and 3."""

    @property
    def half_length(self) -> float | None:
        """Half-length (radius) of a contact that is one interval, in length; None if it is none, or several."""

    @property
    def half_length_error(self) -> float | None:
        """Estimate of its absolute error."""

    @property
    def reach(self) -> float:
        """As far as the bodies touch, in length."""

    @property
    def central_pressure(self) -> float:
        """Pressure at x = 0, in stress; infinite under a sharp tip."""

    @property
    def central_pressure_error(self) -> float:
        """Estimate of its absolute error."""

    @property
    def resultant(self) -> float:
        """Resultant of the pressure."""

    @property
    def peak_pressure(self) -> float:
        """Largest pressure, in stress."""

    @property
    def peak_pressure_error(self) -> float:
        """Estimate of its absolute error."""

    @property
    def peak_at(self) -> float:
        """Where it is, x >= 0, in length."""

    @property
    def intervals(self) -> list[Interval]:
        """All intervals in which the bodies touch, from left to right."""

    @overload
    def pressure(self, x: float) -> float: ...
    @overload
    def pressure(self, x: ArrayLike) -> NDArray[np.float64]:
        """Pressure at places x, in stress; 0 outside the contact, NaN where x is NaN."""

    @overload
    def gap(self, x: float) -> float: ...
    @overload
    def gap(self, x: ArrayLike) -> NDArray[np.float64]:
        """How far the bodies are apart at places x, in length; 0 where they touch, NaN where x is NaN."""

    def __eq__(self, other: object, /) -> bool: ...
    __hash__: None  # type: ignore[assignment]

@final
class Field:
    """Stresses and displacements inside a stack, stresses positive in tension."""

    def at(self, x: ArrayLike, depth: ArrayLike, layer: int | None = None, *, y: ArrayLike | None = None) -> Fields:
        """Stresses and displacements at points.

        Args:
            x: places along the layers (distances from the axis), in length.
            depth: depths below the top face, in length; in the shape of `x`, or one that fits to it.
            layer: number of the layer from the top, from 1, on an interface; the layer below if not given.
            y: the other coordinate along the layers, in length, under loads at several places (x, y).
        """

    def at_y(self, y: float) -> Field:
        """The same field in the vertical plane at this y, in which points without a y are then, grids and maps, under loads at several
        places (x, y).
        """

    def grid(self, x: ArrayLike, depth: ArrayLike, layer: int | None = None) -> Fields:
        """The same on a grid: arrays with a row for each depth, faster than one by one; on interfaces of this layer, if it is given."""

    def by_layer(self, x: ArrayLike, depth: ArrayLike) -> list[Fields]:
        """The same layer by layer, on grids that reach the faces of layers, since stresses along the layers jump there: a list."""

    @property
    def layers(self) -> list[tuple[int, float, float]]:
        """The layers, from the top: number, and the depths of top and bottom, infinite at the bottom of a half-plane."""

    def window(self) -> list[tuple[float, float]]:
        """Where stresses are, from and to along x, and in depth."""

    def map(
        self,
        quantity: str = "max_shear",
        ax: Any = None,
        *,
        x: ArrayLike | None = None,
        depth: ArrayLike | None = None,
    ) -> Any:
        """Draws a quantity in all layers in colours with `matplotlib`, and returns the axes.

        Args:
            quantity: a stress, strain or displacement, by the name that it has in `at`.
            ax: axes to draw on; new ones if not given.
            x: places along x; `window` if not given.
            depth: depths, ascending; `window` if not given.
        """

    def stress_error(self, x: float, depth: float, layer: int | None = None) -> float:
        """Estimate of the error of the stresses at a point, in stress."""

    def max_shear(self) -> dict[str, Any]:
        """The largest shear stress in the plane anywhere, `value`, with `x`, `depth` and `layer`."""

    def extremes(self) -> dict[str, Any]:
        """The stresses by which layers and bonds break, as `recede solve --extremes --format json` has them: the largest `tension`; of each
        of the `layers` the largest von Mises stress and tensile strain; of each of the `interfaces` that do not open the shear stress and the tension across
        it. None for what is not there, or not known.
        """

@final
class Rows:
    """The rows of a sweep."""

    def __new__(
        cls,
        scene: Scene,
        axes: list[tuple[str, list[float]]],
        in_step: bool,
        tolerance: float,
        wanted: tuple[bool, bool, list[str]],
    ) -> Rows: ...
    def __len__(self) -> int: ...
    @property
    def names(self) -> list[str]:
        """The names of the columns: numbers, then texts."""

    @property
    def fingerprint(self) -> str:
        """What tells the sweep from others."""
    def run(self, first: int, last: int, threads: int) -> tuple[list[NDArray[np.float64]], list[list[str]], bool]:
        """Some rows, by this many threads. When interrupted it returns those that are complete."""

@final
class CompiledTop:
    """A punch or load as the library knows it; kept by the object of Python for the geometry in which it was used."""

def examine(thickness: float, function: Callable[[float], tuple[float, float]]) -> None:
    """Examines a function of the depth as the material of a layer of this thickness: raises ``ValueError`` that names the first law of
    elasticity that is not obeyed, see docs/adding_a_layer.md.
    """

def replace(path: str, data: bytes) -> None:
    """Writes all of a file. A regular file appears when it is complete and keeps its permissions, links are followed, anything else is
    written through.
    """

def schema() -> str:
    """The JSON Schema of scenes, with all layers, interfaces, bases, punches and loads."""
