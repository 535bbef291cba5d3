//! The notation of the book for the shape of a form: `pP`, `pL4`, `pS34`, `pV222`, `pS[12,3]`.

use std::fmt;
use std::str::FromStr;

use crate::{Error, Result};

const LETTERS: [char; 5] = ['P', 'L', 'S', 'V', 'H'];

/// The shape of a form, written as the book writes it.
///
/// Four axes have their letters (`L`, `S`, `V`, `H`); beyond, `pF[2,2,2,2,2]`. Orders of two
/// digits are set off by commas; a curve needs none, so it stays `pL12`.
///
/// ```
/// use pforms_kernel::Kind;
/// assert_eq!(Kind::new(&[3, 4]).to_string(), "pS34");
/// assert_eq!("pS[12,3]".parse::<Kind>()?.orders(), [12, 3]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Kind(Vec<usize>);

impl Kind {
    /// The kind of a form of these orders.
    pub fn new(orders: &[usize]) -> Self {
        Self(orders.to_vec())
    }

    /// Number of poles along each axis.
    pub fn orders(&self) -> &[usize] {
        &self.0
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let orders: Vec<String> = self.0.iter().map(usize::to_string).collect();
        let letter = LETTERS.get(orders.len()).unwrap_or(&'F');
        let single = orders.len() <= 1 || self.0.iter().all(|&order| order < 10);
        if single && orders.len() < LETTERS.len() {
            write!(f, "p{letter}{}", orders.concat())
        } else {
            write!(f, "p{letter}[{}]", orders.join(","))
        }
    }
}

impl FromStr for Kind {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let wrong = || {
            Error::shape(
                "kind",
                format!("{text:?}"),
                "a kind such as \"pP\", \"pL4\", \"pS34\", \"pV222\" or \"pS[12,3]\"",
            )
        };
        let mut rest = text.trim().chars();
        let (Some('p'), Some(letter)) = (rest.next(), rest.next()) else {
            return Err(wrong());
        };
        let orders = read_orders(rest.as_str(), letter == 'L').ok_or_else(wrong)?;
        let expected = LETTERS.iter().position(|&known| known == letter);
        let fits = match expected {
            Some(axes) => axes == orders.len(),
            None => letter == 'F',
        };
        if !fits || orders.contains(&0) {
            return Err(wrong());
        }
        Ok(Self(orders))
    }
}

fn read_orders(text: &str, curve: bool) -> Option<Vec<usize>> {
    let parse = |part: &str| part.trim().parse::<usize>().ok();
    if text.is_empty() {
        return Some(Vec::new());
    }
    if let Some(list) = text.strip_prefix('[') {
        return list.strip_suffix(']')?.split(',').map(parse).collect();
    }
    if curve {
        return Some(vec![parse(text)?]);
    }
    text.chars().map(|digit| digit.to_digit(10).map(|order| order as usize)).collect()
}
