"""Every item that the JSON Schema of scenes knows is built from Python, and is what the same scene in JSON and RON is."""

import dataclasses
import importlib.util
import inspect
import json
import pathlib
import pickle
import sys
import types
import typing

import numpy as np
import pytest

import recede
from recede import Homogeneous, Receding, Scene, Stack, _recede, profiles

SCHEMA = json.loads(_recede.schema())

# values of fields of which the schema says in words what they are, by these words
TABLES = {
    "[(x, height), ...]": [[0.0, 0.0], [0.5, 0.01], [1.0, 0.05]],
    "[(r, height), ...]": [[0.0, 0.0], [0.5, 0.01], [1.0, 0.05]],
    "[(depth, value), ...]": [[0.0, 0.2], [0.6, 0.3], [2.0, 0.25]],
    "[height, height, ...]": [0.1, 0.0, 0.02],
    "a text of 1 to 40 characters": "skin",
}


def choices(schema):
    """The alternatives of a schema, without null."""
    found = [one for key in ("oneOf", "anyOf") for part in schema.get(key, []) for one in choices(part)]
    return [one for one in found or [schema] if one.get("type") != "null"]


def number(schema, name):
    """A number that the schema allows, another one for each name."""
    part = 0.2 + 0.05 * (sum(map(ord, name)) % 10)
    low = schema.get("minimum", schema.get("exclusiveMinimum"))
    if low is None:
        # small, as Poisson's ratios of orthotropic materials have to be
        return round(0.5 * part, 4)
    return round(low + part * (schema["maximum"] - low) if "maximum" in schema else low + 1.0 + part, 4)


def values(schema, name):
    """Values in JSON that the schema allows."""
    for one in choices(schema):
        if "properties" in one:
            (first, *_) = one["properties"]
            if first[0].isupper():
                for inner in values(one["properties"][first], name):
                    yield {first: inner}
            else:
                yield from fields(one)
        elif "const" in one or "enum" in one:
            yield from [one["const"]] if "const" in one else one["enum"]
        elif "number" in (one.get("type") or []):
            yield number(one, name)
        elif "$ref" in one.get("items", {}):
            yield [{"Homogeneous": {"thickness": 0.5, "young": 2.0, "poisson": 0.4}}]
        elif "$ref" in one:
            yield "Rigid"
        else:
            (found,) = [value for words, value in TABLES.items() if words in one["description"]]
            yield found


def fields(schema):
    """All objects with the required fields and, one by one, with those that are optional."""
    required = set(schema.get("required", []))
    base = {name: list(values(about, name)) for name, about in schema["properties"].items()}
    first = {name: all[0] for name, all in base.items() if name in required}
    optional = [name for name in base if name not in required]
    yield first
    for name in base:
        for value in base[name]:
            yield {**first, name: value}
            for other in optional:
                if name in optional and other != name:
                    yield {**first, name: value, other: base[other][0]}


def scenes():
    """(name, scene in JSON) for each item, and all its forms; not all are legal, as those with two moduli."""
    layer = {"Homogeneous": {"thickness": 1.0, "shear_modulus": 1.0, "poisson": 0.25}}
    heavy = {"Homogeneous": {"thickness": 1.0, "shear_modulus": 1.0, "poisson": 0.25, "specific_weight": 10.0}}
    plane = {"geometry": "PlaneStrain", "punch": {"Parabola": {"radius": 10.0}}, "force": 0.01}
    ground = {"HalfPlane": {"shear_modulus": 1.0, "poisson": 0.25}}
    for value in values({"oneOf": choices(SCHEMA["properties"]["stack"]["items"])}, ""):
        name = value if isinstance(value, str) else next(iter(value))
        inner = {} if isinstance(value, str) else value[name]
        for stack in ([value, "Bonded", ground], [layer, value, ground], [layer, "Bonded", value]):
            is_legal = ("thickness" in inner, name in JOINTS) == (stack[0] is value, stack[1] is value)
            if is_legal:
                yield name, {**plane, "stack": stack}
    for one in SCHEMA["anyOf"]:
        for geometry in one["properties"]["geometry"]["enum"]:
            for key in ("punch", "load"):
                for value in values({"oneOf": choices(one["properties"][key])}, ""):
                    name = value if isinstance(value, str) else next(iter(value))
                    if name == "Dent":
                        # a gap, which in the plane the weight of the layer presses flat
                        is_round = geometry == "Axisymmetric"
                        gap = [layer if is_round else heavy, {"Receding": {"gap": value}}, ground]
                        load = "Point" if is_round else "Line"
                        yield name, {"geometry": geometry, "load": load, "force": 0.01, "stack": gap}
                        continue
                    stack = [layer, "Receding", ground]
                    yield name, {"geometry": geometry, key: value, "force": 0.01, "stack": stack}


