//! The command line: `pforms eval`, `pforms operators`, … One file for each command.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run()
}
