"""Scenes, models and solutions: what they are, and that they are what the command says."""

import copy
import json
import math
import pathlib
import pickle
import threading
import time
import warnings

import numpy as np
import pytest

import recede
from recede import (
    Bonded,
    Cylinder,
    Flat,
    FunctionLayer,
    Graded,
    HalfPlane,
    Homogeneous,
    Model,
    Parabola,
    Receding,
    Rigid,
    Scene,
    Sphere,
    Stack,
    Table,
    Uniform,
    profiles,
)


def test_objects_make_the_scene_of_a_text(scene):
    text = """Scene(geometry: PlaneStrain, punch: Cylinder(radius: 500), force: 0.002, stack: [
        Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, HalfPlane(shear_modulus: 1, poisson: 0.25)])"""
    read = Scene.from_ron(text)
    assert read == scene and hash(read) == hash(scene)
    assert Scene.from_json(read.to_json()) == scene
    assert scene.number("layer[1].thickness") == 1.0
    assert scene.with_number("force", 0.004).number("force") == 0.004
    assert read.solve() == Model(Stack(STACK)).press(Cylinder(radius=500.0), 0.002)


STACK = [Homogeneous(thickness=1.0, shear_modulus=1.0, poisson=0.25), Receding(), HalfPlane(shear_modulus=1.0, poisson=0.25)]


def test_every_example_is_solved_and_survives_pickling(example, quiet):
    scene = Scene.read(example)
    assert Scene.from_ron(scene.to_ron()) == scene == pickle.loads(pickle.dumps(scene)) == copy.deepcopy(scene)
    solution = scene.solve()
    assert solution.contacts[0].resultant > 0
    assert pickle.loads(pickle.dumps(solution)) == solution == copy.copy(solution)
    found = json.loads(solution.to_json())
    assert found["contacts"][0]["half_length"] == solution.contacts[0].half_length
    assert solution._repr_html_().startswith("<table>") and solution._repr_svg_().startswith("<svg")
    assert solution.png()[:4] == b"\x89PNG"
    assert str(solution).startswith(scene.name)


def test_hertz():
    solution = Model(Stack([HalfPlane(shear_modulus=1.0, poisson=0.25)])).press(Parabola(radius=500.0), 0.002)
    contact = solution.contacts[0]
    assert math.isclose(contact.half_length, math.sqrt(500 * 0.002 * 3 / (2 * math.pi)), rel_tol=1e-12)
    x = np.linspace(-1, 1, 11)
    expected = contact.central_pressure * np.sqrt(np.clip(1 - (x / contact.half_length) ** 2, 0, None))
    np.testing.assert_allclose(contact.pressure(x), expected, atol=1e-14)
    assert contact.pressure(x.reshape(1, 11)).shape == (1, 11) and isinstance(contact.pressure(0.1), float)


def test_pressures_gaps_and_fields_fit_together(stack):
    solution = Model(stack).press(Cylinder(radius=500.0), 0.002)
    receding = solution.contacts[1]
    assert receding.gap(0.5 * receding.half_length) == 0 < receding.gap(1.1 * receding.half_length)
    (interval,) = receding.intervals
    assert interval.left == -interval.right and math.isclose(interval.force, 0.002, rel_tol=1e-12)
    field = solution.field()
    under = field.at(0.0, 0.0)
    assert math.isclose(under.sigma_yy, -solution.contacts[0].central_pressure, rel_tol=1e-9)
    x, depth = np.linspace(-1, 1, 5), np.linspace(0.1, 2, 3)
    grid, points = field.grid(x, depth), field.at(x[None, :], depth[:, None])
    assert grid.sigma_xx.shape == (3, 5)
    for name in grid:
        np.testing.assert_allclose(grid[name], points[name], rtol=1e-9, atol=1e-13)
    assert field.max_shear()["value"] > 0 and set(field.extremes()) == {"tension", "layers", "interfaces"}
    assert field.stress_error(0.1, 0.5) < 1e-10


