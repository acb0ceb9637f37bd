//! `completions`: what a shell needs to complete commands and options.

use clap::CommandFactory;
use clap_complete::{Shell, generate};

use super::Context;
use crate::args::Args;
use crate::failure::Failure;

pub(super) fn run(shell: Shell, context: &Context<'_>) -> Result<(), Failure> {
    // The generator panics where it cannot write, on a closed pipe for one: it writes to memory.
    let mut script = Vec::new();
    generate(shell, &mut Args::command(), "truearea", &mut script);
    context.shared.output.write(|out| out.write_all(&script))
}
