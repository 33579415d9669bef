//! `recede list` cannot be out of date: every name that it lists is one that the reader of scenes allows, at that place, and
//! there are no others.
//!
//! At each place of a scene something is written that cannot be right. What the reader then says is allowed has to be what is
//! listed.
use std::process::Command;

use recede::layers::description::{Field, Form, Value};
use recede::{Registry, Scene, Vocabulary};

/// A scene in which `text` stands for a field, or at a place, of which `text` is a function.
type Place<'a> = &'a dyn Fn(&str) -> String;

const WRONG_NUMBER: &str = "-inf";

/// Every legal field of a scene, with one of them replaced.
fn scene_with(field: &str, text: &str) -> String {
    let fields = [
        ("geometry", "PlaneStrain"),
        ("punch", "Parabola(radius: 1.0)"),
        ("force", "1.0"),
        ("stack", "[HalfPlane(shear_modulus: 1.0, poisson: 0.25)]"),
    ];
    // a load takes the place of a punch, and several loads or punches have forces of their own
    let replaced: &[&str] = match field {
        "load" => &["punch"],
        "loads" | "punches" => &["punch", "force"],
        own => &[own],
    };
    let others =
        fields.iter().filter(|(name, _)| !replaced.contains(name)).map(|(name, value)| format!("{name}: {value}"));
    let all: Vec<String> = [format!("{field}: {text}")].into_iter().chain(others).collect();
    format!("Scene({})", all.join(", "))
}

fn refusal(text: &str) -> String {
    let error = Scene::from_ron(text).expect_err(text);
    format!("{error} {}", error.hint().unwrap_or_default())
}

/// `allowed are` exactly these.
fn assert_allowed(place: Place, wrong: &str, names: &[&str]) {
    let list = names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let refusal = refusal(&place(wrong));
    let told = refusal.split("allowed are ").nth(1).or(refusal.split("allowed is ").nth(1));
    let told = told.unwrap_or_else(|| panic!("{}: {refusal}", place(wrong)));
    assert!(told.strip_prefix(&list).is_some_and(|rest| !rest.starts_with(',')), "{refusal}\nlisted are {list}");
}

fn examine(place: Place, value: &Value, seen: &mut usize) {
    *seen += 1;
    match value {
        Value::Plain(list) if list.starts_with('[') || list.starts_with("a list") => {
            assert!(refusal(&place(WRONG_NUMBER)).contains("a list in `[` and `]`"), "{list}");
        }
        Value::Plain(allowed) => {
            let wrong = if allowed.starts_with("a text of") { "\"\"" } else { WRONG_NUMBER };
            let refusal = refusal(&place(wrong));
            assert!(refusal.contains(allowed), "{refusal}\nlisted is {allowed}");
        }
        Value::Fields(fields) => examine_fields(&|text| place(&format!("({text})")), fields, seen),
        Value::OneOf(forms) => {
            let names: Vec<&str> = forms.iter().map(|form| &form.name[..]).collect();
            assert_allowed(place, "NoSuchName", &names);
            examine_forms(place, forms, seen);
        }
    }
}

fn examine_fields(place: Place, fields: &[Field], seen: &mut usize) {
    let names: Vec<&str> = fields.iter().map(|field| &field.name[..]).collect();
    assert_allowed(place, "no_such_field: 0", &names);
    for field in fields {
        assert!(field.meaning.len() > 3, "{} has no meaning", field.name);
        examine(&|text| place(&format!("{}: {text}", field.name)), &field.value, seen);
    }
}

fn examine_forms(place: Place, forms: &[Form], seen: &mut usize) {
    for form in forms {
        assert!(form.meaning.len() > 3, "{} has no meaning", form.name);
        match &form.value {
            Some(Value::Fields(fields)) => {
                examine_fields(&|text| place(&format!("{}({text})", form.name)), fields, seen)
            }
            Some(value) => examine(&|text| place(&format!("{}({text})", form.name)), value, seen),
            None => *seen += 1,
        }
    }
}

#[test]
fn what_is_listed_is_what_is_read() {
    let Vocabulary { scene, punches, loads, round_punches, round_loads, layers, interfaces, bases } =
        Vocabulary::new(&Registry::default());
    let mut seen = 0;
    let names: Vec<&str> = scene.iter().map(|field| &field.name[..]).collect();
    assert_allowed(&|text| format!("Scene({text})"), "no_such_field: 0", &names);
    for field in &scene {
        examine(&|text| scene_with(&field.name, text), &field.value, &mut seen);
    }
    examine(&|text| scene_with("punch", text), &Value::OneOf(punches), &mut seen);
    examine(&|text| scene_with("load", text), &Value::OneOf(loads), &mut seen);
    let round_with = |field: &str, text: &str| scene_with(field, text).replace("PlaneStrain", "Axisymmetric");
    examine(&|text| round_with("punch", text), &Value::OneOf(round_punches), &mut seen);
    examine(&|text| round_with("load", text), &Value::OneOf(round_loads), &mut seen);
    let registered: Vec<&str> = Registry::default().iter().map(|entry| entry.name).collect();
    let item = |text: &str| scene_with("stack", &format!("[{text}]"));
    assert_allowed(
        &item,
        "NoSuchName",
        &[&registered[..], &["Bonded", "Sliding", "Receding", "Rigid", "Spring"]].concat(),
    );
    let all: Vec<Form> = [layers, interfaces, bases].concat();
    assert_eq!(all.len(), registered.len() + 5);
    assert!(registered.iter().all(|name| all.iter().any(|form| form.name == *name)));
    examine_forms(&item, &all, &mut seen);
    assert!(seen > 80, "{seen} places");
}

#[test]
fn fields_that_are_not_optional_are_missed() {
    let Vocabulary { layers, bases, .. } = Vocabulary::new(&Registry::default());
    let mut missed = 0;
    for form in layers.iter().chain(&bases) {
        let Some(Value::Fields(fields)) = &form.value else { continue };
        let refusal = refusal(&scene_with("stack", &format!("[{}()]", form.name)));
        let first = fields.iter().find(|field| !field.optional).expect("a field that is needed");
        assert!(refusal.contains(&format!("`{}` is missing", first.name)), "{refusal}");
        missed += 1;
    }
    assert!(missed >= 8, "{missed}");
}

#[test]
fn the_command_prints_all_of_it() {
    let output = Command::new(env!("CARGO_BIN_EXE_recede")).arg("list").output().expect("a command that runs");
    let text = String::from_utf8(output.stdout).expect("a text");
    assert!(output.status.success() && output.stderr.is_empty());
    let Vocabulary { scene, punches, loads, round_punches, round_loads, layers, interfaces, bases } =
        Vocabulary::new(&Registry::default());
    let forms: Vec<Form> = [punches, loads, round_punches, round_loads, layers, interfaces, bases].concat();
    let fields = forms.iter().filter_map(|form| match &form.value {
        Some(Value::Fields(fields)) => Some(fields),
        _ => None,
    });
    let words = fields.flatten().chain(&scene).map(|field| (&field.name, &field.meaning));
    for (name, meaning) in words.chain(forms.iter().map(|form| (&form.name, &form.meaning))) {
        let listed = text.lines().any(|line| line.trim_start().starts_with(&name[..]) && line.contains(&meaning[..]));
        assert!(listed, "{name} {meaning}\n{text}");
    }
}
