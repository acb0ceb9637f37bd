//! Workbench of a measurement: competitors, machine, and what comes out.

use crate::competitors::{Environment, MissingPackage, Worker};
use crate::machine::{self, Fact};
use crate::reference::repository;

/// Competitors, machine and versions: what parts are measured with.
#[derive(Debug)]
pub struct Bench {
    /// Python with the competitors.
    pub environment: Environment,
    /// Process of the competitors; `None` if it does not start.
    pub worker: Option<Worker>,
    /// Competitors that are missing.
    pub missing: Vec<MissingPackage>,
    /// Machine and versions.
    pub facts: Vec<Fact>,
}

impl Bench {
    /// Installs and starts the competitors, and lists machine and versions.
    pub fn prepare() -> Self {
        let environment = Environment::prepare(&repository("target/work-precision/venv"));
        let mut missing = environment.missing.clone();
        let worker = match Worker::start(&environment) {
            Ok(worker) => Some(worker),
            Err(reason) => {
                if missing.is_empty() {
                    missing.push(MissingPackage { package: "Python".to_owned(), reason });
                }
                None
            }
        };
        missing.extend(worker.iter().flat_map(|worker| worker.missing.clone()));
        let mut facts = machine::facts();
        facts.extend(worker.iter().flat_map(|worker| worker.versions.clone()));
        Bench { environment, worker, missing, facts }
    }
}

/// Measured tables and files, by name: sections of the page, and files in `docs/develop/performance/`.
#[derive(Debug, Default)]
pub struct Contents {
    /// Sections of the page.
    pub sections: Vec<(&'static str, String)>,
    /// Files beside the page.
    pub files: Vec<(&'static str, String)>,
}
