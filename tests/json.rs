//! Scenes in JSON are the scenes in RON: the same names, the same numbers, the same errors at their own places, and all of
//! them are as the schema says.
use std::fs;
use std::path::{Path, PathBuf};

use recede::selftest::{Ranges, scene_of_any_kind};
use recede::{Registry, Scene, scene_schema};
use serde_json::{Value, json};

use crate::support::{Run, recede};

/// Keywords of schemas that the test knows, and others that say nothing of what is allowed.
const KEYWORDS: [&str; 17] = [
    "$schema",
    "title",
    "description",
    "type",
    "properties",
    "required",
    "additionalProperties",
    "items",
    "oneOf",
    "anyOf",
    "enum",
    "const",
    "minimum",
    "maximum",
    "exclusiveMinimum",
    "default",
    "format",
];

/// The schemas or values in a list under a keyword.
fn list<'a>(schema: &'a Value, keyword: &str) -> &'a [Value] {
    schema[keyword].as_array().map_or(&[], |list| list)
}

/// The schema of scenes, with the items of a stack in place of references to them.
fn scenes() -> Value {
    fn resolve(schema: &mut Value, items: &Value) {
        if schema.get("$ref").is_some() {
            assert_eq!(schema["$ref"], "#/properties/stack/items");
            *schema = items.clone();
        }
        match schema {
            Value::Object(fields) => fields.values_mut().for_each(|value| resolve(value, items)),
            Value::Array(values) => values.iter_mut().for_each(|value| resolve(value, items)),
            _ => {}
        }
    }
    let mut schema = scene_schema(&Registry::default());
    let mut items = schema["properties"]["stack"]["items"].clone();
    // no item has a covered punch
    resolve(&mut items, &Value::Null);
    resolve(&mut schema, &items);
    schema
}

/// Why a value is not as a schema says, for the keywords that occur there.
fn contradiction(schema: &Value, value: &Value, place: &str) -> Option<String> {
    for (keyword, _) in schema.as_object().into_iter().flatten() {
        assert!(KEYWORDS.contains(&&keyword[..]), "{place}: the test does not know `{keyword}`");
    }
    let wrong = !has_type(schema, value) || !in_range(schema, value);
    let other = schema.get("const").is_some_and(|only| only != value)
        || !list(schema, "enum").is_empty() && !list(schema, "enum").contains(value);
    let fitting = |keyword: &str| {
        list(schema, keyword).iter().filter(|schema| contradiction(schema, value, place).is_none()).count()
    };
    let ambiguous = !list(schema, "oneOf").is_empty() && fitting("oneOf") != 1;
    let none = !list(schema, "anyOf").is_empty() && fitting("anyOf") == 0;
    if wrong || other || ambiguous || none {
        return Some(format!("{place}: {value} is not allowed"));
    }
    in_fields(schema, value, place).or_else(|| in_elements(schema, value, place))
}

fn has_type(schema: &Value, value: &Value) -> bool {
    let is = |name: &str| match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "null" => value.is_null(),
        other => panic!("{other}"),
    };
    match &schema["type"] {
        Value::String(name) => is(name),
        Value::Array(names) => names.iter().any(|name| is(name.as_str().unwrap())),
        _ => true,
    }
}

fn in_range(schema: &Value, value: &Value) -> bool {
    let Some(number) = value.as_f64() else { return true };
    let bound = |keyword: &str| schema[keyword].as_f64();
    bound("minimum").is_none_or(|least| number >= least)
        && bound("exclusiveMinimum").is_none_or(|least| number > least)
        && bound("maximum").is_none_or(|most| number <= most)
}

fn in_fields(schema: &Value, value: &Value, place: &str) -> Option<String> {
    let fields = value.as_object()?;
    if let Some(missing) = list(schema, "required").iter().find(|name| !fields.contains_key(name.as_str().unwrap())) {
        return Some(format!("{place}: {missing} is missing"));
    }
    fields.iter().find_map(|(name, inner)| match schema["properties"].get(name) {
        Some(schema) => contradiction(schema, inner, &format!("{place}.{name}")),
        None => (schema["additionalProperties"] == false).then(|| format!("{place}: {name} is unknown")),
    })
}

fn in_elements(schema: &Value, value: &Value, place: &str) -> Option<String> {
    let (items, elements) = (schema.get("items")?, value.as_array()?);
    let in_element = |(i, element)| contradiction(items, element, &format!("{place}[{i}]"));
    elements.iter().enumerate().find_map(in_element)
}

