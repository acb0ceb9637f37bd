//! Measured contacts beside predictions, from the committed tables of `cargo xtask nature`.

use ::nature::joint::JointRow;
use ::nature::page::{joints_figure, resistances_figure};
use ::nature::table::{ResistanceRow, read};
use report::chart;
use serde::de::DeserializeOwned;

use super::{PROVENANCE, Picture};
use crate::committed_file;

/// Measured over predicted conductances.
pub(super) fn resistances() -> Picture {
    let figure = resistances_figure(&committed::<ResistanceRow>("resistances"));
    let subject = "a bar crosses 1 where the measured value lies inside the predicted range";
    Picture { name: "nature-resistances", svg: chart::svg(&figure, subject, &[PROVENANCE.to_owned()]) }
}

/// Stiffness of rock joints.
pub(super) fn joints() -> Picture {
    let figure = joints_figure(&committed::<JointRow>("joints"));
    let subject = "range over seats, compliances and E = 10 to 12 GPa; nothing is fitted";
    Picture { name: "nature-joints", svg: chart::svg(&figure, subject, &[PROVENANCE.to_owned()]) }
}

fn committed<R: DeserializeOwned>(name: &str) -> Vec<R> {
    let path = committed_file(&format!("docs/develop/nature/{name}.csv"));
    let file = std::fs::File::open(path).expect("a committed table");
    read(file).expect("a table of this program")
}
