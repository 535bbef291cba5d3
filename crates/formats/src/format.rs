//! Which format a file has.

use std::fmt;

use pforms_kernel::{Error, Result};

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Forms, exactly, as JSON.
    Json,
    /// Polynomial patches as text.
    Bpt,
    /// A drawn scene as binary glTF 2.0.
    Glb,
    /// A drawn scene as Wavefront OBJ.
    Obj,
    /// The triangles of a drawn scene as binary STL.
    Stl,
    /// A drawn scene as input for POV-Ray 3.7.
    Pov,
}

/// Every format.
pub const FORMATS: [Format; 6] =
    [Format::Json, Format::Bpt, Format::Glb, Format::Obj, Format::Stl, Format::Pov];

impl Format {
    /// The ending of its file names.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Json => "json",
            Self::Bpt => "bpt",
            Self::Glb => "glb",
            Self::Obj => "obj",
            Self::Stl => "stl",
            Self::Pov => "pov",
        }
    }

    /// Does it hold forms? The other formats hold a drawing of them.
    pub fn holds_forms(self) -> bool {
        matches!(self, Self::Json | Self::Bpt)
    }

    /// The format a file name ends in, in capitals or not.
    ///
    /// Errors: `Format`, with the endings that are known.
    ///
    /// ```
    /// use pforms_formats::Format;
    /// assert_eq!(Format::of_name("Teapot.BPT")?, Format::Bpt);
    /// # Ok::<(), pforms_kernel::Error>(())
    /// ```
    pub fn of_name(name: &str) -> Result<Self> {
        let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending).to_lowercase();
        FORMATS.into_iter().find(|format| format.extension() == ending).ok_or_else(|| {
            let known: Vec<String> = FORMATS.iter().map(|format| format!(".{format}")).collect();
            Error::format(name, None, format!("its name should end in one of {}", known.join(" ")))
        })
    }

    /// The format of forms that the bytes look like; `None` when they look like neither.
    pub fn of_content(bytes: &[u8]) -> Option<Self> {
        let content = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        match content.iter().find(|byte| !byte.is_ascii_whitespace())? {
            b'{' => Some(Self::Json),
            b'0'..=b'9' => Some(Self::Bpt),
            _ => None,
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.extension())
    }
}
