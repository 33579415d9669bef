//! Stacks that are none, slips of the pen and texts that are no scene: told by line and column; exit status 2.
#[path = "support/refusal.rs"]
mod refusal;
mod support;

use refusal::{SCENE, refusal, refusals, with};
use support::recede;

/// The stack in place of that of the scene above, one item a line, from line 6 on.
fn stack(items: &[&str]) -> String {
    let (start, end) = (SCENE.find("Homogeneous").unwrap(), SCENE.find("\n    ],").unwrap());
    format!("{}{}{}", &SCENE[..start], items.join("\n        "), &SCENE[end..])
}

const STRIP: &str = "Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25),";
const NOTHING: &str = "Homogeneous(thickness: 0.0, shear_modulus: 1.0, poisson: 0.25),";
const GROUND: &str = "HalfPlane(shear_modulus: 1.0, poisson: 0.25),";

#[test]
fn stacks_that_are_none() {
    insta::assert_snapshot!(refusal(stack(&[])), @r#"
    error: stdin:5:12: the stack is empty
      5 |     stack: [
        |            ^
    hint: write the layers from the top down, ending in `HalfPlane(...)` or `Rigid`
    "#);
    insta::assert_snapshot!(refusal(stack(&[STRIP, STRIP, "Bonded,", GROUND])), @r#"
    error: stdin:7:9: no interface between layer 1 (Homogeneous) and layer 2 (Homogeneous)
      7 |         Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25),
        |         ^
    hint: write `Bonded`, `Receding`, `Sliding` or `Spring(...)` between them
    "#);
    insta::assert_snapshot!(refusal(stack(&[STRIP, "Bonded,", "// loose", STRIP, GROUND])), @r#"
    error: stdin:10:9: no interface between layer 2 (Homogeneous) and layer 3 (HalfPlane)
      10 |         HalfPlane(shear_modulus: 1.0, poisson: 0.25),
         |         ^
    hint: write `Bonded`, `Receding`, `Sliding` or `Spring(...)` between them
    "#);
    insta::assert_snapshot!(refusal(stack(&[STRIP, "Bonded,", "Receding,", GROUND])), @r#"
    error: stdin:8:9: two interfaces in a row: `Receding` follows `Bonded`
      8 |         Receding,
        |         ^
    hint: remove one of them, or write the layer between them
    "#);
    insta::assert_snapshot!(refusal(stack(&["Bonded,", STRIP, "Bonded,", GROUND])), @r#"
    error: stdin:6:9: the stack begins with the interface `Bonded`; allowed is a layer
      6 |         Bonded,
        |         ^
    hint: the punch acts on the first layer without an interface
    "#);
    insta::assert_snapshot!(refusal(stack(&[STRIP, "Bonded,", STRIP, "Receding,"])), @r#"
    error: stdin:9:9: the stack ends with the interface `Receding`: nothing lies below it
      9 |         Receding,
        |         ^
    hint: end the stack with `HalfPlane(...)` or `Rigid`
    "#);
    insta::assert_snapshot!(refusal(stack(&[STRIP, "Bonded,", STRIP])), @r#"
    error: stdin:8:9: the stack ends with layer 2 (Homogeneous), which is no base; allowed are `Rigid` and layers without a thickness, such as `HalfPlane`
      8 |         Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25),
        |         ^
    hint: add an interface and `HalfPlane(...)` or `Rigid` below it
    "#);
    insta::assert_snapshot!(refusal(stack(&[GROUND, "Bonded,", STRIP, "Bonded,", GROUND])), @r#"
    error: stdin:6:9: layer 1 (HalfPlane) is not at the bottom of the stack
      6 |         HalfPlane(shear_modulus: 1.0, poisson: 0.25),
        |         ^
    hint: end the stack here, or put a layer with a thickness in its place
    "#);
    insta::assert_snapshot!(refusal(stack(&[STRIP, "Receding,", "Rigid,", "Receding,", GROUND])), @r#"
    error: stdin:8:9: the rigid base is not at the bottom of the stack
      8 |         Rigid,
        |         ^
    hint: end the stack here, or put a layer with a thickness in its place
    "#);
    insta::assert_snapshot!(refusal(stack(&[GROUND, "Rigid,"])), @r#"
    error: stdin:6:9: layer 1 (HalfPlane) is not at the bottom of the stack
      6 |         HalfPlane(shear_modulus: 1.0, poisson: 0.25),
        |         ^
    hint: end the stack here, or put a layer with a thickness in its place
    "#);
    insta::assert_snapshot!(refusal(stack(&["Rigid,"])), @r#"
    error: stdin:6:9: nothing can deform between the punch and the rigid base
      6 |         Rigid,
        |         ^
    hint: write a layer with a thickness above `Rigid`, or use `HalfPlane(...)`
    "#);
    insta::assert_snapshot!(refusal(stack(&[NOTHING, "Bonded,", NOTHING, "Receding,", "Rigid,"])), @r#"
    error: stdin:10:9: nothing can deform between the punch and the rigid base
      10 |         Rigid,
         |         ^
    hint: write a layer with a thickness above `Rigid`, or use `HalfPlane(...)`
    "#);
    insta::assert_snapshot!(refusal(stack(&["Receding,"])), @r#"
    error: stdin:6:9: the stack begins with the interface `Receding`; allowed is a layer
      6 |         Receding,
        |         ^
    hint: the punch acts on the first layer without an interface
    "#);
    let thick = STRIP.replace("1.0, s", "1e308, s");
    insta::assert_snapshot!(refusal(stack(&[&thick, "Bonded,", &thick, "Bonded,", "Rigid,"])), @r#"
    error: stdin:5:12: the layers together are thicker than the largest number, about 1.8e308
      5 |     stack: [
        |            ^
    "#);
}

#[test]
fn punctuation() {
    insta::assert_snapshot!(refusals(&[
        ("force: 0.002,", "force: 0.002"),
        ("force: 0.002", "force = 0.002"),
        ("force: 0.002", "force: ,"),
        ("Bonded,", "Bonded"),
        ("Bonded,", "Bonded,,"),
        ("poisson: 0.25)", "poisson: 0.25"),
        ("poisson: 0.25)", "poisson: 0.25))"),
        ("poisson: 0.25)", "poisson: 0.25]"),
        ("poisson: 0.3,", "poisson: 0,3,"),
        ("plane: Strain,", "/* plane: Strain,"),
        ("plane: Strain,", "plane: Strain, name: \"open,"),
        ("    ],\n)\n", "    ],\n))\n"),
        ("Scene(", "#![enable(everything)]\nScene("),
    ]), @r#"
    error: stdin:5:5: a comma is missing before `stack`
      5 |     stack: [
        |     ^

    error: stdin:4:11: a colon is missing before `=`
      4 |     force = 0.002,
        |           ^
    hint: fields are written with their names, `field: value`; is a `)` missing before?

    error: stdin:4:12: `force` of the scene: a number is expected, found `,`
      4 |     force: ,,
        |            ^

    error: stdin:8:9: a comma is missing before `Exponential`
      8 |         Exponential(thickness: 2.0, shear_modulus: 3.0, poisson: 0.3, beta: -1.0),
        |         ^

    error: stdin:7:16: `,` makes no sense here
      7 |         Bonded,,
        |                ^

    error: stdin:7:15: a colon is missing before `,`
      7 |         Bonded,
        |               ^
    hint: fields are written with their names, `field: value`; is a `)` missing before?

    error: stdin:6:71: `)` makes no sense here
      6 |         Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25)),
        |                                                                       ^
    hint: is it one too many, or is another bracket not closed?

    error: stdin:6:70: `]` makes no sense here
      6 |         Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25],
        |                                                                      ^
    hint: is it one too many, or is another bracket not closed?

    error: stdin:8:68: the scene: a name is expected, found `3`
      8 |         Exponential(thickness: 2.0, shear_modulus: 3.0, poisson: 0,3, beta: -1.0),
        |                                                                    ^
    hint: names are written without quotes, fields with their names: `field: value`

    error: stdin:13:1: the text ends too early
      13 | 
         | ^
    hint: is a closing `)`, `]` or `"` missing?

    error: stdin:2:27: a closing `"` is missing
      2 |     plane: Strain, name: "open,
        |                           ^

    error: stdin:12:2: `)` follows the end of the scene
      12 | ))
         |  ^
    hint: is there a `)` or `]` too many before it?

    error: stdin:1:21: the scene: No RON extension named `everything`
      1 | #![enable(everything)]
        |                     ^
    "#);
}

#[test]
fn texts_cut_off_anywhere() {
    for end in 0..SCENE.trim_end().len() {
        let text = refusal(&SCENE[..end]);
        assert!(text.starts_with("error: stdin:"), "{text}");
    }
    insta::assert_snapshot!(refusal(&SCENE[..SCENE.find("0.25").unwrap() + 3]), @r#"
    error: stdin:6:69: the text ends too early
      6 |         Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.2
        |                                                                     ^
    hint: is a closing `)`, `]` or `"` missing?
    "#);
}

#[test]
fn what_is_no_text() {
    insta::assert_snapshot!(refusal(""), @r#"
    error: stdin: the text is empty
    hint: a scene begins with `Scene(plane: Strain, punch: ..., force: ..., stack: [...])`
    "#);
    insta::assert_snapshot!(refusal(" \n\t\r\n"), @r#"
    error: stdin: the text is empty
    hint: a scene begins with `Scene(plane: Strain, punch: ..., force: ..., stack: [...])`
    "#);
    insta::assert_snapshot!(refusal("// only a comment\n"), @r#"
    error: stdin:2:1: the text ends too early
      2 | 
        | ^
    hint: is a closing `)`, `]` or `"` missing?
    "#);
    insta::assert_snapshot!(refusal(b"\x7fELF\x02\x01\x01\0\0\0"), @r#"
    error: stdin:1:1: the scene: `(` is expected, found `�ELF������`
      1 |  ELF      
        | ^
    hint: fields are written in parentheses: `name(field: value, ...)`
    "#);
    insta::assert_snapshot!(refusal(b"Scene(\n    name: \"\xff\xfe\""), @r#"
    error: stdin:2:12: the byte 0xFF is no UTF-8 text
      2 |     name: "
        |            ^
    hint: a scene is a text file in UTF-8
    "#);
    insta::assert_snapshot!(refusal("\u{1b}[31mScene("), @r#"
    error: stdin:1:1: the scene: `(` is expected, found `�`
      1 |  [31mScene(
        | ^
    hint: fields are written in parentheses: `name(field: value, ...)`
    "#);
    insta::assert_snapshot!(refusal(vec![b' '; (1 << 20) + 1]), @r#"
    error: stdin: the text is larger than 1048576 bytes, the most that is read
    hint: is this a scene file?
    "#);
}

#[test]
fn endless_nesting_and_endless_stacks() {
    for bracket in ["[", "(", "{", "Some(", "Cylinder(radius: ", "a(", "/*", "#![", "((((,"] {
        let nested = bracket.repeat((1 << 20) / bracket.len() - 100);
        refusal(&nested);
        for (from, to) in [("0.002", nested.as_str()), ("Cylinder(", &nested), ("Bonded", &nested), ("4.0", &nested)] {
            refusal(with(from, to));
        }
    }
    insta::assert_snapshot!(refusal(with("Bonded", &"[".repeat(1000))), @r#"
    error: stdin:7:72: brackets are nested too deeply
      7 | [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[
        |                                                   ^
    hint: a scene needs no more than four levels of brackets
    "#);
    insta::assert_snapshot!(refusal(stack(&["Rigid,".repeat(100_001).as_str()])), @r#"
    error: stdin:5:12: the stack has 100001 items; allowed are at most 100000
      5 |     stack: [
        |            ^
    "#);
}

#[test]
fn files_that_cannot_be_read() {
    let run = recede(&["solve", "no/such/scene.ron"], b"");
    assert_eq!(run.status, Some(2));
    assert!(run.stderr.starts_with("error: no/such/scene.ron: cannot be read: "), "{}", run.stderr);
    let run = recede(&["check", "examples"], b"");
    assert_eq!(run.status, Some(2));
    assert!(run.stderr.starts_with("error: examples: cannot be read: "), "{}", run.stderr);
}
