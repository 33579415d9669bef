"""Receding and advancing contact of multilayered elastic stacks.

    >>> import recede
    >>> from recede import Cylinder, HalfPlane, Homogeneous, Receding
    >>> stack = recede.Stack([
    ...     Homogeneous(thickness=1.0, shear_modulus=1.0, poisson=0.25),
    ...     Receding(),
    ...     HalfPlane(shear_modulus=1.0, poisson=0.25),
    ... ])
    >>> solution = recede.Model(stack).press(Cylinder(radius=500.0), 0.002)
    >>> [f"{contact.interface}: {contact.half_length:.9f}" for contact in solution.contacts]
    ['punch: 0.742635599', '1|2: 1.501172646']

Any consistent units. x runs along the layers, depths downwards; pressures are positive in compression, stresses in tension. Forces are
per unit length out of the plane, and whole forces in axisymmetric scenes.
"""

from . import items as items
from . import profiles as profiles
from ._arrays import Fields as Fields
from ._errors import Error as Error
from ._errors import InputError as InputError
from ._errors import Interrupted as Interrupted
from ._errors import NoSolutionError as NoSolutionError
from ._errors import SolutionWarning as SolutionWarning
from ._items import Fixed as Fixed
from ._items import Free as Free
from ._items import Item as Item
from ._items import Tilt as Tilt
from ._recede import Contact as Contact
from ._recede import Field as Field
from ._recede import Model as Model
from ._recede import Scene as Scene
from ._recede import Solution as Solution
from ._recede import __version__ as __version__
from ._recede import examine as _examine
from ._solutions import Contacts as Contacts
from ._solutions import Carried as Carried
from ._solutions import ClosedInterface as ClosedInterface
from ._solutions import Interval as Interval
from ._solutions import Opening as Opening
from ._solutions import Separation as Separation
from ._solutions import Solutions as Solutions
from ._sweep import sweep as sweep
from ._table import Columns as Columns
from ._text import FunctionLayer as FunctionLayer
from ._text import Stack as Stack
from ._values import PlacedLoad as PlacedLoad
from ._values import Pressed as Pressed
from ._values import Units as Units
from .items import *  # noqa: F403


def examine(layer: FunctionLayer) -> None:
    """Checks the laws of elasticity that hold for all layers.

    Args:
        layer: a layer whose material is a function.

    Raises:
        ValueError: with the laws that are not obeyed, see docs/adding_a_layer.md.
    """
    _examine(layer.thickness, layer.material)
