//! What is wrong with a field of a scene is told by line and column, with what is allowed and what to do; exit status 2.
#[path = "support/refusal.rs"]
mod refusal;
mod support;

use refusal::{SCENE, refusal, refusals, with};
use support::recede;

#[test]
fn the_scene_itself_is_legal() {
    assert_eq!(recede(&["check", "-"], SCENE.as_bytes()).status, Some(0));
}

#[test]
fn numbers_out_of_range() {
    insta::assert_snapshot!(refusals(&[
        ("poisson: 0.25", "poisson: 0.7"),
        ("poisson: 0.3", "poisson: -1"),
        ("poisson: 0.4", "poisson: 0.5000000000000001"),
        ("poisson: 0.4", "poisson: NaN"),
        ("thickness: 1.0", "thickness: -1.0"),
        ("thickness: 2.0", "thickness: inf"),
        ("thickness: 2.0", "thickness: 1e999"),
        ("shear_modulus: 4.0", "shear_modulus: 0"),
        ("shear_modulus: 1.0", "shear_modulus: -2"),
        ("beta: -1.0", "beta: -inf"),
        ("beta: -1.0", "beta: 1e3"),
        ("radius: 500.0", "radius: 0.0"),
        ("radius: 500.0", "radius: NaN"),
        ("force: 0.002", "force: -0.002"),
        ("force: 0.002", "force: 0"),
        ("force: 0.002", "force: 1e-400"),
    ]), @r#"
    error: stdin:6:66: `poisson` of layer 1 (Homogeneous): found 0.7, allowed is -1 < poisson <= 0.5
      6 |         Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.7),
        |                                                                  ^

    error: stdin:8:66: `poisson` of layer 2 (Exponential): found -1.0, allowed is -1 < poisson <= 0.5
      8 |         Exponential(thickness: 2.0, shear_modulus: 3.0, poisson: -1, beta: -1.0),
        |                                                                  ^

    error: stdin:10:48: `poisson` of layer 3 (HalfPlane): found 0.5000000000000001, allowed is -1 < poisson <= 0.5
      10 |         HalfPlane(shear_modulus: 4.0, poisson: 0.5000000000000001),
         |                                                ^

    error: stdin:10:48: `poisson` of layer 3 (HalfPlane): found NaN, allowed is -1 < poisson <= 0.5
      10 |         HalfPlane(shear_modulus: 4.0, poisson: NaN),
         |                                                ^

    error: stdin:6:32: `thickness` of layer 1 (Homogeneous): found -1.0, allowed is a finite number >= 0 (0 means: not there)
      6 |         Homogeneous(thickness: -1.0, shear_modulus: 1.0, poisson: 0.25),
        |                                ^

    error: stdin:8:32: `thickness` of layer 2 (Exponential): found inf, allowed is a finite number >= 0 (0 means: not there)
      8 |         Exponential(thickness: inf, shear_modulus: 3.0, poisson: 0.3, beta: -1.0),
        |                                ^

    error: stdin:8:32: `thickness` of layer 2 (Exponential): found inf, allowed is a finite number >= 0 (0 means: not there)
      8 |         Exponential(thickness: 1e999, shear_modulus: 3.0, poisson: 0.3, beta: -1.0),
        |                                ^
    hint: `1e999` is beyond the largest number, about 1.8e308

    error: stdin:10:34: `shear_modulus` of layer 3 (HalfPlane): found 0.0, allowed is a finite number > 0
      10 |         HalfPlane(shear_modulus: 0, poisson: 0.4),
         |                                  ^

    error: stdin:6:52: `shear_modulus` of layer 1 (Homogeneous): found -2.0, allowed is a finite number > 0
      6 |         Homogeneous(thickness: 1.0, shear_modulus: -2, poisson: 0.25),
        |                                                    ^

    error: stdin:8:77: `beta` of layer 2 (Exponential): found -inf, allowed is a finite number
      8 |         Exponential(thickness: 2.0, shear_modulus: 3.0, poisson: 0.3, beta: -inf),
        |                                                                             ^

    error: stdin:8:9: layer 2 (Exponential): beta * thickness is 2000.0; allowed is |beta * thickness| <= 100.0
      8 |         Exponential(thickness: 2.0, shear_modulus: 3.0, poisson: 0.3, beta: 1e3),
        |         ^

    error: stdin:3:29: `radius` of the punch: found 0.0, allowed is a finite number > 0
      3 |     punch: Cylinder(radius: 0.0),
        |                             ^

    error: stdin:3:29: `radius` of the punch: found NaN, allowed is a finite number > 0
      3 |     punch: Cylinder(radius: NaN),
        |                             ^

    error: stdin:4:12: `force` of the scene: found -0.002, allowed is a finite number > 0
      4 |     force: -0.002,
        |            ^

    error: stdin:4:12: `force` of the scene: found 0.0, allowed is a finite number > 0
      4 |     force: 0,
        |            ^

    error: stdin:4:12: `force` of the scene: found 0.0, allowed is a finite number > 0
      4 |     force: 1e-400,
        |            ^
    hint: `1e-400` is below the smallest number, about 5e-324
    "#);
}