def test_axisymmetric_scenes_have_their_own_names():
    layer = Homogeneous(thickness=1.0, young=1.0, poisson=0.3)
    model = Model(Stack([layer, Bonded(), Rigid()], geometry="Axisymmetric"))
    solution = model.press(Sphere(radius=10.0), depth=0.01)
    assert math.isclose(solution.approach, 0.01, rel_tol=1e-9)
    assert {"sigma_rr", "sigma_tt", "eps_zz", "u_r"} <= set(solution.field().at(0.1, 0.2))
    with pytest.raises(recede.InputError, match="Sphere"):
        model.press(Cylinder(radius=10.0), 0.01)


def test_depths_and_half_lengths_in_place_of_the_force():
    model = Model(Stack([Homogeneous(thickness=1.0, young=1.0, poisson=0.3), Bonded(), Rigid()]))
    first = model.press(Parabola(radius=10.0), 0.01)
    assert math.isclose(model.press(Parabola(radius=10.0), depth=first.approach).force, 0.01, rel_tol=1e-8)
    wanted = first.contacts[0].half_length
    assert math.isclose(model.press(Parabola(radius=10.0), half_length=wanted).force, 0.01, rel_tol=1e-8)
    with pytest.raises(TypeError, match="exactly one"):
        model.press(Parabola(radius=10.0), 0.01, depth=0.1)


def test_loads_in_place_of_punches(quiet):
    solution = Model(Stack([HalfPlane(shear_modulus=1.0, poisson=0.25)])).press(Uniform(half_width=1.0), 0.02)
    assert solution.contacts[0].pressure(0.5) == 0.01 and solution.approach is None
    with pytest.raises(recede.InputError):
        solution.contacts[0].gap(2.0)


def test_many_forces_have_one_answer_each(stack):
    forces = np.array([[0.001, np.nan], [-1.0, 0.002]])
    found = Model(stack).press(Cylinder(radius=500.0), forces)
    lengths = found.half_length(1)
    assert lengths.shape == (2, 2) and np.isnan(lengths[0, 1]) and np.isnan(lengths[1, 0])
    assert lengths[1, 1] == Model(stack).press(Cylinder(radius=500.0), 0.002).contacts[1].half_length
    assert [error is None for error in found.errors] == [True, False, False, True]
    with pytest.raises(recede.InputError, match="NaN"):
        found[1]


def test_graded_layers_of_tables_arrays_and_functions():
    depths = np.linspace(0, 1, 30)
    table = Graded(thickness=1.0, shear_modulus=profiles.Table(np.column_stack([depths, 1 + depths])), poisson=0.3)
    linear = Graded(thickness=1.0, shear_modulus=profiles.Linear(top=1.0, bottom=2.0), poisson=0.3)
    function = FunctionLayer(1.0, lambda depth: (1.0 + depth, 0.3))
    recede.examine(function)
    found = [
        Model(Stack([layer, Receding(), Rigid()])).press(Cylinder(radius=500.0), 0.002).contacts[1].half_length
        for layer in (table, linear, function)
    ]
    np.testing.assert_allclose(found, found[1], rtol=1e-9)
    assert Table([(0, 0), (0.5, 0.01)]).ron() == "Table([(0, 0), (0.5, 0.01)])"


def test_functions_that_fail_say_so_themselves():
    def measured(depth):
        if 0.1 < depth < 0.9:
            raise RuntimeError("no data there")
        return 1.0, 0.3

    with pytest.raises(RuntimeError, match="no data there"):
        Model(Stack([FunctionLayer(1.0, measured), Receding(), Rigid()]))
    for wrong, message in [((1.0, 0.7), "0.5"), ((-1.0, 0.3), "> 0"), ("soft", "two numbers"), (None, "two numbers")]:
        with pytest.raises((ValueError, TypeError), match=message):
            Stack([FunctionLayer(1.0, lambda depth, wrong=wrong: wrong), Bonded(), Rigid()])
    model = Model(Stack([FunctionLayer(1.0, lambda depth: (1.0, 0.3)), Receding(), Rigid()]))
    with pytest.raises(TypeError, match="function"):
        pickle.dumps(model)


