"""What is shown to who asks: docstrings, signatures, notebooks, tables of other programs."""

import inspect
import json
import math
import warnings

import numpy as np
import pytest

import recede
from recede import Cylinder, HalfPlane, Homogeneous, Model, Parabola, Receding, Rigid, Scene, Stack, Uniform, Wedge

CLASSES = [recede.Scene, recede.Model, recede.Solution, recede.Contact, recede.Field, recede.Stack, recede.Solutions, recede.Columns]


@pytest.mark.parametrize("kind", CLASSES, ids=lambda kind: kind.__name__)
def test_everything_has_a_docstring_and_a_signature(kind):
    assert inspect.getdoc(kind)
    for name, member in vars(kind).items():
        if name.startswith("_"):
            continue
        assert inspect.getdoc(member), name
        if callable(getattr(kind, name)) and not isinstance(member, property):
            signature = inspect.signature(getattr(kind, name))
            assert "args" not in signature.parameters and "kwargs" not in signature.parameters, name
    assert inspect.signature(kind).parameters is not None or kind in (recede.Solution, recede.Contact, recede.Field)


def test_help_tells_arguments_and_units():
    assert "tolerance" in inspect.signature(Model.press).parameters and "in length" in inspect.getdoc(Model.press)
    assert list(inspect.signature(Scene).parameters)[:3] == ["stack", "punch", "force"] and "units" in inspect.signature(Scene).parameters
    assert inspect.getdoc(recede.Contact.central_pressure).startswith("Pressure at x = 0")


@pytest.fixture
def solution(stack):
    return Model(stack).press(Cylinder(radius=500.0), 0.002)


def test_notebooks_show_the_picture_with_the_table(solution):
    html = solution._repr_html_()
    assert html.startswith("<table>") and 'src="data:image/svg+xml;base64,' in html and "punch" in html


def test_notebooks_show_drawings_of_what_is_not_solved(stack, scene):
    assert "receding 1|2" in stack._repr_html_() and "Cylinder" not in stack._repr_html_()
    assert Model(scene)._repr_html_() == Model(stack)._repr_html_() == stack._repr_html_() == scene.stack._repr_html_()
    assert "Cylinder(radius: 500.0), force 0.002" in scene._repr_html_() and "receding 1|2" in scene._repr_html_()
    assert "a function" in Stack([recede.FunctionLayer(1.0, lambda depth: (1.0, 0.3)), Receding(), Rigid()])._repr_html_()
    # what cannot be drawn is shown by its text
    wrong = Scene.from_ron("Scene(geometry: PlaneStrain, punch: Parabola(radius: 1.0), force: 1.0, stack: [Receding, Rigid])")
    assert wrong._repr_html_() is None and repr(wrong) == wrong.to_ron()


def test_pressures_and_gaps_at_no_place_are_nan(solution):
    x = np.array([[0.0, math.nan], [math.nan, 2.0]])
    for contact in solution.contacts:
        for of in (contact.pressure, contact.gap):
            assert math.isnan(of(math.nan))
            found = of(x)
            assert (np.isnan(found) == np.isnan(x)).all() and found[0, 0] == of(0.0) and found[1, 1] == of(2.0)
            assert of(np.array([])).shape == (0,) and np.isnan(of([math.nan])).all()
        assert contact.pressure([-math.inf, math.inf]).tolist() == [0.0, 0.0]


def test_files_that_cannot_be_read_are_errors_of_the_system(tmp_path):
    missing = tmp_path / "strip.ron"
    with pytest.raises(FileNotFoundError) as caught:
        Scene.read(missing)
    assert caught.value.filename == str(missing) and "strip.ron" in str(caught.value)
    with pytest.raises(IsADirectoryError):
        Scene.read(str(tmp_path))
    missing.write_text("Scene(\n  geometry: PlaneStrain,\n  force: -1.0)")
    with pytest.raises(recede.InputError, match=r"strip.ron, line 3, column 10") as caught:
        Scene.read(missing)
    assert caught.value.file == str(missing)


def test_tables_are_tables_of_other_programs(scene):
    pandas, polars, pyarrow = map(pytest.importorskip, ("pandas", "polars", "pyarrow"))
    swept = recede.sweep(scene, {"force": [0.001, 0.002, 1e9]})
    frame = pandas.DataFrame(swept)
    assert list(frame.columns) == list(swept) and frame.shape[0] == 3 == swept.rows
    assert frame["punch_half_length"].to_numpy()[:2].tolist() == swept["punch_half_length"][:2].tolist()
    assert polars.DataFrame(swept).columns == list(swept) == polars.from_arrow(pyarrow.table(swept)).columns
    assert pyarrow.table(swept, metadata=swept.metadata).schema.metadata[b"version"].decode() == recede.__version__
    assert pyarrow.RecordBatchReader.from_stream(swept).schema.metadata[b"version"].decode() == recede.__version__
    assert swept == recede.sweep(scene, {"force": [0.001, 0.002, 1e9]}) and swept != {} and not swept == dict(swept)