JOINTS = ("Bonded", "Sliding", "Receding", "Spring")
SCENES = list(scenes())


def built(value, form="keywords", module=recede, is_field=False):
    """The object of Python for a value in JSON; what has fields of its own as a mapping, in their order, or as an object."""
    if isinstance(value, str):
        return getattr(module, value)() if value[0].isupper() else value
    if isinstance(value, list):
        return [built(one, form, recede, True) for one in value]
    if not isinstance(value, dict):
        return value
    name = next(iter(value))
    if name[0].isupper() and len(value) == 1:
        inner = value[name]
        if isinstance(inner, dict):
            return getattr(module, name)(**{key: built(one, form, recede if key in ("gap", "layers", "core") else profiles, True) for key, one in inner.items()})
        return getattr(module, name)(built(inner, form, recede, True))
    parts = {key: built(one, form, recede, True) for key, one in value.items()}
    if form == "in order" and not any(isinstance(one, recede.Item) for one in parts.values()):
        return tuple(parts.values())
    if form == "dataclass":
        kind = dataclasses.make_dataclass("Own", list(parts))
        return kind(**parts)
    return parts


def scene_of(data, form):
    stack = [built(one, form) for one in data["stack"]]
    tops = {key: built(data[key], form) for key in ("punch", "load") if key in data}
    return Scene(stack, force=data["force"], geometry=data["geometry"], **tops)


@pytest.mark.parametrize("form", ["keywords", "in order", "dataclass"])
def test_every_item_makes_the_scene_of_its_text(form):
    legal = set()
    for name, data in SCENES:
        try:
            read = Scene.from_json(json.dumps(data))
        except recede.InputError:
            with pytest.raises((recede.InputError, TypeError)):
                scene_of(data, form)
            continue
        legal.add(name)
        made = scene_of(data, form)
        assert made.to_ron() == read.to_ron() == Scene.from_ron(read.to_ron()).to_ron(), name
    # each name of the vocabulary was built
    assert legal == {name for name, _ in SCENES}
    exported = {name for name in recede.items.__all__ if issubclass(getattr(recede.items, name), recede.Item)}
    assert legal == exported - {"StackItem", "Punch", "Load"}


@pytest.mark.parametrize("name", sorted({name for name, _ in SCENES}))
def test_every_item_is_solved_as_its_text_is(name, quiet):
    solved = 0
    for own, data in SCENES:
        if own != name:
            continue
        try:
            read = Scene.from_json(json.dumps(data))
            expected = read.solve()
        except recede.Error:
            continue
        made = scene_of(data, "keywords")
        assert made.solve() == expected
        # and back: the text in Python makes the same scene
        again = eval(repr(read), {**vars(recede), "profiles": profiles})
        assert again == read == made and pickle.loads(pickle.dumps(again.stack)) == again.stack
        assert (again.punch, again.load) == (made.punch, made.load) == (expected_top(data, "punch"), expected_top(data, "load"))
        solved += 1
        if solved == 2:
            return
    assert solved


def expected_top(data, key):
    return built(data[key]) if key in data else None


def classes():
    found = [getattr(recede.items, name) for name in recede.items.__all__] + [getattr(profiles, name) for name in profiles.__all__]
    return [kind for kind in found if issubclass(kind, recede.Item)]


@pytest.mark.parametrize("kind", classes(), ids=lambda kind: f"{kind.__module__}.{kind.__name__}")
def test_fields_have_types_and_are_listed(kind):
    assert kind.__doc__
    parameters = inspect.signature(kind).parameters if "__init__" in vars(kind) else {}
    hints = typing.get_type_hints(kind)
    given = typing.get_type_hints(kind.__init__) if parameters else {}
    for field in parameters:
        assert field in hints and field in dir(kind) and typing.Any not in (hints[field], given[field])
        assert f"{field}:" in kind.__doc__


