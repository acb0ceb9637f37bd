//! Remedies for errors of reading spectra, in words.

use spectrum::{ReadMend, ReadOption, Wanted};

/// The remedy for an error of reading a spectrum, in words that follow the error. `name_of` returns the name of an option in
/// the front end.
#[must_use]
pub fn mend(mend: &ReadMend, name_of: impl Fn(ReadOption) -> String) -> String {
    match mend {
        ReadMend::Give(wanted) => {
            let verb = match wanted.iter().all(|wanted| wanted.values.is_empty()) {
                true => "choose",
                false => "set it",
            };
            let named = wanted.iter().map(|wanted| format!("{}{}", name_of(wanted.option), values(wanted)));
            format!("; {verb} with {}", named.collect::<Vec<_>>().join(" and "))
        }
        ReadMend::Correct(option) => format!("; correct {}", name_of(*option)),
        ReadMend::LeaveOut(option) => format!(", or leave out {}", name_of(*option)),
    }
}

/// ` (ciso or persson)`; empty if the file has the names.
fn values(wanted: &Wanted) -> String {
    match wanted.values.split_last() {
        None => String::new(),
        Some((last, [])) => format!(" ({last})"),
        Some((last, others)) => format!(" ({} or {last})", others.join(", ")),
    }
}
