//! `man`: the help as manual pages, one for the program and one for each of its commands.

use std::io;

use clap::CommandFactory;
use clap_mangen::Man;
use clap_mangen::roff::{Roff, roman};

use super::Context;
use crate::args::{Args, ManArgs};
use crate::failure::Failure;
use crate::output::{make_folder, publish, stage};
use tables::staging::StagedFiles;

pub(super) fn run(args: &ManArgs, context: &Context<'_>) -> Result<(), Failure> {
    make_folder("--out", &args.out)?;
    let mut program = Args::command().disable_help_subcommand(true);
    program.build();
    let mut files = StagedFiles::default();
    let mut names = Vec::new();
    for command in with_subcommands(&program) {
        let page = Page::of(command);
        stage(&mut files, &args.out.join(page.man.get_filename()), |out| page.write(out))?;
        names.push(page.man.get_filename());
    }
    publish(files)?;
    context.print(&format!("{} pages in {}: {}\n", names.len(), args.out.display(), names.join(", ")))
}

/// A command, and all below it.
fn with_subcommands(command: &clap::Command) -> Vec<&clap::Command> {
    std::iter::once(command).chain(command.get_subcommands().flat_map(with_subcommands)).collect()
}

/// The page of one command. Its closing help comes in two parts, since an example has to keep its lines.
struct Page<'a> {
    command: &'a clap::Command,
    man: Man,
    remarks: String,
    examples: String,
}

impl<'a> Page<'a> {
    fn of(command: &'a clap::Command) -> Self {
        let closing = command.get_after_long_help().or(command.get_after_help());
        let closing = closing.map(ToString::to_string).unwrap_or_default();
        let begin = ["Example:\n", "Examples:\n"].iter().find_map(|heading| closing.find(heading));
        let (remarks, examples) = closing.split_at(begin.unwrap_or(closing.len()));
        // An absent date would let the next field take its place; the release tells what the page is of.
        let man = Man::new(command.clone())
            .date(" ")
            .source(concat!("truearea ", env!("CARGO_PKG_VERSION")))
            .manual("truearea manual");
        Page { command, man, remarks: remarks.trim().to_owned(), examples: examples.trim().to_owned() }
    }

    fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        self.man.render_title(out)?;
        self.man.render_name_section(out)?;
        self.man.render_synopsis_section(out)?;
        self.man.render_description_section(out)?;
        self.man.render_options_section(out)?;
        if self.command.has_subcommands() {
            self.man.render_subcommands_section(out)?;
        }
        let mut closing = Roff::new();
        if !self.remarks.is_empty() {
            closing.control("SH", ["REMARKS"]);
            for paragraph in self.remarks.split("\n\n") {
                closing.control("PP", []).text([roman(paragraph)]);
            }
        }
        if let Some((_, commands)) = self.examples.split_once('\n') {
            closing.control("SH", ["EXAMPLES"]).control("nf", []);
            closing.text([roman(commands)]).control("fi", []);
        }
        closing.to_writer(out)
    }
}