def test_fields_are_kept_as_plain_values():
    layer = Homogeneous(thickness=np.float64(1.0), young=np.int32(200), poisson=np.float32(0.25))
    assert repr(layer) == "Homogeneous(thickness=1.0, poisson=0.25, young=200)" and layer.shear_modulus is None
    assert {"thickness", "young", "poisson"} <= set(dir(layer))
    table = profiles.Table(np.array([[0.0, 1.0], [1.0, 2.0]]))
    assert table.rows == ((0.0, 1.0), (1.0, 2.0)) and repr(table) == "profiles.Table(rows=((0.0, 1.0), (1.0, 2.0)))"
    ply = recede.Orthotropic(
        thickness=0.1, young=(135.0, 10.0, 10.0), poisson={"xz": 0.3, "xy": 0.3, "yz": 0.4}, shear_modulus=5.0
    )
    assert ply.young.x == 135.0 and ply.poisson == recede.OrthotropicPoisson(xy=0.3, xz=0.3, yz=0.4)
    assert ply == eval(repr(ply), vars(recede)) == pickle.loads(pickle.dumps(ply))
    with pytest.raises(TypeError, match=r"`Orthotropic.young` has the fields x, y, z; found 2 values"):
        recede.Orthotropic(thickness=0.1, young=(1, 2), poisson=(0.3, 0.3, 0.3), shear_modulus=5.0)
    with pytest.raises(TypeError, match="`Orthotropic.young` has the fields x, y, z; found x, q"):
        recede.Orthotropic(thickness=0.1, young={"x": 1, "q": 2}, poisson=(0.3, 0.3, 0.3), shear_modulus=5.0)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Homogeneous(thickness=-1.0, shear_modulus=1.0, poisson=0.25), r"^`Homogeneous.thickness`: found -1.0, allowed"),
        (lambda: Homogeneous(thickness=1.0, poisson=0.25), r"^`Homogeneous`: found none of `shear_modulus` and `young`"),
        (lambda: Homogeneous(thickness="1 MPa", young=1.0, poisson=0.25), r'^`Homogeneous`: `"1 MPa"` is a stress'),
        (lambda: recede.Spring(normal=-1.0), r"^`Spring.normal`: found -1.0"),
        (lambda: recede.Flat(half_width=-1.0), r"^`Flat.half_width`: found -1.0"),
        (lambda: recede.Flat(radius=-1.0), r"^`Flat.radius`: found -1.0"),
        (lambda: recede.Flat(), r"^`half_width` is missing in `Flat`\nhint: add `half_width=...` between its parentheses"),
        (lambda: recede.Sphere(radius=0.0), r"^`Sphere.radius`: found 0.0"),
        (lambda: recede.Ring(radius=float("nan"), half_width=1.0), r"^`Ring.radius`: found NaN"),
        (lambda: recede.Uniform(half_width=True), r"^`Uniform.half_width`: a number is expected, found `true`"),
        (lambda: profiles.Linear(top=-2.0, bottom=1.0), r"^`Linear.top`: found -2.0, allowed is a finite number > 0"),
        (lambda: profiles.Constant(-2.0), r"^`Constant`: found -2.0, allowed is a finite number > 0"),
        (lambda: recede.FunctionLayer(-1.0, lambda depth: (1.0, 0.3)), r"^`FunctionLayer.thickness`: found -1.0"),
        (
            lambda: recede.OrthotropicHalfPlane(young=(-1.0, 1, 1), poisson=(0.3, 0.3, 0.3), shear_modulus=1.0),
            r"^`OrthotropicHalfPlane.young.x`: found -1.0",
        ),
    ],
)
def test_items_are_checked_when_they_are_made(make, message):
    with pytest.raises(recede.InputError, match=message) as caught:
        make()
    assert caught.value.line is None and caught.value.excerpt is None


def test_profiles_may_be_moduli_or_ratios():
    assert profiles.Linear(top=-0.5, bottom=0.3).top == -0.5
    with pytest.raises(recede.InputError, match=r"`poisson_profile.top` of layer 1 \(Graded\)|`Graded.poisson_profile"):
        recede.Graded(thickness=1.0, young=profiles.Constant(1.0), poisson_profile=profiles.Linear(top=2.0, bottom=0.3))


def test_errors_speak_of_objects_not_of_lines():
    thin, ground = Homogeneous(thickness="1 um", young=1.0, poisson=0.25), recede.HalfPlane(young=1.0, poisson=0.3)
    with pytest.raises(recede.InputError, match="does not say its units|no units|units") as caught:
        Stack([thin, Receding(), ground])
    assert caught.value.line is None and caught.value.excerpt == repr(thin) and "line" not in str(caught.value)
    scene = Scene([ground], recede.Cylinder(radius=1.0), 1e-3)
    for made in (lambda: scene.with_number("punch.radius", -1.0), lambda: scene.with_number("force", 1e6).solve()):
        with pytest.raises(recede.InputError) as caught:
            made()
        assert caught.value.line is None and "line" not in str(caught.value)
    # but a text that was written has lines
    with pytest.raises(recede.InputError) as caught:
        Scene.from_ron(scene.to_ron().replace("1.0", "-1.0"))
    assert caught.value.line and "(scene, line " in str(caught.value)


