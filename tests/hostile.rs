//! Any file is read, refused or solved: in bounded time and memory, and never with a panic.
//!
//! Goal: a scene that somebody else wrote cannot stop the program that reads it, whatever is in it.
//!
//! ```text
//!   random bytes ┐
//!   scene, some  ├──> Scene::from_reader ──> stack ──> solve     an answer or an error, in a few seconds
//!   bytes of it  │
//!   changed      ┘    up to 1 MiB: ((((((...   /*/*/*...   "aaaa...   a million layers   1e308  5e-324  inf  NaN
//! ```
use std::time::{Duration, Instant};

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use recede::selftest::{CheckedScene, Outcome, Ranges, scenes};
use recede::{Error, MAX_BYTES, MAX_ITEMS, MAX_LAYERS, MAX_RECEDING, Options, Registry, Scene};

/// Nothing that is only read takes longer, even on a busy machine.
const SOON: Duration = Duration::from_secs(5);
const STRIP: &str = "Homogeneous(thickness:1,shear_modulus:1,poisson:0)";

fn config(cases: u32) -> ProptestConfig {
    let rng_seed = RngSeed::Fixed(20_211);
    ProptestConfig { cases, failure_persistence: None, max_shrink_iters: 64, rng_seed, ..ProptestConfig::default() }
}

/// A text with everything that a scene may contain.
const WHOLE: &str = "// a drawing
Scene(
    name: \"a \\\"name\\\" µ\",
    description: \"two\\nlines\",
    units: (length: \"mm\", force: \"N\"),
    geometry: PlaneStrain, /* or Stress */
    punch: Cylinder(radius: 500.0),
    force: 2e-3,
    stack: [
        Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25),
        Bonded,
        Exponential(thickness: 0.5, shear_modulus: 3, poisson: -0.3, beta: -1.0),
        Receding,
        HalfPlane(shear_modulus: 4.0, poisson: 0.5),
    ],
)
";

/// Pieces that a parser may stumble over.
const PIECES: [&str; 24] = [
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "\"",
    "\\",
    "/*",
    "*/",
    "//",
    ",",
    ":",
    "#",
    "r#\"",
    "Some(",
    "b'",
    "\\u{",
    "-",
    "NaN",
    "1e999",
    "'",
    "\u{feff}",
    "#![enable(unwrap_newtypes)]",
];

/// Reads it and builds the stack, and formats the error.
fn read(bytes: &[u8]) -> Result<Scene, Error> {
    let start = Instant::now();
    let scene = Scene::from_reader("hostile", bytes, &Registry::default());
    let read = scene.map_err(Error::from).and_then(|scene| scene.stack().map(|_| scene));
    if let Err(error) = &read {
        assert!(error.is_input(), "{error}");
        assert!(!error.to_string().is_empty());
        let _ = (error.hint(), format!("{error:?}").len());
        if let Error::Scene(error) = error {
            // nobody wants to see a million characters
            assert!(error.excerpt().map_or(0, |excerpt| excerpt.len()) < 4000);
            assert!(error.to_string().len() < 4000, "{} characters", error.to_string().len());
        }
    }
    assert!(start.elapsed() < SOON, "{:?} for {} bytes", start.elapsed(), bytes.len());
    read
}

/// A scene around this stack.
fn around(stack: &str) -> String {
    format!("(geometry:PlaneStrain,punch:Parabola(radius:500),force:0.002,stack:[{stack}])")
}

proptest! {
    #![proptest_config(config(512))]

    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let _ = read(&bytes);
    }

    #[test]
    fn any_pieces(pieces in prop::collection::vec(prop::sample::select(&PIECES[..]), 0..60)) {
        let text = pieces.concat();
        let _ = read(text.as_bytes());
        let _ = read(around(&text).as_bytes());
    }

    #[test]
    fn a_scene_with_changes(
        changes in prop::collection::vec((any::<prop::sample::Index>(), 0..8usize, prop::sample::select(&PIECES[..])), 1..4),
    ) {
        let mut bytes = WHOLE.as_bytes().to_vec();
        for (at, length, piece) in changes {
            let at = at.index(bytes.len());
            let end = (at + length).min(bytes.len());
            bytes.splice(at..end, piece.bytes());
        }
        let _ = read(&bytes);
    }
}