fn shipped() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes");
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    files.filter(|file| file.extension().is_some_and(|ending| ending == "ron")).collect()
}

#[test]
fn scenes_of_all_kinds_are_the_same_in_json() {
    let schema = scenes();
    let shipped = shipped().into_iter().map(|file| Scene::read(file).unwrap());
    let random = (0..150).map(|number| scene_of_any_kind(&Ranges::default(), 5, number).unwrap());
    let far = "(geometry: PlaneStress, punch: Cylinder(radius: 3e2), force: 1e-300, stack: [
        HalfPlane(shear_modulus: 1e20, poisson: 0.5)], units: (length: \"mm\", force: \"N\"))";
    let mut kinds = 0;
    for mut scene in shipped.chain(random).chain([Scene::from_ron(far).unwrap()]) {
        scene.name = Some("a \"name\"\\".into());
        scene.description = Some("µ\u{1}\ttwo\r\nlines\u{7f}".into());
        let text = scene.to_json();
        let again = Scene::from_json(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        for again in [&again, &Scene::from_ron(&scene.to_ron()).unwrap()] {
            assert_eq!(again.to_ron(), scene.to_ron());
            assert_eq!(
                (&again.name, &again.description, &again.units),
                (&scene.name, &scene.description, &scene.units)
            );
        }
        let value: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(contradiction(&schema, &value, "scene"), None, "{text}");
        // minified, and with the keys in another order
        let minified = Scene::from_json(&value.to_string()).unwrap();
        assert_eq!(minified.to_ron(), scene.to_ron());
        kinds += 1;
    }
    assert!(kinds > 170);
}

fn example() -> Value {
    json!({
        "$schema": "scene.schema.json",
        "name": "N",
        "units": {"length": "mm", "force": "N"},
        "geometry": "PlaneStrain",
        "punch": {"Table": [[0, 0], ["500 um", 0.01], [1, 0.05]]},
        "force": "13 N/m",
        "stack": [
            {"Homogeneous": {"thickness": "1000 um", "young": "26 MPa", "poisson": 0.25}},
            {"Spring": {"normal": 300.0, "tangential": null}},
            {"Graded": {"thickness": 1, "shear_modulus": {"Table": [[0, "1 MPa"], ["1 mm", 2.0]]}, "poisson": 0.3}},
            "Receding",
            "Rigid",
        ],
    })
}

#[test]
fn what_the_reader_refuses_the_schema_refuses_too() {
    let schema = scenes();
    assert_eq!(contradiction(&schema, &example(), "scene"), None);
    let scene = Scene::from_json(&example().to_string()).unwrap();
    assert_eq!(scene.title(), "N");
    assert_eq!((scene.number("force").unwrap(), scene.number("layer[1].young").unwrap()), (0.013, 26.0));
    let replaced = |pointer: &str, value: Value| {
        let mut scene = example();
        *scene.pointer_mut(pointer).unwrap() = value;
        scene
    };
    for (pointer, value) in [
        ("/geometry", json!("PlaneStrian")),
        ("/punch", json!({"Sphere": {"radius": 1}})),
        ("/stack/0", json!({"Homogeneous": {"thickness": 1, "young": 26, "nu": 0.25}})),
        ("/stack/0/Homogeneous/poisson", json!(0.75)),
        ("/stack/0/Homogeneous/thickness", json!(-1)),
        ("/stack/0/Homogeneous/young", json!([1])),
        ("/stack/3", json!("Glued")),
        ("/stack", json!({"Rigid": null})),
        ("/units", json!({"length": "mm"})),
    ] {
        let scene = replaced(pointer, value);
        assert!(contradiction(&schema, &scene, "scene").is_some(), "{pointer}");
        assert!(Scene::from_json(&scene.to_string()).is_err(), "{pointer}");
    }
}

#[test]
fn mistakes_are_shown_where_they_stand_in_json() {
    let text = format!("{:#}\n", example());
    for (old, new, said) in [
        ("\"PlaneStrain\"", "\"PlaneStrian\"", "`geometry` of the scene is `PlaneStrian`"),
        ("\"1000 um\"", "\"1000 GPa\"", "`\"1000 GPa\"` is a stress; allowed is a length"),
        ("0.25", "0.75", "`poisson` of layer 1 (Homogeneous): found 0.75"),
        ("\"young\"", "\"youg\"", "layer 1 (Homogeneous) has no field `youg`"),
        ("\"normal\"", "\"nor mal\"", "`nor mal` is no name of a field"),
        ("\"Receding\"", "\"Recieding\"", "no layer or interface is called `Recieding`"),
        ("\"Rigid\"", "\"Rigid\",", "expected value"),
        ("300.0", "300.0.0", "expected"),
    ] {
        let wrong = text.replacen(old, new, 1);
        let error = Scene::from_json(&wrong).unwrap_err();
        assert!(error.message().contains(said), "{error}");
        let line = wrong.lines().nth(error.line().unwrap() - 1).unwrap();
        let from: String = line.chars().skip(error.column().unwrap() - 1).collect();
        let at_mistake =
            from.starts_with(new.trim_matches('"')) || from.starts_with(new) || from.starts_with(['.', ']']);
        assert!(at_mistake, "{error}\n{}", error.excerpt().unwrap());
    }
}

#[test]
fn broken_texts_are_refused_and_never_end_in_panic() {
    let text = format!("{:#}\n", example());
    for end in (0..text.len()).step_by(7) {
        let _ = Scene::from_json(&text[..end]).unwrap_err();
    }
    for (i, c) in text.char_indices().step_by(3) {
        for other in ["\"", "{", "]", "\\", "null", ""] {
            let mut wrong = text.clone();
            wrong.replace_range(i..i + c.len_utf8(), other);
            let _ = Scene::from_json(&wrong);
        }
    }
    let deep = format!("{{\"stack\": {}", "[".repeat(100_000));
    assert!(Scene::from_json(&deep).is_err());
}

#[test]
fn quantities_of_a_scene_in_json_vary() {
    // what is null is not there
    let mut loaded = example();
    (loaded["punch"], loaded["load"]) = (Value::Null, json!({"Uniform": {"half_width": 1}}));
    assert_eq!(Scene::from_json(&loaded.to_string()).unwrap().paths()[..2], ["force", "load.half_width"]);
    let folder = std::env::temp_dir().join(format!("recede-json-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("scene.json");
    fs::write(&file, format!("{:#}", example())).unwrap();
    let name = file.to_str().unwrap();
    let Run { status, stdout, stderr } =
        recede(&["sweep", name, "--vary", "layer[1].thickness=[0.5, 1]", "--vary", "force=[0.013]"], b"");
    assert_eq!((status, &stderr[..]), (Some(0), ""));
    let solved = recede::solve(&Scene::read(&file).unwrap()).unwrap();
    let half_length = solved.contacts()[0].half_length().unwrap();
    assert!(stdout.lines().nth(2).unwrap().starts_with(&format!("1.0,0.013,{half_length:?},")), "{stdout}");
    let refused = recede(&["sweep", name, "--vary", "layer[1].thickness=[0.5, -1]"], b"");
    assert_eq!(refused.status, Some(2));
    assert!(refused.stderr.contains("found -1.0, allowed is a finite number >= 0"), "{}", refused.stderr);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn scenes_are_converted_there_and_back() {
    let folder = std::env::temp_dir().join(format!("recede-convert-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let [there, back] = ["there.json", "back.ron"].map(|name| folder.join(name).to_str().unwrap().to_owned());
    for file in shipped() {
        let name = file.to_str().unwrap();
        for (from, to) in [(name, &there), (&there[..], &back)] {
            let Run { status, stderr, .. } = recede(&["convert", from, "--out", to], b"");
            assert_eq!((status, &stderr[..]), (Some(0), ""), "{name}");
        }
        // the title may have come from the file's name, which is not the scene's own
        assert_eq!(Scene::read(&back).unwrap().to_ron(), Scene::read(name).unwrap().to_ron());
        assert_eq!(fs::read_to_string(&back).unwrap(), Scene::read(name).unwrap().to_ron());
    }
    let shown = recede(&["convert", &back], b"");
    assert_eq!(shown.stdout, fs::read_to_string(&there).unwrap());
    let other = recede(&["convert", &back, "--out", "scene.txt"], b"");
    assert!(other.status == Some(2) && other.stderr.contains("--to json or --to ron"), "{}", other.stderr);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn the_schema_is_printed() {
    let printed: Value = serde_json::from_str(&recede(&["list", "--schema"], b"").stdout).unwrap();
    assert_eq!(printed, scene_schema(&Registry::default()));
}
