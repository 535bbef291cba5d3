//! What the command line understands, and how it answers.
//!
//! Answers go to standard output, complaints to standard error. The exit code is 0, or 1 when
//! something asked for could not be had, or 2 for a command that was not understood.

mod convert;
mod draw;
mod eval;
mod files;
mod input;
mod operators;
mod output;
mod poles;
mod print;

use std::process::ExitCode;

use clap::{Parser, Subcommand, ValueEnum};
use pforms_catalogue::Language;

/// Pascalian forms: sheets, pictures and files of exact Bézier forms.
#[derive(Parser)]
#[command(name = "pforms", version, arg_required_else_help = true)]
struct Line {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Eval(eval::Eval),
    Draw(Box<draw::Draw>),
    Convert(convert::Convert),
    Operators(operators::Operators),
}

/// The language of answers.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum Lang {
    #[default]
    En,
    Fr,
}

impl From<Lang> for Language {
    fn from(lang: Lang) -> Self {
        match lang {
            Lang::En => Self::English,
            Lang::Fr => Self::French,
        }
    }
}

/// How a command ended: whether all that was asked for could be had, or why it stopped.
type Outcome = Result<bool, Box<dyn std::error::Error>>;

/// Reads the command line and does what it says.
pub(crate) fn run() -> ExitCode {
    let outcome = match Line::parse().command {
        Command::Eval(command) => command.run(),
        Command::Draw(command) => command.run(),
        Command::Convert(command) => command.run(),
        Command::Operators(command) => command.run(),
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) => {
            eprintln!("pforms: {error}");
            ExitCode::from(1)
        }
    }
}
