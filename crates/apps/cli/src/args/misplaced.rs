//! Options that do not stand where clap looks for them: before their command, or at one that has no use for them.

use std::ffi::{OsStr, OsString};

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, CommandFactory};

use super::Args;

/// The command line with the options that stand before the command moved behind it. A line that begins in another way,
/// as with `--help`, is left as it is.
pub(crate) fn behind_the_command(line: Vec<OsString>) -> Vec<OsString> {
    let program = Args::command();
    match Sorted::of(&line, &program) {
        Some(sorted) => sorted.into_line(),
        None => line,
    }
}

/// Returns advice on an option that the command does not have and others do.
pub(crate) fn foreign_option(error: &clap::Error, line: &[OsString]) -> Option<String> {
    let (ErrorKind::UnknownArgument, Some(ContextValue::String(option))) =
        (error.kind(), error.get(ContextKind::InvalidArg))
    else {
        return None;
    };
    let program = Args::command();
    let name = option.strip_prefix("--")?;
    let mut owners = Vec::new();
    for command in program.get_subcommands() {
        let has = with_subcommands(command).any(|command| long_option(command, name).is_some());
        owners.extend(has.then(|| format!("`{}`", command.get_name())));
    }
    let (last, others) = owners.split_last()?;
    let owners = match others {
        [] => last.clone(),
        others => format!("{} and {last}", others.join(", ")),
    };
    let words = Sorted::of(line, &program)?.words;
    let command: Vec<_> = words.iter().skip(1).map(|word| word.to_string_lossy()).collect();
    Some(format!(
        "{option} has no bearing on `{}`: it is an option of {owners}; leave it out",
        command.join(" ")
    ))
}

/// A command line in its three parts.
struct Sorted {
    /// The program and the words that name its command.
    words: Vec<OsString>,
    /// The options that stand among these words.
    options: Vec<OsString>,
    /// All that follows the command.
    rest: Vec<OsString>,
}

impl Sorted {
    /// Sorts a command line; none where something stands before the command that is not an option of some command.
    fn of(line: &[OsString], program: &Command) -> Option<Self> {
        let mut left = line.iter().cloned();
        let mut sorted = Sorted { words: vec![left.next()?], options: Vec::new(), rest: Vec::new() };
        let mut command = program;
        while command.has_subcommands() {
            let word = left.next()?;
            if let Some(found) = command.find_subcommand(&word) {
                command = found;
                sorted.words.push(word);
            } else {
                let takes_next_word = takes_next_word(program, &word)?;
                sorted.options.push(word);
                if takes_next_word {
                    sorted.options.push(left.next()?);
                }
            }
        }
        sorted.rest = left.collect();
        Some(sorted)
    }

    fn into_line(self) -> Vec<OsString> {
        [self.words, self.options, self.rest].concat()
    }
}

/// Returns true if the value of an option is the word after it; none where no command has the option.
fn takes_next_word(program: &Command, word: &OsStr) -> Option<bool> {
    let option = word.to_str()?.strip_prefix("--")?;
    let (name, has_value) = match option.split_once('=') {
        Some((name, _)) => (name, true),
        None => (option, false),
    };
    let arg = with_subcommands(program).find_map(|command| long_option(command, name))?;
    Some(!has_value && arg.get_action().takes_values())
}

fn long_option<'c>(command: &'c Command, name: &str) -> Option<&'c clap::Arg> {
    command.get_arguments().find(|arg| arg.get_long() == Some(name))
}

/// A command, and all below it.
fn with_subcommands(command: &Command) -> Box<dyn Iterator<Item = &Command> + '_> {
    Box::new(std::iter::once(command).chain(command.get_subcommands().flat_map(with_subcommands)))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    #[test]
    fn an_option_takes_a_value_in_every_command_or_in_none() {
        let program = Args::command();
        let mut takes_value = BTreeMap::new();
        for arg in with_subcommands(&program).flat_map(Command::get_arguments) {
            let Some(name) = arg.get_long() else { continue };
            let takes = arg.get_action().takes_values();
            assert_eq!(*takes_value.entry(name.to_owned()).or_insert(takes), takes, "--{name}");
        }
        assert!(takes_value.len() > 30, "{takes_value:?}");
    }

    #[test]
    fn options_go_behind_the_command_in_their_order() {
        let moved = |line: &str| {
            let line = line.split(' ').map(OsString::from).collect();
            behind_the_command(line)
                .into_iter()
                .map(|word| word.into_string().unwrap())
                .collect::<Vec<_>>()
                .join(" ")
        };
        assert_eq!(
            moved("t --cutoff 1nm --timings moments a --x q"),
            "t moments --cutoff 1nm --timings a --x q"
        );
        assert_eq!(
            moved("t --cutoff=1nm asperity --timings sphere"),
            "t asperity sphere --cutoff=1nm --timings"
        );
        for unmoved in
            ["t --help moments", "t --cutof 1nm moments", "t", "t --cutoff", "t moments --cutoff 1nm"]
        {
            assert_eq!(moved(unmoved), unmoved);
        }
    }
}