def test_warnings_of_an_array_are_told_once():
    model = Model(Stack([HalfPlane(shear_modulus=1.0, poisson=0.25)]))
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = model.press(Parabola(radius=1.0), np.linspace(0.1, 0.3, 37))
    codes = [one.message.code for one in caught]
    assert codes.count("long_contact") == 1 and len(codes) == len(set(codes)) and caught[0].filename == __file__
    told = [force for force, one in zip(np.linspace(0.1, 0.3, 37), found, strict=True) if one.warnings]
    assert len(told) > 1
    text = str(caught[0].message)
    assert f"{len(told)} of 37" in text and f"from {told[0]:g} to {told[-1]:g}" in text and "force = " in text


def test_contacts_have_names(stack, solution):
    assert solution.contacts["punch"] == solution.contacts[0] and solution.contacts["1|2"] == solution.contacts[-1]
    assert len(solution.contacts[:]) == 2 and isinstance(solution.contacts, tuple)
    with pytest.raises(KeyError, match="punch, 1|2"):
        solution.contacts["2|3"]
    many = Model(stack).press(Cylinder(radius=500.0), [0.001, 0.002])
    assert many.half_length("1|2").tolist() == many.half_length(1).tolist()
    assert many.peak_pressure("punch").tolist() == many.peak_pressure().tolist()
    loaded = Model(stack).press(Uniform(half_width=1.0), 0.002)
    names = [contact.interface for contact in loaded.contacts]
    assert names == [contact["interface"] for contact in json.loads(loaded.to_json())["contacts"]] and names[0] == "load"


def test_solutions_know_their_scenes(stack, scene, solution):
    assert solution.scene == scene == scene.solve().scene and solution.punch == Cylinder(radius=500.0) and solution.load is None
    assert solution.scene.solve() == solution and solution.scene.with_number("force", 0.004).number("force") == 0.004
    assert solution.scene.with_number("punch.radius", 100.0).punch == Cylinder(radius=100.0)
    loaded = Model(stack).press(Uniform(half_width=1.0), 0.002)
    assert loaded.punch is None and loaded.load == Uniform(half_width=1.0) == loaded.scene.load
    assert scene.stack == stack and scene.force == 0.002 and scene.units is scene.description is None


def test_profiles_are_pressures_and_gaps(solution):
    profile = solution.profile()
    assert list(profile)[:5] == ["x", "punch_pressure", "punch_gap", "contact_1_2_pressure", "contact_1_2_gap"]
    for name, contact in (("punch", solution.contacts[0]), ("contact_1_2", solution.contacts[1])):
        assert profile[f"{name}_pressure"].tolist() == contact.pressure(profile["x"]).tolist()
        np.testing.assert_allclose(profile[f"{name}_gap"], contact.gap(profile["x"]), rtol=1e-9, atol=1e-12)
        assert profile["x"][-1] == 2 * solution.contacts[1].half_length == -profile["x"][0]
    assert solution.profile(5.0, points=20)["x"][-1] == 5.0 and solution.profile(points=20).rows < profile.rows
    wedge = Model(Stack([HalfPlane(shear_modulus=1.0, poisson=0.25)])).press(Wedge(slope=0.01), 0.002)
    assert wedge.profile()["punch_pressure"].max() == math.inf
    for wrong in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(ValueError, match="to"):
            solution.profile(wrong)


def test_extremes_are_those_of_the_json():
    layer = Homogeneous(thickness=1.0, young=1.0, poisson=0.3)
    solution = Model(Stack([layer, recede.Bonded(), layer, Receding(), Rigid()])).press(Parabola(radius=10.0), 0.001)
    found = json.loads(solution.to_json(max_shear=True, extremes=True))
    assert found["extremes"] == solution.field().extremes() and found["max_shear"] == solution.field().max_shear()
    assert [one["layer"] for one in found["extremes"]["layers"]] == [1, 2]
    assert [one["interface"] for one in found["extremes"]["interfaces"]] == ["1|2"]
    assert "extremes" not in json.loads(solution.to_json())


def test_fields_say_where_they_are(solution):
    x, depth = np.linspace(-1, 1, 5), np.array([0.1, 1.5])
    grid = solution.field().grid(x, depth)
    assert (grid.x == x[None, :]).all() and (grid.depth == depth[:, None]).all() and (grid.layer == [[1], [2]]).all()
    points = solution.field().at([0.3, 0.3 + 1e-6], 0.2)
    assert points.layer.dtype.kind == "i" and points.x.tolist() == [0.3, 0.3 + 1e-6]
    assert math.isclose((points.v[1] - points.v[0]) / 1e-6, points.slope[0], rel_tol=1e-4)
    one = solution.field().at(0.3, 0.2)
    assert (one.x, one.depth, one.layer) == (0.3, 0.2, 1) and {"x", "slope"} <= set(dir(one))


def test_layers_that_are_functions_stay_what_they_are():
    soft = recede.FunctionLayer(1.0, lambda depth: (1e-3, 0.3))
    scene = Scene([soft, Receding(), HalfPlane(shear_modulus=1.0, poisson=0.25)], Cylinder(radius=500.0), 1e-6)
    first = scene.solve()
    assert scene.with_number("force", 1e-6).solve() == first and first.scene is not None
    assert not any(path.startswith("layer[1]") for path in scene.paths) and "layer[2].poisson" in scene.paths
    with pytest.raises(TypeError, match="function"):
        scene.with_number("layer[1].shear_modulus", 1.0)
    with pytest.raises(TypeError, match="function"):
        recede.sweep(scene, {"force": [1e-6]})
