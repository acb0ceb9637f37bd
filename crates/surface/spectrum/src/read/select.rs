//! Choice of one series of a file.

use std::collections::HashSet;

use thiserror::Error;
use units::printable::listed;

use crate::read::mend::{ReadMend, ReadOption};
use crate::read::options::ReadOptions;
use crate::read::series::{Series, SeriesName};

/// Default series of a subject.
const USUAL: &str = "1D PSD along x";

/// Subject type of contact.engineering's average over a dataset.
const DATASET: &str = "surface";

/// Errors of choosing a series: an unknown choice, or a missing one.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SeriesError {
    /// No series of the requested name.
    #[error("there is no series '{asked}'; {}", offer(.found))]
    UnknownSeries {
        /// The requested name.
        asked: String,
        /// The series there are.
        found: Vec<SeriesName>,
    },
    /// No subject of the requested name.
    #[error("there is no subject '{asked}'; {}", offer(.found))]
    UnknownSubject {
        /// The requested name.
        asked: String,
        /// The series there are.
        found: Vec<SeriesName>,
    },
    /// Several series, none with precedence.
    #[error(
        "the file holds {} series to choose from; {}",
        .found.len(), offer(.found)
    )]
    SeveralSeries {
        /// The series to choose from.
        found: Vec<SeriesName>,
    },
    /// A name that several series have.
    #[error(
        "{count} series of the file {}; keep the rows of one, or rename them",
        if *.name == SeriesName::default() { "have no name".to_owned() } else { format!("are called '{name}'") }
    )]
    RepeatedSeries {
        /// The name.
        name: SeriesName,
        /// Number of series with this name.
        count: usize,
    },
}

/// Selects the requested series, with a note if the file holds others.
///
/// The default is the only series, else the default series of the average over a dataset or of the only subject.
pub(crate) fn select(mut series: Vec<Series>, options: &ReadOptions) -> Result<Series, SeriesError> {
    let count = series.len();
    let at = {
        let names: Vec<&SeriesName> = series.iter().map(|series| &series.name).collect();
        position(&names, options)?
    };
    let mut chosen = series.swap_remove(at);
    if count > 1 {
        let average = if chosen.name.is_average() { ", the average over a dataset," } else { "" };
        let name = &chosen.name;
        let note = format!(
            "the file holds {count} series; '{name}'{average} is read; choose another by its series or subject"
        );
        chosen.notes.insert(0, note);
    }
    Ok(chosen)
}

fn position(names: &[&SeriesName], options: &ReadOptions) -> Result<usize, SeriesError> {
    let mut left: Vec<usize> = (0..names.len()).collect();
    if let Some(asked) = &options.subject {
        let found = names_at(names, &left);
        left.retain(|&at| names[at].subject.as_ref().is_some_and(|subject| is_same(subject, asked)));
        if left.is_empty() {
            return Err(SeriesError::UnknownSubject { asked: asked.clone(), found });
        }
    }
    if let Some(asked) = &options.series {
        let found = names_at(names, &left);
        let is_asked = |name: &SeriesName| {
            is_same(&name.to_string(), asked)
                || name.series.as_ref().is_some_and(|series| is_same(series, asked))
        };
        left.retain(|&at| is_asked(names[at]));
        if left.is_empty() {
            return Err(SeriesError::UnknownSeries { asked: asked.clone(), found });
        }
    } else if left.len() > 1 {
        narrow(&mut left, |at| names[at].series.as_ref().is_some_and(|series| is_same(series, USUAL)));
    }
    narrow(&mut left, |at| names[at].is_average());
    match left[..] {
        [at] => Ok(at),
        _ if left.iter().all(|&at| names[at] == names[left[0]]) => {
            Err(SeriesError::RepeatedSeries { name: names[left[0]].clone(), count: left.len() })
        }
        _ if options.series.is_none() => {
            // Offer all series of the file, not only the default ones.
            let all: Vec<usize> = (0..names.len()).collect();
            Err(SeriesError::SeveralSeries { found: names_at(names, &all) })
        }
        _ => Err(SeriesError::SeveralSeries { found: names_at(names, &left) }),
    }
}

/// Keeps the matching indices if any match.
fn narrow(left: &mut Vec<usize>, is_meant: impl Fn(usize) -> bool) {
    if left.iter().any(|&at| is_meant(at)) {
        left.retain(|&at| is_meant(at));
    }
}

impl SeriesName {
    fn is_average(&self) -> bool {
        self.subject_type.as_ref().is_some_and(|subject_type| is_same(subject_type, DATASET))
    }
}

fn names_at(names: &[&SeriesName], at: &[usize]) -> Vec<SeriesName> {
    at.iter().map(|&at| names[at].clone()).collect()
}

/// Returns true if two names agree up to case, blanks and signs that keyboards lack.
fn is_same(one: &str, other: &str) -> bool {
    let plain = |name: &str| {
        let name = name.to_lowercase().replace('π', "pi").replace('×', "x");
        name.split_whitespace().map(str::to_owned).collect::<Vec<_>>()
    };
    plain(one) == plain(other)
}

/// Lists the subjects and the series, each once.
fn offer(names: &[SeriesName]) -> String {
    let once = |of: fn(&SeriesName) -> Option<String>| {
        let mut earlier = HashSet::new();
        let texts = names.iter().filter_map(of).filter(|text| !text.is_empty());
        listed(texts.filter(|text| earlier.insert(text.clone())), "")
    };
    let subjects = once(|name| {
        let subject = name.subject.as_ref()?;
        let subject_type = name.subject_type.as_ref().map(|subject_type| format!(" ({subject_type})"));
        Some(format!("'{subject}'{}", subject_type.unwrap_or_default()))
    });
    let series = once(|name| Some(format!("'{}'", name.series.as_ref()?)));
    match (subjects.is_empty(), series.is_empty()) {
        (true, true) => "the series of this file have no names".to_owned(),
        (true, false) => format!("the series are {series}"),
        (false, true) => format!("the subjects are {subjects}"),
        (false, false) => format!("the subjects are {subjects}; the series are {series}"),
    }
}

impl SeriesError {
    /// The option that fixes the error, if one does.
    pub(crate) fn mend(&self) -> Option<ReadMend> {
        match self {
            Self::SeveralSeries { found } => {
                let options = distinguishing_options(found);
                Some(ReadMend::Give(options.iter().map(|option| option.name_in_file()).collect()))
            }
            Self::UnknownSeries { .. } | Self::UnknownSubject { .. } | Self::RepeatedSeries { .. } => None,
        }
    }
}

/// Returns the options that distinguish these series.
fn distinguishing_options(names: &[SeriesName]) -> &'static [ReadOption] {
    let differ = |of: fn(&SeriesName) -> &Option<String>| names.iter().any(|name| of(name) != of(&names[0]));
    match (differ(|name| &name.subject), differ(|name| &name.series)) {
        (true, true) => &[ReadOption::Subject, ReadOption::Series],
        (true, false) => &[ReadOption::Subject],
        (false, _) => &[ReadOption::Series],
    }
}