@pytest.mark.parametrize("units", [("mm", "N"), {"length": "mm", "force": "N"}, {"force": "N", "length": "mm"}, recede.Units("mm", "N")])
def test_units_are_what_they_are_called(units):
    scene = Scene([recede.HalfPlane(young="1 GPa", poisson=0.3)], recede.Parabola(radius="1 cm"), 1.0, units=units)
    assert scene.units == recede.Units(length="mm", force="N") and scene.number("layer[1].young") == 1000.0
    assert json.loads(scene.solve().to_json())["units"] == {"length": "mm", "force": "N/mm", "stress": "MPa"}


@pytest.mark.parametrize("units", ["mm", b"mm", ["mm"], ("mm", "N", "s"), ("mm", 1), {"length": "mm"}, {"length": "mm", "mass": "kg"}, 1])
def test_other_units_are_refused(units):
    with pytest.raises(TypeError, match="`units`"):
        Scene([recede.HalfPlane(young=1.0, poisson=0.3)], recede.Parabola(radius=1.0), 1.0, units=units)


def test_labels_of_any_signs_are_read_again():
    name = 'a "name"\\ of\ttwo\nlines, \u0001, µ and 漢'
    scene = Scene([recede.HalfPlane(young=1.0, poisson=0.3)], recede.Parabola(radius=1.0), 1.0, name=name)
    assert scene.name == name and Scene.from_ron(scene.to_ron()).name == name


# what the vocabulary may get: a record that may be left out, a list of records with items in them, a choice of its own
NUMBER = {"type": ["number", "string"]}
POINT = {"type": "object", "properties": {"at": NUMBER, "share": {"type": ["number", "null"]}}, "required": ["at"]}
NEW = {
    "type": "object",
    "properties": {
        "Novel": {
            "type": "object",
            "properties": {
                "strain": {"anyOf": [{"type": "object", "properties": {"x": NUMBER, "y": NUMBER}, "required": ["x", "y"]}, {"type": "null"}]},
                "points": {"type": "array", "items": POINT},
                "tilt": {"oneOf": [{"type": "string", "const": "Free"}, {"type": "object", "properties": {"Fixed": {"properties": {"angle": NUMBER}, "required": ["angle"]}}}]},
            },
            "required": ["points", "tilt"],
        }
    },
}


def test_classes_follow_from_any_schema(monkeypatch):
    spec = importlib.util.spec_from_file_location("make_items", pathlib.Path(__file__).parents[1] / "make_items.py")
    make_items = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(make_items)
    schema = json.loads(_recede.schema())
    schema["properties"]["stack"]["items"]["oneOf"].append(NEW)
    module = types.ModuleType("recede.novel")
    module.__package__ = "recede"
    monkeypatch.setitem(sys.modules, "recede.novel", module)
    exec(make_items.modules(schema)["items.py"], vars(module))
    # no reader knows it
    monkeypatch.setattr(recede.Item, "_check", lambda self: None)
    one = module.Novel(points=[{"at": 1.0}, (2.0, 0.5)], tilt=module.Fixed(angle=0.1), strain=(1, 2))
    assert one.ron() == "Novel(points: [(at: 1.0), (at: 2.0, share: 0.5)], tilt: Fixed(angle: 0.1), strain: (x: 1, y: 2))"
    assert one.points[1].share == 0.5 and one.strain.y == 2 and isinstance(one.tilt, module.Tilt)
    assert module.Novel(points=(), tilt=module.Free()).ron() == "Novel(points: [], tilt: Free)"
    assert eval(repr(one), vars(module)) == one