#[test]
fn unknown_names() {
    insta::assert_snapshot!(refusals(&[
        ("Homogeneous(", "Homogenous("),
        ("Receding", "Recede"),
        ("HalfPlane(", "Sphere("),
        ("thickness: 1.0", "tickness: 1.0"),
        ("beta: -1.0", "beta: -1.0, gamma: 2.0"),
        ("poisson: 0.4", "poisson: 0.4, thickness: 1.0"),
        ("Cylinder(", "Cilinder("),
        ("Cylinder(radius: 500.0)", "Cylinder(diameter: 500.0)"),
        ("plane: Strain", "plane: strain"),
        ("force: 0.002", "weight: 0.002"),
        ("force: 0.002", "force: 0.002, units: (lenght: \"mm\", force: \"N\")"),
        ("Scene(", "Scenery("),
    ]), @r#"
    error: stdin:6:9: no layer or interface is called `Homogenous`; allowed are `Homogeneous`, `Exponential`, `Graded`, `Orthotropic`, `HalfPlane`, `GradedHalfPlane`, `PowerHalfPlane`, `OrthotropicHalfPlane`, `Winkler`, `Bonded`, `Sliding`, `Receding`, `Rigid`, `Spring`
      6 |         Homogenous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25),
        |         ^
    hint: did you mean `Homogeneous`?

    error: stdin:9:9: no layer or interface is called `Recede`; allowed are `Homogeneous`, `Exponential`, `Graded`, `Orthotropic`, `HalfPlane`, `GradedHalfPlane`, `PowerHalfPlane`, `OrthotropicHalfPlane`, `Winkler`, `Bonded`, `Sliding`, `Receding`, `Rigid`, `Spring`
      9 |         Recede,
        |         ^
    hint: did you mean `Receding`?

    error: stdin:10:9: no layer or interface is called `Sphere`; allowed are `Homogeneous`, `Exponential`, `Graded`, `Orthotropic`, `HalfPlane`, `GradedHalfPlane`, `PowerHalfPlane`, `OrthotropicHalfPlane`, `Winkler`, `Bonded`, `Sliding`, `Receding`, `Rigid`, `Spring`
      10 |         Sphere(shear_modulus: 4.0, poisson: 0.4),
         |         ^

    error: stdin:6:21: layer 1 (Homogeneous) has no field `tickness`; allowed are `thickness`, `shear_modulus`, `poisson`
      6 |         Homogeneous(tickness: 1.0, shear_modulus: 1.0, poisson: 0.25),
        |                     ^
    hint: did you mean `thickness`?

    error: stdin:8:83: layer 2 (Exponential) has no field `gamma`; allowed are `thickness`, `shear_modulus`, `poisson`, `beta`
      8 |         Exponential(thickness: 2.0, shear_modulus: 3.0, poisson: 0.3, beta: -1.0, gamma: 2.0),
        |                                                                                   ^

    error: stdin:10:53: layer 3 (HalfPlane) has no field `thickness`; allowed are `shear_modulus`, `poisson`
      10 |         HalfPlane(shear_modulus: 4.0, poisson: 0.4, thickness: 1.0),
         |                                                     ^

    error: stdin:3:12: the punch is `Cilinder`; allowed are `Cylinder`, `Parabola`, `Power`, `Polynomial`, `Wedge`, `RoundedFlat`, `Flat`, `Table`, `ElasticCylinder`
      3 |     punch: Cilinder(radius: 500.0),
        |            ^
    hint: did you mean `Cylinder`?

    error: stdin:3:21: the punch has no field `diameter`; allowed is `radius`
      3 |     punch: Cylinder(diameter: 500.0),
        |                     ^

    error: stdin:2:12: `plane` of the scene is `strain`; allowed are `Strain`, `Stress`
      2 |     plane: strain,
        |            ^
    hint: did you mean `Strain`?

    error: stdin:4:5: the scene has no field `weight`; allowed are `name`, `description`, `units`, `plane`, `punch`, `load`, `force`, `half_length`, `stack`
      4 |     weight: 0.002,
        |     ^

    error: stdin:4:27: `units` of the scene has no field `lenght`; allowed are `length`, `force`
      4 |     force: 0.002, units: (lenght: "mm", force: "N"),
        |                           ^
    hint: did you mean `length`?

    error: stdin:1:1: the scene begins with `Scene(`, found `Scenery`
      1 | Scenery(
        | ^
    hint: did you mean `Scene`?
    "#);
}

#[test]
fn missing_and_repeated_fields() {
    insta::assert_snapshot!(refusals(&[
        ("    plane: Strain,\n", ""),
        ("    force: 0.002,\n", ""),
        ("thickness: 1.0, ", ""),
        (", beta: -1.0", ""),
        ("radius: 500.0", ""),
        ("HalfPlane(shear_modulus: 4.0, poisson: 0.4)", "HalfPlane"),
        ("HalfPlane(shear_modulus: 4.0, poisson: 0.4)", "HalfPlane()"),
        ("force: 0.002", "force: 0.002, units: (length: \"mm\")"),
        ("force: 0.002", "force: 0.002, force: 0.004"),
        ("beta: -1.0", "beta: -1.0, beta: -2.0"),
    ]), @r#"
    error: stdin:1:1: `plane` is missing in the scene
      1 | Scene(
        | ^
    hint: add `plane: ...` between its parentheses

    error: stdin:1:1: `force` is missing in the scene
      1 | Scene(
        | ^
    hint: add `force: ...` or, for a punch, `half_length: ...` between its parentheses

    error: stdin:6:9: `thickness` is missing in layer 1 (Homogeneous)
      6 |         Homogeneous(shear_modulus: 1.0, poisson: 0.25),
        |         ^
    hint: add `thickness: ...` between its parentheses

    error: stdin:8:9: `beta` is missing in layer 2 (Exponential)
      8 |         Exponential(thickness: 2.0, shear_modulus: 3.0, poisson: 0.3),
        |         ^
    hint: add `beta: ...` between its parentheses

    error: stdin:3:12: `radius` is missing in the punch
      3 |     punch: Cylinder(),
        |            ^
    hint: add `radius: ...` between its parentheses

    error: stdin:10:18: layer 3 (HalfPlane): `(` is expected, found `,`
      10 |         HalfPlane,
         |                  ^
    hint: fields are written in parentheses: `name(field: value, ...)`

    error: stdin:10:9: `shear_modulus` is missing in layer 3 (HalfPlane)
      10 |         HalfPlane(),
         |         ^
    hint: add `shear_modulus: ...` between its parentheses

    error: stdin:4:39: `force` is missing in `units` of the scene
      4 |     force: 0.002, units: (length: "mm"),
        |                                       ^
    hint: add `force: ...` between its parentheses

    error: stdin:4:19: the scene has `force` twice
      4 |     force: 0.002, force: 0.004,
        |                   ^
    hint: remove one of them

    error: stdin:8:83: layer 2 (Exponential) has `beta` twice
      8 |         Exponential(thickness: 2.0, shear_modulus: 3.0, poisson: 0.3, beta: -1.0, beta: -2.0),
        |                                                                                   ^
    hint: remove one of them
    "#);
}

#[test]
fn wrong_types() {
    insta::assert_snapshot!(refusals(&[
        ("force: 0.002", "force: \"0.002\""),
        ("force: 0.002", "force: 0.0.2"),
        ("force: 0.002", "force: 2 N"),
        ("thickness: 1.0", "thickness: thin"),
        ("thickness: 1.0", "thickness: Some(1.0)"),
        ("plane: Strain", "plane: \"Strain\""),
        ("punch: Cylinder(radius: 500.0)", "punch: 500.0"),
        ("punch: Cylinder(radius: 500.0)", "punch: Cylinder(500.0)"),
        ("punch: Cylinder(radius: 500.0)", "punch: Cylinder"),
        ("force: 0.002", "force: 0.002, name: 7"),
        ("force: 0.002", "force: 0.002, name: scene"),
        ("Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25)", "Homogeneous(1.0, 1.0, 0.25)"),
        ("Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25)", "(thickness: 1.0)"),
        ("Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25)", "1.0"),
        ("Bonded", "Bonded(friction: 0.3)"),
        ("Bonded", "\"Bonded\""),
    ]), @r#"
    error: stdin:4:12: `force` of the scene: a number is expected, found `"0.002"`
      4 |     force: "0.002",
        |            ^

    error: stdin:4:12: `force` of the scene: a number is expected, found `0.0.2`
      4 |     force: 0.0.2,
        |            ^

    error: stdin:4:14: a comma is missing before `N`
      4 |     force: 2 N,
        |              ^

    error: stdin:6:32: `thickness` of layer 1 (Homogeneous): a number is expected, found `thin`
      6 |         Homogeneous(thickness: thin, shear_modulus: 1.0, poisson: 0.25),
        |                                ^

    error: stdin:6:32: `thickness` of layer 1 (Homogeneous): a number is expected, found `Some`
      6 |         Homogeneous(thickness: Some(1.0), shear_modulus: 1.0, poisson: 0.25),
        |                                ^

    error: stdin:2:12: `plane` of the scene: a name is expected, found `"Strain"`
      2 |     plane: "Strain",
        |            ^
    hint: names are written without quotes, fields with their names: `field: value`

    error: stdin:3:12: the punch: a name is expected, found `500.0`
      3 |     punch: 500.0,
        |            ^
    hint: names are written without quotes, fields with their names: `field: value`

    error: stdin:3:21: the punch: a name is expected, found `500.0`
      3 |     punch: Cylinder(500.0),
        |                     ^
    hint: names are written without quotes, fields with their names: `field: value`

    error: stdin:3:20: the punch: `(` is expected, found `,`
      3 |     punch: Cylinder,
        |                    ^
    hint: fields are written in parentheses: `name(field: value, ...)`

    error: stdin:4:25: `name` of the scene: a text in double quotes is expected, found `7`
      4 |     force: 0.002, name: 7,
        |                         ^

    error: stdin:4:25: `name` of the scene: a text in double quotes is expected, found `scene`
      4 |     force: 0.002, name: scene,
        |                         ^

    error: stdin:6:21: layer 1 (Homogeneous): a name is expected, found `1.0`
      6 |         Homogeneous(1.0, 1.0, 0.25),
        |                     ^
    hint: names are written without quotes, fields with their names: `field: value`

    error: stdin:6:9: a layer or an interface is expected, found `(`
      6 |         (thickness: 1.0),
        |         ^
    hint: allowed are `Homogeneous`, `Exponential`, `Graded`, `Orthotropic`, `HalfPlane`, `GradedHalfPlane`, `PowerHalfPlane`, `OrthotropicHalfPlane`, `Winkler`, `Bonded`, `Sliding`, `Receding`, `Rigid`, `Spring`

    error: stdin:6:9: a layer or an interface is expected, found `1.0`
      6 |         1.0,
        |         ^
    hint: allowed are `Homogeneous`, `Exponential`, `Graded`, `Orthotropic`, `HalfPlane`, `GradedHalfPlane`, `PowerHalfPlane`, `OrthotropicHalfPlane`, `Winkler`, `Bonded`, `Sliding`, `Receding`, `Rigid`, `Spring`

    error: stdin:7:15: `Bonded` has no fields, found `(`
      7 |         Bonded(friction: 0.3),
        |               ^
    hint: write `Bonded` alone

    error: stdin:7:9: a layer or an interface is expected, found `"Bonded"`
      7 |         "Bonded",
        |         ^
    hint: allowed are `Homogeneous`, `Exponential`, `Graded`, `Orthotropic`, `HalfPlane`, `GradedHalfPlane`, `PowerHalfPlane`, `OrthotropicHalfPlane`, `Winkler`, `Bonded`, `Sliding`, `Receding`, `Rigid`, `Spring`
    "#);
    insta::assert_snapshot!(refusal("Scene(plane: Strain, punch: Parabola(radius: 1), force: 1, stack: Rigid)"), @r#"
    error: stdin:1:67: the stack: a list in `[` and `]` is expected, found `Rigid`
      1 | Scene(plane: Strain, punch: Parabola(radius: 1), force: 1, stack: Rigid)
        |                                                                   ^
    "#);
    insta::assert_snapshot!(refusal("[1, 2, 3]"), @r#"
    error: stdin:1:1: the scene: `(` is expected, found `[`
      1 | [1, 2, 3]
        | ^
    hint: fields are written in parentheses: `name(field: value, ...)`
    "#);
    insta::assert_snapshot!(refusal("{\"plane\": \"Strain\"}"), @r#"
    error: stdin:1:1: the scene: `(` is expected, found `{`
      1 | {"plane": "Strain"}
        | ^
    hint: fields are written in parentheses: `name(field: value, ...)`
    "#);
}

#[test]
fn what_may_be_written_in_a_scene() {
    for (from, to) in [
        ("poisson: 0.25", "poisson: 0.5"),
        ("poisson: 0.25", "poisson: -0.9999999999999999"),
        ("thickness: 1.0", "thickness: 0"),
        ("thickness: 1.0", "thickness: 1"),
        ("thickness: 1.0", "thickness: 1e-300"),
        ("beta: -1.0", "beta: 0"),
        ("beta: -1.0", "beta: 1e-300"),
        ("beta: -1.0)", "beta: -1.0,)"),
        ("Bonded,", "// glued\n Bonded /* always */ , // really"),
        ("Cylinder(radius: 500.0)", "/* a roller */ Parabola( radius : 5e2 , )"),
        ("Scene(", "("),
        ("Scene(", "\u{feff}// with a mark\r\nScene("),
        (
            "force: 0.002",
            "force: 0.002, name: \"µ\", description: \"two\nlines\", units: (length: \"mm\", force: \"N\")",
        ),
        ("force: 0.002", "force: 0.002, name: Some(\"a\")"),
    ] {
        let run = recede(&["check", "-"], with(from, to).as_bytes());
        assert_eq!(run.status, Some(0), "{to}: {}", run.stderr);
    }
}
