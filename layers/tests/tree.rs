//! Texts are read into trees with the places of the text.
use std::fs;
use std::path::Path;

use recede_layers::tree::{Kind, Node};

/// The text of all scenes that ship.
fn scenes() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/scenes");
    let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file").path());
    let texts = files.filter(|file| file.extension().is_some_and(|ending| ending == "ron"));
    texts.map(|file| fs::read_to_string(file).expect("a text")).collect()
}

/// The same with all places so many bytes later.
fn later(node: &Node, bytes: usize) -> Node {
    let mut node = node.clone();
    node.place = node.place.start + bytes..node.place.end + bytes;
    node.inner += bytes;
    match &mut node.kind {
        Kind::List(members) | Kind::Row(members) => {
            members.iter_mut().for_each(|member| *member = later(member, bytes))
        }
        Kind::Fields(fields) => fields.iter_mut().for_each(|field| {
            field.at += bytes;
            field.value = later(&field.value, bytes);
        }),
        Kind::Nothing | Kind::Number(_) | Kind::Text(_) => {}
    }
    node
}

/// Reads what stands at the place of each value again, and counts the values.
fn read_each_again(node: &Node, text: &str) -> usize {
    let alone = Node::from_ron(&text[node.place.clone()]).expect("a part of a text is a text");
    assert_eq!(&later(&alone, node.place.start), node);
    for field in node.fields() {
        assert!(text[field.at..].starts_with(&*field.name));
    }
    let inner = node.members().iter().chain(node.fields().iter().map(|field| &field.value));
    1 + inner.map(|inner| read_each_again(inner, text)).sum::<usize>()
}

#[test]
fn each_value_stands_at_its_place() {
    let values: usize = scenes().iter().map(|text| read_each_again(&Node::from_ron(text).expect("RON"), text)).sum();
    assert!(values > 400, "{values}");
}