proptest! {
    #![proptest_config(config(24))]

    #[test]
    fn numbers_beyond_all_measure(
        scenario in scenes(&Ranges::moderate()),
        changes in prop::collection::vec((0..5usize, prop::sample::select(&EXTREME[..])), 1..=2),
    ) {
        let mut text = scenario.scene().unwrap().to_ron();
        for (which, number) in changes {
            let field = ["thickness: ", "shear_modulus: ", "beta: ", "radius: ", "force: "][which];
            if let Some(at) = text.find(field) {
                let at = at + field.len();
                let end = at + text[at..].find([',', ')']).unwrap();
                text.replace_range(at..end, number);
            }
        }
        if let Ok(scene) = read(text.as_bytes()) {
            let check = CheckedScene::run(&scene, &Options::default(), false);
            let wrong = match &check.outcome {
                Outcome::Wrong(what) | Outcome::Panicked(what) => Some(what),
                Outcome::Solved(_) | Outcome::Unsolved(_) => None,
            };
            prop_assert!(wrong.is_none(), "{}:\n{text}", wrong.unwrap());
        }
    }
}

const EXTREME: [&str; 12] = [
    "1e308",
    "1.7976931348623157e308",
    "5e-324",
    "2.2250738585072014e-308",
    "1e-300",
    "1e200",
    "1e-30",
    "1e30",
    "0",
    "inf",
    "NaN",
    "-1e308",
];

#[test]
fn deep_nesting() {
    for piece in ["(", "[", "{", "/*", "Some(", "a(", "(a:", "[[(", "{1:"] {
        let text = piece.repeat(MAX_BYTES / piece.len() - 40);
        assert!(read(text.as_bytes()).is_err(), "{piece}");
        let inside = around(&text[..text.len() - text.len() % piece.len() - 40 * piece.len()]);
        assert!(read(&inside.as_bytes()[..inside.len().min(MAX_BYTES)]).is_err(), "{piece}");
        let in_a_field = around(&format!("Homogeneous(thickness: {}", &text[..text.len() - 200]));
        assert!(read(&in_a_field.as_bytes()[..in_a_field.len().min(MAX_BYTES)]).is_err(), "{piece}");
    }
}

#[test]
fn deep_nesting_in_json() {
    // whole, so that it is JSON
    for (open, close) in [("[", "]"), ("{\"a\":", "}"), ("{\"A\":", "}"), ("{\"A\":[", "]}"), ("{\"$schema\":", "}")] {
        for depth in [100, 200, 50_000, (MAX_BYTES - 400) / (open.len() + close.len())] {
            let nested = open.repeat(depth) + "1" + &close.repeat(depth);
            let whole = around_in_json(&format!("{{\"HalfPlane\":{{\"shear_modulus\":1,\"poisson\":{nested}}}}}"));
            for text in [format!("{{\"name\":{nested}}}"), format!("{{\"stack\":{nested}}}"), whole] {
                let error = read(&text.as_bytes()[..text.len().min(MAX_BYTES)]).unwrap_err();
                assert!(depth < 1000 || error.to_string().ends_with("brackets are nested too deeply"), "{error}");
            }
        }
    }
    // and not too deep: rows of a table in a list in fields in a scene
    let table = "{\"HalfPlane\":{\"shear_modulus\":1,\"poisson\":0.25}}";
    assert!(read(around_in_json(table).as_bytes()).is_ok());
}

/// A scene in JSON with this stack.
fn around_in_json(stack: &str) -> String {
    let punch = "{\"Table\":[[0,0],[0.5,0.01],[1,0.05]]}";
    format!("{{\"geometry\":\"PlaneStrain\",\"punch\":{punch},\"force\":0.002,\"stack\":[{stack}]}}")
}

#[test]
fn many_objects_in_json() {
    for object in ["{\"a\":1}", "{\"A\":{}}", "{\"$schema\":1}", "{}"] {
        let many = vec![object; MAX_BYTES / 4 / (object.len() + 1)].join(",");
        assert!(read(around_in_json(&many).as_bytes()).is_err(), "{object}");
    }
}

