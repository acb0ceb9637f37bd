//! A scene and, after a zero byte, the file that stands behind every name in it.
#![no_main]

use std::io;

use measurements::Files;
use scene::{Overrides, Scene, SceneProblem};

struct OneFile<'b>(&'b [u8]);

impl Files for OneFile<'_> {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Ok(self.0.to_vec())
    }

    fn read_beside(&self, _: &str, _: &str) -> io::Result<Option<Vec<u8>>> {
        Ok(None)
    }
}

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let (text, file) = fuzz::text_and_data(bytes);
    let Ok(text) = std::str::from_utf8(text) else { return };
    match Scene::parse(text, &OneFile(file), &Overrides::default()) {
        Ok(scene) => {
            assert!(scene.needs.loads.iter().all(|load| load.nominal_pressure.pa() > 0.0));
            let _ = scene.choices();
        }
        Err(error) => {
            assert!(!matches!(error.problem, SceneProblem::NotAScene(_)) || text.len() > 1);
            fuzz::check_message(&error.to_string(), bytes);
        }
    }
});
