//! Options that do not stand where clap looks for them: before their command, or at one that has no use for them.

use std::ffi::{OsStr, OsString};

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, CommandFactory};

use super::Args;

/// The command line with the options that stand before the command moved behind it. A line that begins in another way,
/// as with `--help`, is left as it is.
pub(crate) fn behind_the_command(line: Vec<OsString>) -> Vec<OsString> {
    let program = Args::command();
    let mut command = &program;
    let mut moved = line.clone();
    let (mut words, mut at) = (1, 1);
    while command.has_subcommands() {
        let Some(word) = line.get(at) else { return line };
        if let Some(found) = command.find_subcommand(word) {
            moved[words..=at].rotate_right(1);
            command = found;
            words += 1;
        } else {
            match takes_next_word(&program, word) {
                Some(takes) => at += usize::from(takes),
                None => return line,
            }
        }
        at += 1;
    }
    moved
}

/// Returns advice on an option that the command, which the line begins with, does not have and others do.
pub(crate) fn foreign_option(error: &clap::Error, line: &[OsString]) -> Option<String> {
    let (ErrorKind::UnknownArgument, Some(ContextValue::String(option))) =
        (error.kind(), error.get(ContextKind::InvalidArg))
    else {
        return None;
    };
    let program = Args::command();
    let name = option.strip_prefix("--")?;
    let has =
        |command: &&Command| with_subcommands(command).any(|command| long_option(command, name).is_some());
    let owners: Vec<_> =
        program.get_subcommands().filter(has).map(|command| format!("`{}`", command.get_name())).collect();
    let owners = match owners.split_last()? {
        (last, []) => last.clone(),
        (last, others) => format!("{} and {last}", others.join(", ")),
    };
    let mut command = &program;
    let words = line.iter().skip(1).map_while(|word| {
        command = command.find_subcommand(word)?;
        Some(command.get_name())
    });
    let words = words.collect::<Vec<_>>().join(" ");
    let is_whole = !command.has_subcommands();
    is_whole
        .then(|| format!("{option} has no bearing on `{words}`: it is an option of {owners}; leave it out"))
}

/// Returns true if the value of an option is the word after it; none where no command has the option.
fn takes_next_word(program: &Command, word: &OsStr) -> Option<bool> {
    let option = word.to_str()?.strip_prefix("--")?;
    let name = option.split('=').next()?;
    let arg = with_subcommands(program).find_map(|command| long_option(command, name))?;
    Some(name == option && arg.get_action().takes_values())
}

fn long_option<'c>(command: &'c Command, name: &str) -> Option<&'c clap::Arg> {
    let is_called = |arg: &&clap::Arg| {
        arg.get_long() == Some(name) || arg.get_all_aliases().is_some_and(|names| names.contains(&name))
    };
    command.get_arguments().find(is_called)
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
