//! Ctrl-C and termination: the work is asked to end, and no temporary file stays behind.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::failure::INTERRUPTED;

/// Time that the work has to end by itself. Work that cannot be asked, such as a wait for standard input, is ended
/// then.
const PATIENCE: Duration = Duration::from_secs(1);

/// A signal reaches no value of the program, hence a static.
static ASKED_FOR: AtomicBool = AtomicBool::new(false);

/// True while work is done that can be ended early with a result.
static CAN_END_EARLY: AtomicBool = AtomicBool::new(false);

/// True once the work has been asked to end early.
static END_EARLY: AtomicBool = AtomicBool::new(false);

/// Returns true if the program has been asked to end.
pub fn is_asked_for() -> bool {
    ASKED_FOR.load(Ordering::Relaxed)
}

/// Installs the signal handler: the first signal asks the work to end, the second ends it at once. While there is an
/// [`EarlyEnd`], the first signal ends only the work that it was made for.
pub fn listen() {
    // If a signal is already handled otherwise, as hang-ups are under nohup, it stays so: the program ends or goes on
    // as it would without this.
    let _ = ctrlc::try_set_handler(|| {
        let is_second = END_EARLY.load(Ordering::Relaxed);
        if CAN_END_EARLY.load(Ordering::Relaxed) && !is_second {
            END_EARLY.store(true, Ordering::Relaxed);
            return;
        }
        if is_second || ASKED_FOR.swap(true, Ordering::Relaxed) {
            end();
        }
        std::thread::spawn(|| {
            std::thread::sleep(PATIENCE);
            end();
        });
    });
}

/// Permission to end early. While it lives, the first signal ends the work at hand early, and the steps after it are
/// done; the second signal ends the program, then or later, with no result.
#[derive(Debug)]
pub struct EarlyEnd(());

impl EarlyEnd {
    /// Allows an early end from here on.
    pub fn allow() -> Self {
        CAN_END_EARLY.store(true, Ordering::Relaxed);
        EarlyEnd(())
    }

    /// Returns true if the work at hand has been asked to end early.
    pub fn is_asked_for(&self) -> bool {
        END_EARLY.load(Ordering::Relaxed)
    }
}

impl Drop for EarlyEnd {
    fn drop(&mut self) {
        CAN_END_EARLY.store(false, Ordering::Relaxed);
    }
}

fn end() -> ! {
    // The guard lives to the end, so that nothing is published after the question.
    let _removed = tables::staging::remove_temporaries();
    std::process::exit(if tables::staging::has_published() { 0 } else { i32::from(INTERRUPTED) });
}
