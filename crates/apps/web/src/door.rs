//! The door to JavaScript: requests and replies as JSON.

use std::cell::RefCell;
use std::io;

use measurements::Files;
use numerics::parallel::Progress;
use questions::{Phase, Watch};
use report::run_stamp::RunStamp;
use serde::Serialize;
use serde::de::DeserializeOwned;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::{Desk, FileRequest, FileSight, PressRequest, Refusal, Request, judged, pressed, products};

#[wasm_bindgen(raw_module = "./bridge.js")]
extern "C" {
    /// Returns the number of bytes of a file that the page was given.
    #[wasm_bindgen(js_name = fileSize)]
    fn file_size(name: &str) -> Option<f64>;
    /// Reads the bytes of such a file from an offset on.
    #[wasm_bindgen(js_name = readPart)]
    fn read_part(name: &str, offset: f64, into: &mut [u8]);
    /// Returns the names of all files that the page was given, a line each.
    #[wasm_bindgen(js_name = fileNames)]
    fn file_names() -> String;
    /// Takes the progress of a phase.
    fn progress(phase: &str, done: usize, steps: usize);
}

/// Bytes that are read at once.
const PART: usize = 1 << 23;

/// Reads a file in parts, so that the browser holds no second copy of a large one.
fn read_file(name: &str) -> Option<Vec<u8>> {
    let mut bytes = vec![0; file_size(name)? as usize];
    for (at, part) in bytes.chunks_mut(PART).enumerate() {
        read_part(name, (at * PART) as f64, part);
    }
    Some(bytes)
}

/// The files of the page, read when their turn comes, so that no bytes stay in memory.
struct PageFiles;

impl Files for PageFiles {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        const NOT_GIVEN: &str = "the page was not given this file; drop it together with the others";
        read_file(name).ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, NOT_GIVEN))
    }

    fn read_beside(&self, name: &str, sibling: &str) -> io::Result<Option<Vec<u8>>> {
        let folder = name.rfind('/').map_or("", |end| &name[..=end]);
        Ok(read_file(&format!("{folder}{sibling}")))
    }

    fn list(&self, folder: &str) -> io::Result<Option<Vec<String>>> {
        let inside = format!("{}/", folder.trim_end_matches('/'));
        let all = file_names();
        let names = all.lines().filter_map(|path| path.strip_prefix(&inside));
        let mut names: Vec<String> = names.filter(|name| !name.contains('/')).map(str::to_owned).collect();
        names.sort();
        Ok((!names.is_empty()).then_some(names))
    }
}

/// Reports the progress of a run to the page. A run is cancelled by ending its worker.
struct PageWatch;

struct PageProgress {
    phase: &'static str,
    done: std::sync::atomic::AtomicUsize,
    steps: usize,
}

impl Watch for PageWatch {
    fn begin(&self, phase: Phase, steps: usize) -> Box<dyn Progress + '_> {
        Box::new(PageProgress::begin(phase.steps(), steps))
    }
}

impl PageProgress {
    fn begin(phase: &'static str, steps: usize) -> Self {
        progress(phase, 0, steps);
        PageProgress { phase, done: 0.into(), steps }
    }
}

impl Progress for PageProgress {
    fn advance(&self, steps: usize) {
        let before = self.done.fetch_add(steps, std::sync::atomic::Ordering::Relaxed);
        let [was, is] = [before, before + steps].map(|done| 100 * done / self.steps.max(1));
        if was != is {
            progress(self.phase, before + steps, self.steps);
        }
    }
}

thread_local! {
    static DESK: RefCell<Desk> = RefCell::default();
}

/// Looks at a file.
#[wasm_bindgen(js_name = look)]
#[must_use]
pub fn look(file: &str) -> String {
    replied::<FileRequest, _>(file, |file| Ok(FileSight::new(file, &PageFiles)))
}

/// Answers a request in closed forms.
#[wasm_bindgen(js_name = answer)]
#[must_use]
pub fn answer(request: &str) -> String {
    replied::<Request, _>(request, |request| DESK.with_borrow_mut(|desk| desk.answer(request, &PageFiles)))
}

/// Answers a request with the verdicts of boundary elements, and with `draws` with intervals.
#[wasm_bindgen(js_name = judge)]
#[must_use]
pub fn judge(request: &str, draws: bool) -> String {
    replied::<Request, _>(request, |request| {
        DESK.with_borrow_mut(|desk| judged(desk, request, &PageFiles, draws, &PageWatch))
    })
}

/// Returns a map of the scene of a request, by its index: its heights, and all that pressing it needs.
#[wasm_bindgen(js_name = map)]
#[must_use]
pub fn map(request: &str, map: usize) -> String {
    replied::<Request, _>(request, |request| DESK.with_borrow_mut(|desk| desk.map(request, &PageFiles, map)))
}

/// Presses a map.
#[wasm_bindgen(js_name = press)]
#[must_use]
pub fn press(request: &str) -> String {
    replied::<PressRequest, _>(request, |request| {
        pressed(request, |steps| PageProgress::begin("steps", steps))
    })
}

/// Makes the files of a report. The date is that of the page.
#[wasm_bindgen(js_name = report)]
#[must_use]
pub fn report(request: &str, date: &str) -> String {
    let stamp = RunStamp { date: Some(date.to_owned()), command: Some("in the browser".to_owned()) };
    replied::<Request, _>(request, |request| products(request, &PageFiles, &stamp, &PageWatch))
}

/// Reads a request, answers it, and writes the reply: `{"ok": ...}` or `{"refused": ...}`.
fn replied<Q: DeserializeOwned, A: Serialize>(
    request: &str,
    answer: impl FnOnce(&Q) -> Result<A, Refusal>,
) -> String {
    #[derive(Serialize)]
    #[serde(rename_all = "lowercase")]
    enum Outcome<A> {
        Ok(A),
        Refused(Refusal),
    }
    let found = serde_json::from_str(request).map_err(Refusal::new).and_then(|request| answer(&request));
    json(&match found {
        Ok(answer) => Outcome::Ok(answer),
        Err(refusal) => Outcome::Refused(refusal),
    })
}

/// Writes JSON; every reply has text keys only, so that it can be written.
fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}