def test_items_are_values():
    a, b = Flat(half_width=0.5), Flat(half_width=0.5)
    assert a == b and hash(a) == hash(b) and a != Flat(half_width=0.6) and pickle.loads(pickle.dumps(a)) == a
    assert repr(a) == "Flat(half_width=0.5)" and a.half_width == 0.5
    with pytest.raises(AttributeError, match="cannot be changed"):
        a.half_width = 1.0
    stack = Stack(STACK)
    assert pickle.loads(pickle.dumps(stack)) == stack == copy.deepcopy(stack) == eval(repr(stack))
    model = Model(stack)
    again = pickle.loads(pickle.dumps(model))
    assert again.press(a, 0.01) == model.press(b, 0.01)


def test_errors_have_place_and_hint():
    with pytest.raises(recede.InputError) as caught:
        Stack([Homogeneous(thickness=1.0, shear_modulus=1.0, poisson=0.25), HalfPlane(shear_modulus=1.0, poisson=0.25)])
    error = caught.value
    assert "no interface" in error.message and "Bonded" in error.hint and error.line is None
    # the item in question
    assert error.excerpt == "HalfPlane(poisson=0.25, shear_modulus=1.0)"
    assert str(pickle.loads(pickle.dumps(error))) == str(error) and isinstance(error, ValueError)
    # an error of a model has no line: the punch is in no text
    with pytest.raises(recede.InputError, match="cannot carry") as caught:
        Model(Stack([HalfPlane(shear_modulus=1.0, poisson=0.25)])).press(Cylinder(radius=1.0), 1e6)
    assert caught.value.line is None
    with pytest.raises(recede.InputError) as caught:
        Scene([HalfPlane(shear_modulus=1.0, poisson=0.25)], Cylinder(radius=1.0), 1e6).solve()
    assert "Cylinder" in caught.value.excerpt


@pytest.mark.parametrize("wrong", ["1.0", b"1", None, True, 1j, [1, "2"], {}, object(), [[1], [1, 2]]])
def test_what_is_no_number_is_refused(stack, wrong):
    model = Model(stack)
    with pytest.raises((TypeError, ValueError)):
        model.press(Cylinder(radius=500.0), wrong)
    with pytest.raises((TypeError, ValueError)):
        model.press(Cylinder(radius=500.0), 0.002).contacts[0].pressure(wrong)
    with pytest.raises((TypeError, ValueError)):
        model.press(Cylinder(radius=wrong), 0.002)


def test_shapes_that_do_not_fit_are_refused(stack):
    field = Model(stack).press(Cylinder(radius=500.0), 0.002).field()
    with pytest.raises(ValueError, match="fit together"):
        field.at([1.0, 2.0, 3.0], [0.1, 0.2])
    with pytest.raises(ValueError, match="one dimension"):
        field.grid([[0.0]], [0.1])
    with pytest.raises(recede.Error, match="NaN"):
        field.at(float("nan"), 0.1)
    with pytest.raises(recede.Error, match="layer 1"):
        field.at(0.0, -1.0)
    with pytest.raises(TypeError, match="Stack"):
        Model(3)
    with pytest.raises(TypeError, match="punch"):
        Model(stack).press("Cylinder", 1.0)
    with pytest.raises(recede.InputError):
        Model(stack).press(Cylinder(radius=500.0), 0.002, tolerance=1.0)


def test_warnings_go_through_warnings():
    model = Model(Stack([HalfPlane(shear_modulus=1.0, poisson=0.25)]))
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        solution = model.press(Parabola(radius=1.0), 0.2)
    assert caught[0].message.code == "long_contact" == solution.warnings[0][0] and len(caught) == len(solution.warnings)


def test_other_threads_go_on_meanwhile(quiet):
    scene = Scene.read(pathlib.Path(__file__).parents[2] / "examples" / "scenes" / "soil.ron")
    ticks, ended = [], threading.Event()

    def count():
        while not ended.is_set():
            ticks.append(time.perf_counter())
            time.sleep(1e-4)

    counter = threading.Thread(target=count)
    counter.start()
    begun = time.perf_counter()
    for force in np.linspace(1, 2, 20):
        scene.with_number("force", scene.number("force") * force).solve()
    ended.set()
    counter.join()
    # a thread that waits for another gets its turn some times in each millisecond, unless that one keeps the interpreter
    assert len(ticks) > 100 * (time.perf_counter() - begun)