def test_several_loads_have_places_and_forces():
    stack = Stack([Homogeneous(thickness=1.0, young=200.0, poisson=0.3), recede.Bonded(), recede.HalfPlane(young=70.0, poisson=0.3)])
    line, strip = recede.Line(), recede.Uniform(half_width=0.2)
    placed = (recede.PlacedLoad(line, at=-0.5, force=0.2), recede.PlacedLoad(strip, at=1.0, force=0.8))
    named = [{"load": line, "at": -0.5, "force": 0.2}, {"load": strip, "at": 1.0, "force": 0.8}]
    for loads in (placed, named, [(line, -0.5, 0.2), (strip, 1.0, 0.8)]):
        scene = Scene(stack, loads=loads)
        assert scene.loads == placed and scene.punch is scene.load is scene.force is None
        solution = scene.solve()
        assert solution.loads == placed and solution.punch is solution.load is None
        assert eval(repr(scene), vars(recede)) == scene and pickle.loads(pickle.dumps(scene)) == scene
        (contact,) = solution.contacts
        assert [(one.left, one.right, one.force) for one in contact.intervals] == [(-0.5, -0.5, 0.2), (0.8, 1.2, 0.8)]
    with pytest.raises(recede.InputError, match="`loads` and `force`"):
        Scene(stack, force=1.0, loads=placed)


def test_several_punches_have_places_forces_and_tilts():
    stack = Stack([Homogeneous(thickness=1.0, young=200.0, poisson=0.3), recede.Bonded(), recede.HalfPlane(young=70.0, poisson=0.3)])
    roller, block = recede.Cylinder(radius=100.0), recede.Flat(half_width=0.5)
    free, fixed = recede.Free(eccentricity=0.1), recede.Fixed(0.01)
    pressed = (recede.Pressed(roller, at=0.0, force=0.002), recede.Pressed(block, at=3.0, force=0.001, tilt=free))
    named = [{"shape": roller, "at": 0.0, "force": 0.002}, {"shape": block, "at": 3.0, "force": 0.001, "tilt": free}]
    for punches in (pressed, named, [(roller, 0.0, 0.002), (block, 3.0, 0.001, free)]):
        scene = Scene(stack, punches=punches)
        assert scene.punches == pressed and scene.punch is scene.loads is scene.force is None
        assert eval(repr(scene), vars(recede)) == scene == Scene.from_ron(scene.to_ron()) == pickle.loads(pickle.dumps(scene))
        # the force on the block acts to the right of its middle
        solution = scene.solve()
        assert solution.contacts[0].intervals[1].centroid == pytest.approx(3.1, rel=1e-12)
        wheel, turned = solution.carried
        assert wheel.tilt == 0.0 and turned.tilt != 0.0 and turned.moment == pytest.approx(0.1 * 0.001, rel=1e-10)
        # over a half-plane no approach is defined, and nothing is loose
        assert wheel.approach is turned.approach_error is None and solution.rotations == []
    # where its contact ends in place of the force
    begins = solution.contacts[0].intervals[0].left
    found = Scene(stack, punches=[recede.Pressed(roller, at=0.0, left=begins), pressed[1]])
    assert found.punches[0] == recede.Pressed(roller, 0.0, left=begins) and found == pickle.loads(pickle.dumps(found))
    assert found.solve().carried[0].force == pytest.approx(0.002, rel=1e-9)
    wedge = Scene(stack, punches=[*pressed[:1], (recede.Wedge(slope=0.1), 3.0, 0.001)]).solve()
    assert wedge.contacts[0].peak_pressure == float("inf") and wedge.contacts[0].peak_at == pytest.approx(3.0)
    (turned,) = Scene(stack, punches=[(block, 0.0, 0.001, fixed)]).punches
    assert turned.tilt == fixed and repr(fixed) == "Fixed(value=0.01)" and isinstance(fixed, recede.Tilt)
    # one at x = 0 that is not turned is the punch
    one = Scene(stack, punches=[(block, 0.0, 0.001)])
    assert (one.punch, one.force, one.punches) == (block, 0.001, None) and one.solve() == Scene(stack, block, 0.001).solve()
    assert Scene(stack, punches=[(block, 1.0, 0.001, recede.Fixed("45 deg"))]).number("punches[1].tilt") == np.pi / 4
    for make, message in [
        (lambda: Scene(stack, force=1.0, punches=pressed), "`punches` and `force`"),
        (lambda: Scene(stack, punches=[recede.Pressed(roller, 0.0)]), "0 of `force`, `depth`, `left` and `right` are given"),
        (lambda: recede.Free(eccentricity=float("inf")), r"^`Free.eccentricity`: found inf"),
        (lambda: recede.Fixed(float("nan")), r"^`Fixed`: found NaN|^`Fixed.*: found NaN"),
        (lambda: Scene(stack, punches=[(block, 0.0, 0.001, recede.Free(eccentricity=0.5))]), "eccentricity of punch 1 is 0.5"),
    ]:
        with pytest.raises(recede.InputError, match=message):
            make()