#[test]
fn long_texts_and_comments() {
    let long = "a".repeat(MAX_BYTES - 400);
    let stack = format!("{STRIP},Receding,Rigid");
    for scene in [
        around(&stack).replace("(geometry", &format!("(name:\"{long}\",geometry")),
        around(&stack).replace("(geometry", &format!("(/*{long}*/geometry")),
        around(&stack).replace("(geometry", &format!("//{long}\n(geometry")),
        around(&stack).replace("(geometry", &format!("{}(geometry", "\n".repeat(long.len()))),
    ] {
        assert_eq!(read(scene.as_bytes()).unwrap().stack.len(), 3);
    }
    for scene in [
        around(&stack).replace("Strain", &long),
        around(&stack).replace("Rigid", &long),
        around(&stack).replace("thickness", &long),
        around(&stack).replace("500", &"9".repeat(long.len())),
        around(&stack).replace("0.002", &format!("0.{}-", "9".repeat(long.len()))),
        around(&stack).replace("Parabola", &long),
        format!("{long}(geometry"),
        format!("{}é", long),
        long.clone(),
        "\u{1f980}".repeat(MAX_BYTES / 4),
    ] {
        assert!(read(scene.as_bytes()).is_err());
    }
}

#[test]
fn a_file_that_never_ends() {
    let error = Scene::from_reader("endless", std::io::repeat(b' '), &Registry::default()).unwrap_err();
    assert!(error.to_string().contains("larger than 1048576 bytes"), "{error}");
}

#[test]
fn stacks_without_measure() {
    let layers = |count: usize, interface: &str| around(&format!("{STRIP},{interface},").repeat(count)[..]) + "";
    let closed = |text: String| text.replace(",])", ",Rigid])");
    // as many as fit into a file
    let most = MAX_BYTES / (STRIP.len() + "Receding".len() + 2) - 4;
    for (count, interface, allowed) in [
        (most, "Bonded", format!("{MAX_LAYERS}")),
        (MAX_LAYERS + 1, "Bonded", format!("{MAX_LAYERS}")),
        (MAX_RECEDING + 1, "Receding", format!("{MAX_RECEDING}")),
    ] {
        let error = read(closed(layers(count, interface)).as_bytes()).unwrap_err().to_string();
        assert!(error.contains(&format!("the stack has {count} ")), "{error}");
        assert!(error.ends_with(&format!("allowed are at most {allowed}")), "{error}");
    }
    assert!(read(closed(layers(MAX_LAYERS, "Bonded")).as_bytes()).is_ok());
    assert!(read(closed(layers(MAX_RECEDING, "Receding")).as_bytes()).is_ok());
    // layers that are not there do not count, but items do
    let nothing = STRIP.replace("thickness:1", "thickness:0");
    let thin = around(&format!("{STRIP},Bonded,{}Rigid", format!("{nothing},Bonded,").repeat(most - 2)));
    assert_eq!(read(thin.as_bytes()).unwrap().stack().unwrap().dropped().len(), most - 2);
    let error = read(around(&"Bonded,".repeat(MAX_ITEMS + 1)).as_bytes()).unwrap_err();
    assert!(error.to_string().contains(&format!("allowed are at most {MAX_ITEMS}")), "{error}");
}

/// Scenes of all kinds end with an answer that is not known to be wrong, or with a reason.
#[test]
fn punches_loads_and_interfaces_of_all_kinds_do_not_end_in_panic() {
    use recede::selftest::{CheckedScene, Outcome, scene_of_any_kind};
    const SCENES: u64 = 60;
    let mut solved = 0;
    for number in 0..SCENES {
        let scene = scene_of_any_kind(&Ranges::moderate(), 5, number).unwrap();
        let read = Scene::from_ron(&scene.to_ron()).unwrap();
        assert_eq!(read.to_ron(), scene.to_ron());
        let check = CheckedScene::run(&read, &recede::Options { tolerance: 1e-8 }, false);
        assert!(!check.outcome.is_wrong(), "{number}: {}\n{}", check.outcome.reason(), scene.to_ron());
        solved += u64::from(matches!(check.outcome, Outcome::Solved(_)));
    }
    assert!(solved > SCENES * 8 / 10, "{solved} of {SCENES}");
}
