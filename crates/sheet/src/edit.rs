//! The changes a document can undergo.

use pforms_formula::Address;
use serde::{Deserialize, Serialize};

use crate::pfs::Remarks;
use crate::{Settings, Target};

/// One change. Each replaces one thing as a whole, so its opposite is an edit of the same kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "edit", rename_all = "lowercase", deny_unknown_fields)]
pub enum Edit {
    /// The text of a cell; none or an empty one empties it.
    Cell {
        /// Which cell.
        #[serde(with = "as_text")]
        at: Address,
        /// Its text.
        text: Option<String>,
    },
    /// The target of a name; none removes the name.
    Name {
        /// The name as typed.
        name: String,
        /// What it stands for.
        #[serde(with = "target_as_text")]
        target: Option<Target>,
    },
    /// How a cell is drawn; none hides it.
    Show {
        /// Which cell.
        #[serde(with = "as_text")]
        at: Address,
        /// The style.
        settings: Option<Settings>,
    },
    /// The camera.
    Camera {
        /// All of it; empty for the usual one.
        settings: Settings,
    },
    /// The notes.
    Notes {
        /// All of them.
        notes: Vec<Settings>,
    },
    /// The comments of a file written by hand.
    Remarks {
        /// All of them.
        remarks: Remarks,
    },
    /// A title; none removes it.
    Title {
        /// `title`, or `title_` and a language.
        key: String,
        /// The title.
        text: Option<String>,
    },
}

/// What an edit replaces. Edits of different slots do not touch one another.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Slot {
    Cell(Address),
    Name(String),
    Show(Address),
    Camera,
    Notes,
    Remarks,
    Title(String),
}

impl Edit {
    /// The edit that types `text` in a cell.
    pub fn cell(at: Address, text: &str) -> Self {
        Self::Cell { at, text: Some(text.to_owned()) }
    }

    /// The edit that empties a cell.
    pub fn clear(at: Address) -> Self {
        Self::Cell { at, text: None }
    }

    pub(crate) fn slot(&self) -> Slot {
        match self {
            Self::Cell { at, .. } => Slot::Cell(*at),
            Self::Name { name, .. } => Slot::Name(crate::name::folded(name)),
            Self::Show { at, .. } => Slot::Show(*at),
            Self::Camera { .. } => Slot::Camera,
            Self::Notes { .. } => Slot::Notes,
            Self::Remarks { .. } => Slot::Remarks,
            Self::Title { key, .. } => Slot::Title(key.clone()),
        }
    }
}

/// An address in a log is written as people write it.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature serde calls")]
mod as_text {
    use pforms_formula::Address;
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    pub(super) fn serialize<S: Serializer>(at: &Address, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(at)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<Address, D::Error> {
        String::deserialize(from)?.parse().map_err(D::Error::custom)
    }
}

/// So is what a name stands for.
#[allow(clippy::ref_option, reason = "the signature serde calls")]
mod target_as_text {
    use crate::Target;
    use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

    pub(super) fn serialize<S: Serializer>(
        target: &Option<Target>,
        to: S,
    ) -> Result<S::Ok, S::Error> {
        target.map(|target| target.to_string()).serialize(to)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>>(
        from: D,
    ) -> Result<Option<Target>, D::Error> {
        let text = Option::<String>::deserialize(from)?;
        text.map(|text| Target::read(&text)).transpose().map_err(D::Error::custom)
    }
}
