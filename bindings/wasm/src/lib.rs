//! pforms for the browser: the headless sheet behind typed messages.
//!
//! [`Engine`] is one open sheet; each of its calls answers with an [`Update`] that says what changed.
//! Nothing here computes: values come from the sheet, pictures from the scene, files from the formats.
//! `studio/src/engine/protocol.ts` declares the same messages in TypeScript.

mod assist;
mod cells;
mod cost;
mod engine;
mod files;
mod glue;
mod operators;
mod picture;
mod place;
mod poles;
mod problem;
mod style;
mod update;

pub use assist::Assistance;
pub use cells::CellInfo;
pub use engine::{Answer, Engine, Gesture};
pub use files::Exported;
pub use operators::OperatorHelp;
pub use picture::{Drawing, Piece};
pub use poles::{Pole, Poles};
pub use problem::Problem;
pub use update::{Note, ShownCell, Undrawn, Update};