def test_layers_may_be_apart_and_strained():
    ground = recede.HalfPlane(shear_modulus=0.8, poisson=0.2)
    gap = recede.Receding(gap=recede.Parabola(radius=100.0))
    strip = Homogeneous(thickness=1.0, shear_modulus=0.7, poisson=0.3)
    scene = Scene([strip, gap, ground], recede.Parabola(radius=100.0), 0.002)
    assert eval(repr(scene), vars(recede)) == scene == Scene.from_ron(scene.to_ron()) == pickle.loads(pickle.dumps(scene))
    assert scene.solve().contacts[1].half_length == pytest.approx(0.46235337006, rel=1e-10)
    assert scene.stack.items[1] == gap and gap.gap == recede.Parabola(radius=100.0) and recede.Receding().ron() == "Receding"
    assert recede.Receding(gap=recede.Sphere(radius=1.0)).ron() == "Receding(gap: Sphere(radius: 1.0))"
    warm = Homogeneous(thickness=0.5, shear_modulus=0.7, poisson=0.3, eigenstrain=1e-3)
    cold = Homogeneous(thickness=0.5, shear_modulus=0.7, poisson=0.3)
    curled = Scene([cold, recede.Bonded(), warm, recede.Receding(), ground], recede.Parabola(radius=100.0), 0.002).solve()
    flat = Scene([strip, recede.Receding(), ground], recede.Parabola(radius=100.0), 0.002).solve()
    assert curled.contacts[1].half_length < flat.contacts[1].half_length
    for make, message in [
        (lambda: recede.Receding(gap=recede.Parabola(radius=-1.0)), "found -1"),
        (lambda: recede.Receding(gap=recede.ElasticCylinder(radius=1.0, young=1.0, poisson=0.3)), "elastic"),
        (lambda: Homogeneous(thickness=1.0, young=1.0, poisson=0.3, eigenstrain=float("inf")), "found inf"),
    ]:
        with pytest.raises(recede.InputError, match=message):
            make()


def test_layers_with_weights_come_apart() -> None:
    stack = [Homogeneous(thickness=1.0, shear_modulus=0.75, poisson=0.25, specific_weight=0.5), Receding(), recede.Rigid()]
    scene = Scene(stack, load=recede.Line(), force=100.0, pressure_on_top=0.5)
    assert scene.pressure_on_top == 0.5
    solution = scene.solve()
    (own,) = solution.closed
    assert own.interface == "1|2" and own.weight == 1.0
    left, right = own.openings
    assert right.left == pytest.approx(1.22846271344, rel=1e-10)
    assert left.left == -right.right
    assert right.largest_gap == pytest.approx(0.9870283479, rel=1e-9)
    separation = solution.separation
    assert separation is not None and separation.critical_force == pytest.approx(44.13910598462163)
    assert scene.solve().separation == separation
    assert Scene(stack, load=recede.Line(), force=1.0).solve().closed[0].openings == ()


def test_loads_about_axes_of_their_own_are_added_up():
    stack = recede.Stack(
        [
            recede.Homogeneous(thickness=150, young=3000, poisson=0.30),
            recede.Bonded(),
            recede.Homogeneous(thickness=600, young=200, poisson=0.35),
            recede.Bonded(),
            recede.HalfPlane(young=40, poisson=0.40),
        ],
        geometry="Axisymmetric",
    )
    wheels = [(recede.Uniform(radius=150.0), (0.0, y), 1.1 * np.pi * 150**2) for y in (150.0, -150.0)]
    scene = Scene(stack, loads=wheels)
    assert scene.loads == tuple(recede.PlacedLoad(*wheel) for wheel in wheels)
    assert eval(repr(scene), vars(recede)) == scene == Scene.from_ron(scene.to_ron()) == pickle.loads(pickle.dumps(scene))
    field = scene.solve().field()
    # under two wheels and between them, as ELLEA1 has it
    found = field.at(0, 0, y=[0, 150])
    assert found.u_z == pytest.approx([1.91744256584, 1.86038860024], rel=1e-10) and list(found.y) == [0, 150]
    assert field.at_y(150).grid([0, 1], [0, 10]).u_z[0, 0] == pytest.approx(1.86038860024, rel=1e-10)
    with pytest.raises(recede.InputError, match="about one axis only"):
        field.max_shear()
    with pytest.raises(ValueError, match="`x` of shape .2,. and `depth` of shape .. and `y` of shape .3,. do not fit"):
        field.at([0, 1], 0, y=[0, 1, 2])