#[test]
fn values_of_all_kinds_are_read() {
    let read = |text: &str| Node::from_ron(text).map(|node| node.kind).map_err(|error| (error.at, error.to_string()));
    for (text, number) in [
        ("1", 1.0),
        ("-.5", -0.5),
        ("+2.", 2.0),
        ("1_000.5e-1_0", 1000.5e-10),
        ("inf", f64::INFINITY),
        ("-inf", f64::NEG_INFINITY),
        ("2f64", 2.0),
        ("/* a /* b */ */ 3 // c", 3.0),
        ("#![enable(implicit_some)]\n#![type = \"scene\"] 4", 4.0),
    ] {
        assert_eq!(read(text), Ok(Kind::Number(number)), "{text}");
    }
    for (text, expected) in [
        (r#""a \"b\" \\ \n\t \u{e9} \x41""#, "a \"b\" \\ \n\t é A"),
        ("\"one \\\n   line\"", "one line"),
        (r###"r#"raw "text" \n"#"###, r#"raw "text" \n"#),
        ("r\"\"", ""),
    ] {
        assert_eq!(read(text), Ok(Kind::Text(expected.to_owned())), "{text}");
    }
    assert_eq!(read("Name"), Ok(Kind::Nothing));
    assert_eq!(Node::from_ron("r#half-space").map(|node| node.name), Ok(Some("half-space".into())));
    for (text, at, said) in [
        ("", 0, "the text ends too early"),
        ("(1, 2", 5, "the text ends too early"),
        ("(a: 1,, b: 2)", 6, "a name is expected"),
        ("[1,, 2]", 3, "`,` makes no sense here"),
        ("(a 1)", 3, "a colon is missing before `1`"),
        ("(a: )", 4, "`a`: a value is expected, found `)`"),
        ("(1 2)", 3, "a comma is missing before `2`"),
        ("(a: 1 mm)", 6, "`mm` follows a number"),
        ("(a: 1 b: 2)", 6, "a comma is missing before `b`"),
        ("\"a", 1, "a closing `\"` is missing"),
        (r#""\q""#, 1, r"`\q` makes no sense in a text"),
        ("(1)]", 3, "something follows the end"),
        ("#![enable(all)] 1", 10, "no extension of RON is called `all`"),
    ] {
        assert_eq!(read(text), Err((Some(at), said.to_owned())), "{text}");
    }
}

#[test]
fn brackets_are_read_to_a_depth_in_both_notations() {
    let nested = |open: &str, close: &str, depth: usize| format!("{}1{}", open.repeat(depth), close.repeat(depth));
    for (open, close) in [("[", "]"), ("(", ")"), ("A(", ")"), ("(a: ", ")")] {
        assert!(Node::from_ron(&nested(open, close, 128)).is_ok(), "{open}");
        let error = Node::from_ron(&nested(open, close, 129)).unwrap_err();
        assert_eq!(error.to_string(), "brackets are nested too deeply");
    }
    for (open, close) in [("[", "]"), ("{\"a\": ", "}"), ("{\"A\": ", "}")] {
        assert!(Node::from_json(&nested(open, close, 128)).is_ok(), "{open}");
        assert!(Node::from_json(&nested(open, close, 129)).is_err(), "{open}");
    }
}

#[test]
fn json_is_read_into_the_tree_of_the_same_text_in_ron() {
    let json = r#"{"$schema": "s", "name": "Name", "law": {"Table": [[0, 1], [2, {"Constant": 3}]]}, "kind": "Kind",
        "empty": {"None": null}, "nothing": null, "flag": true, "fields": {"Fields": {"x": 1}}}"#;
    let ron = r#"(name: "Name", law: Table([(0, 1), (2, Constant(3))]), kind: Kind,
        empty: None, nothing: None, flag: true, fields: Fields(x: 1))"#;
    /// The same without places.
    fn plain(mut node: Node) -> Node {
        (node.place, node.inner) = (0..0, 0);
        match &mut node.kind {
            Kind::List(members) | Kind::Row(members) => {
                members.iter_mut().for_each(|member| *member = plain(std::mem::take(member)));
            }
            Kind::Fields(fields) => fields.iter_mut().for_each(|field| {
                field.at = 0;
                field.value = plain(std::mem::take(&mut field.value));
            }),
            Kind::Nothing | Kind::Number(_) | Kind::Text(_) => {}
        }
        node
    }
    assert_eq!(Node::from_json(json).map(plain), Node::from_ron(ron).map(plain));
}

/// Types that a layer of one's own may have among its fields.
#[derive(Debug, PartialEq, serde::Deserialize)]
struct Own {
    flag: bool,
    order: u8,
    shift: i64,
    label: String,
    plain: Option<f32>,
    other: Option<f64>,
    pair: (f64, String),
    wrapped: Wrapped,
    unit: Unit,
    choice: Choice,
    list: Vec<Choice>,
    numbers: std::collections::BTreeMap<String, f64>,
}

#[derive(Debug, PartialEq, serde::Deserialize)]
struct Wrapped(f64);

#[derive(Debug, PartialEq, serde::Deserialize)]
struct Unit;

#[derive(Debug, PartialEq, serde::Deserialize)]
enum Choice {
    Alone,
    One(f64),
    Two(f64, f64),
    Fields { x: f64 },
}

#[test]
fn values_of_any_type_are_read() {
    let text = "Own(flag: true, order: 3, shift: -2, label: \"l\", plain: 0.5, other: Some(1), pair: (1, \"b\"), wrapped: Wrapped(2),
        unit: Unit, choice: Alone, list: [One(1), Two(1, 2), Fields(x: 3)], numbers: (a: 1, b: 2))";
    let expected = Own {
        flag: true,
        order: 3,
        shift: -2,
        label: "l".to_owned(),
        plain: Some(0.5),
        other: Some(1.0),
        pair: (1.0, "b".to_owned()),
        wrapped: Wrapped(2.0),
        unit: Unit,
        choice: Choice::Alone,
        list: vec![Choice::One(1.0), Choice::Two(1.0, 2.0), Choice::Fields { x: 3.0 }],
        numbers: [("a".to_owned(), 1.0), ("b".to_owned(), 2.0)].into(),
    };
    assert_eq!(Node::from_ron(text).and_then(|node| node.read::<Own>()), Ok(expected));
    for (old, new, at, field, said) in [
        ("true", "3", "3", Some("flag"), "a boolean is expected, found integer `3`"),
        ("order: 3", "order: 300", "300", Some("order"), "u8 is expected, found integer `300`"),
        ("order: 3", "order: 1.5", "1.5", Some("order"), "u8 is expected, found floating point `1.5`"),
        ("\"l\"", "l", "l,", Some("label"), "a text in double quotes is expected"),
        ("(1, \"b\")", "(1)", "(1)", Some("pair"), "a tuple of size 2 is expected, the length is 1"),
        ("(1, \"b\")", "(1, \"b\", 3)", "3)", Some("pair"), "`)` is expected"),
        ("Alone", "Alone(1)", "(1)", Some("choice"), "something follows a name that stands alone"),
        (
            "Alone",
            "Alne",
            "Alne",
            Some("choice"),
            "found `Alne`, allowed are [\"Alone\", \"One\", \"Two\", \"Fields\"]",
        ),
        ("One(1)", "One(a)", "a)", Some("list"), "a number is expected"),
        ("Fields(x: 3)", "Fields(x: 3, x: 4)", "x: 4", Some("list"), "`x` stands twice"),
        ("Fields(x: 3)", "Fields()", ")]", Some("list"), "`x` is missing"),
        ("Fields(x: 3)", "Fields(3)", "3)", Some("list"), "a name is expected"),
        ("Own(", "Owned(", "Owned", None, "found `Owned`, the name is `Own`"),
    ] {
        let wrong = text.replacen(old, new, 1);
        let error = Node::from_ron(&wrong).and_then(|node| node.read::<Own>()).unwrap_err();
        assert_eq!((error.field.as_deref(), &error.to_string()[..]), (field, said), "{new}");
        let rest = &wrong[error.at.expect("a place")..];
        assert!(rest.starts_with(at), "{new}: {rest}");
    }
}
