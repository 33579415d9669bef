//! Whatever bytes a scene file holds, they are read or refused, and what is read can be written and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use recede::{Error, Registry, Scene};

fuzz_target!(|bytes: &[u8]| {
    match Scene::from_reader("fuzz", bytes, &Registry::default()) {
        Ok(scene) => {
            let text = scene.to_ron();
            let again = Scene::from_ron(&text).expect("what is written can be read");
            assert_eq!(again.to_ron(), text);
            if let Ok(stack) = scene.stack() {
                let _ = stack.drawing(None, None);
            }
        }
        Err(error) => {
            assert!(error.is_input());
            let _ = (error.to_string(), error.hint());
            if let Error::Scene(error) = error {
                let _ = error.excerpt();
            }
        }
    }
});
