//! Which series of a file is meant.

use thiserror::Error;

use crate::read::mend::{ReadMend, ReadOption};
use crate::read::options::ReadOptions;
use crate::read::series::{Series, SeriesName};

/// The series that stands for a subject where none is asked for.
const USUAL: &str = "1D PSD along x";

/// The subject type of contact.engineering's average over a dataset.
const DATASET: &str = "surface";

/// A choice of series that a file does not offer, or a choice that has to be made.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SeriesError {
    /// No series of the name asked for.
    #[error("choosing a series: there is no series '{asked}'; {}", offer(.found))]
    UnknownSeries {
        /// The name asked for.
        asked: String,
        /// The series there are.
        found: Vec<SeriesName>,
    },
    /// No subject of the name asked for.
    #[error("choosing a series: there is no subject '{asked}'; {}", offer(.found))]
    UnknownSubject {
        /// The name asked for.
        asked: String,
        /// The series there are.
        found: Vec<SeriesName>,
    },
    /// Several series of which none has precedence.
    #[error(
        "choosing a series: {} series come into question; {}",
        .found.len(), offer(.found)
    )]
    SeveralSeries {
        /// The series that come into question.
        found: Vec<SeriesName>,
    },
    /// A name that several series bear.
    #[error(
        "choosing a series: {count} series of the file {}; keep the rows of one, or name them apart",
        if *.name == SeriesName::default() { "have no name".to_owned() } else { format!("are called '{name}'") }
    )]
    RepeatedSeries {
        /// The name.
        name: SeriesName,
        /// How often it stands in the file.
        count: usize,
    },
}

/// The series asked for, with a note about those it stood beside.
///
/// Without a choice: the only series; the usual series of the average over a dataset; the usual series of the only
/// subject.
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
            "of the {count} series in the file '{name}'{average} is read; another is chosen by its series or its subject"
        );
        chosen.notes.insert(0, note);
    }
    Ok(chosen)
}

fn position(names: &[&SeriesName], options: &ReadOptions) -> Result<usize, SeriesError> {
    let mut left: Vec<usize> = (0..names.len()).collect();
    if let Some(asked) = &options.subject {
        let found = in_question(names, &left);
        left.retain(|&at| names[at].subject.as_ref().is_some_and(|subject| is_same(subject, asked)));
        if left.is_empty() {
            return Err(SeriesError::UnknownSubject { asked: asked.clone(), found });
        }
    }
    if let Some(asked) = &options.series {
        let found = in_question(names, &left);
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
            // Not only the usual ones: any of the file may be chosen.
            let all: Vec<usize> = (0..names.len()).collect();
            Err(SeriesError::SeveralSeries { found: in_question(names, &all) })
        }
        _ => Err(SeriesError::SeveralSeries { found: in_question(names, &left) }),
    }
}

/// Keeps those of which something is true, if it is true of any.
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

fn in_question(names: &[&SeriesName], at: &[usize]) -> Vec<SeriesName> {
    at.iter().map(|&at| names[at].clone()).collect()
}

/// Whether two names agree but for case, blanks and the signs that keyboards lack.
fn is_same(one: &str, other: &str) -> bool {
    let plain = |name: &str| {
        let name = name.to_lowercase().replace('π', "pi").replace('×', "x");
        name.split_whitespace().map(str::to_owned).collect::<Vec<_>>()
    };
    plain(one) == plain(other)
}

/// The subjects and the series, each once.
fn offer(names: &[SeriesName]) -> String {
    let once = |of: fn(&SeriesName) -> Option<String>| {
        let mut texts: Vec<String> = Vec::new();
        for text in names.iter().filter_map(of).filter(|text| !text.is_empty()) {
            if !texts.contains(&text) {
                texts.push(text);
            }
        }
        texts.join(", ")
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
    /// What the caller can do about it with an option, where that is all there is to it.
    pub(crate) fn mend(&self) -> Option<ReadMend> {
        match self {
            Self::SeveralSeries { found } => {
                let options = telling_apart(found);
                Some(ReadMend::Give(options.iter().map(|option| option.name_in_file()).collect()))
            }
            Self::UnknownSeries { .. } | Self::UnknownSubject { .. } | Self::RepeatedSeries { .. } => None,
        }
    }
}

/// The options that tell these series apart.
fn telling_apart(names: &[SeriesName]) -> &'static [ReadOption] {
    let differ = |of: fn(&SeriesName) -> &Option<String>| names.iter().any(|name| of(name) != of(&names[0]));
    match (differ(|name| &name.subject), differ(|name| &name.series)) {
        (true, true) => &[ReadOption::Subject, ReadOption::Series],
        (true, false) => &[ReadOption::Subject],
        (false, _) => &[ReadOption::Series],
    }
}
