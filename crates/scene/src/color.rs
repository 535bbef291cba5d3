//! A colour.

use std::fmt;
use std::str::FromStr;

use pforms_kernel::{Error, Result};
use serde::{Deserialize, Serialize};

/// A colour as a screen shows it, written `#rrggbb`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Color(pub [u8; 3]);

impl Color {
    /// The channels from 0 to 1, as a screen takes them (sRGB).
    pub fn encoded(self) -> [f64; 3] {
        self.0.map(|channel| f64::from(channel) / 255.0)
    }

    /// The channels from 0 to 1 as amounts of light, as glTF takes them.
    pub fn linear(self) -> [f64; 3] {
        self.encoded().map(|channel| {
            if channel <= 0.04045 {
                channel / 12.92
            } else {
                libm::pow((channel + 0.055) / 1.055, 2.4)
            }
        })
    }
}

impl fmt::Display for Color {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [red, green, blue] = self.0;
        write!(f, "#{red:02x}{green:02x}{blue:02x}")
    }
}

impl FromStr for Color {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let digits = text.strip_prefix('#').filter(|digits| {
            digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit())
        });
        let number = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok());
        match number.map(u32::to_be_bytes) {
            Some([_, red, green, blue]) => Ok(Self([red, green, blue])),
            None => Err(Error::domain("color", format!("{text:?}"), "\"#rrggbb\"")),
        }
    }
}

impl TryFrom<String> for Color {
    type Error = Error;

    fn try_from(text: String) -> Result<Self> {
        text.parse()
    }
}

impl From<Color> for String {
    fn from(color: Color) -> Self {
        color.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_is_six_digits() {
        let yellow: Color = "#F2c14e".parse().unwrap();
        assert_eq!(yellow, Color([0xf2, 0xc1, 0x4e]));
        assert_eq!(yellow.to_string(), "#f2c14e");
        for wrong in ["", "#", "f2c14e", "#f2c14", "#f2c14e0", "#+2c14e", "#é2c14", "red"] {
            assert_eq!(wrong.parse::<Color>().unwrap_err().family(), "Domain", "{wrong}");
        }
    }

    #[test]
    fn light_is_not_what_the_screen_is_told() {
        let [black, grey, white] = Color([0, 188, 255]).linear();
        assert_eq!((black, white), (0.0, 1.0));
        assert!((grey - 0.5).abs() < 0.01);
    }
}
