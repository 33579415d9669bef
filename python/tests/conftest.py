import pathlib
import warnings

import pytest

import recede
from recede import Cylinder, HalfPlane, Homogeneous, Receding

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples" / "scenes"


@pytest.fixture
def stack():
    return recede.Stack(
        [Homogeneous(thickness=1.0, shear_modulus=1.0, poisson=0.25), Receding(), HalfPlane(shear_modulus=1.0, poisson=0.25)]
    )


@pytest.fixture
def scene(stack):
    return recede.Scene(stack, Cylinder(radius=500.0), 0.002)


@pytest.fixture(params=sorted(EXAMPLES.glob("*.ron")), ids=lambda path: path.stem)
def example(request):
    return request.param


@pytest.fixture
def quiet():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", recede.SolutionWarning)
        yield
