//! Ctrl-C and termination: the work is asked to end, and no temporary file stays behind.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::failure::INTERRUPTED;

/// How long the work has to end by itself. What cannot be asked, such as a wait for standard input, is ended then.
const PATIENCE: Duration = Duration::from_secs(1);

/// A signal reaches no value of the program, hence a static.
static ASKED_FOR: AtomicBool = AtomicBool::new(false);

/// Whether the program has been asked to end.
pub fn is_asked_for() -> bool {
    ASKED_FOR.load(Ordering::Relaxed)
}

/// Has the first signal ask the work to end, and the second one end it at once.
pub fn listen() {
    // Where a signal is handled otherwise, as hang-ups are under nohup, it stays so: the program ends or goes on as it would
    // without this.
    let _ = ctrlc::try_set_handler(|| {
        if ASKED_FOR.swap(true, Ordering::Relaxed) {
            end();
        }
        std::thread::spawn(|| {
            std::thread::sleep(PATIENCE);
            end();
        });
    });
}

fn end() -> ! {
    let _removed = staging::remove_temporaries();
    std::process::exit(i32::from(INTERRUPTED));
}
