"""Laws that hold for scenes of any numbers."""

import warnings

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import recede
from recede import Bonded, HalfPlane, Homogeneous, Model, Parabola, Receding, Rigid, Scene, Stack

positive = st.floats(0.1, 10)
ratios = st.floats(-0.3, 0.5)
layers = st.builds(lambda h, mu, nu: Homogeneous(thickness=h, shear_modulus=mu, poisson=nu), positive, positive, ratios)
joints = st.sampled_from([Bonded(), Receding()])
bases = st.one_of(st.just(Rigid()), st.builds(lambda mu, nu: HalfPlane(shear_modulus=mu, poisson=nu), positive, ratios))


@st.composite
def stacks(draw):
    items = []
    for _ in range(draw(st.integers(0, 3))):
        items += [draw(layers), draw(joints)]
    base = draw(bases)
    return Stack([*items, base] if items or isinstance(base, HalfPlane) else [HalfPlane(shear_modulus=1.0, poisson=0.3)])


@settings(max_examples=40, deadline=None)
@given(stacks(), st.floats(1e-3, 1e-1))
def test_forces_balance_and_objects_survive(stack, force):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", recede.SolutionWarning)
        model = Model(stack)
        try:
            solution = model.press(Parabola(radius=100.0), force)
        except recede.NoSolutionError as error:
            assert error.message
            return
        for contact in solution.contacts:
            assert np.isclose(contact.resultant, force, rtol=1e-9)
            x = np.linspace(0, contact.reach, 50)
            assert (contact.pressure(x) >= -1e-6 * contact.peak_pressure).all()
        scene = Scene(stack, Parabola(radius=100.0), force)
        assert Scene.from_ron(scene.to_ron()).solve() == solution


@settings(max_examples=60, deadline=None)
@given(st.dictionaries(st.sampled_from(["thickness", "shear_modulus", "young", "poisson", "soft"]), st.one_of(
    st.none(), st.floats(), st.integers(), st.text(max_size=5), st.lists(st.floats(), max_size=2), st.booleans())))
def test_anything_may_be_a_field_and_is_refused_with_a_reason(fields):
    try:
        item = Homogeneous(**fields)
        Stack([item, Bonded(), Rigid()])
    except (TypeError, recede.InputError) as error:
        assert str(error)
