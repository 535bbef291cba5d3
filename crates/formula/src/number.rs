//! Numbers as text.

/// The shortest decimal text that reads back as the same number; `1`, `0.25`, `1e-7`.
///
/// Zero has no sign. A value that is not finite has no decimal text: the answer is then `NaN` or `inf`.
pub fn decimal(value: f64) -> String {
    let text = format!("{:?}", value + 0.0);
    text.strip_suffix(".0").map(Into::into).unwrap_or(text)
}

/// Reads the text of a number exactly: it is the digits, as an integer, times ten to the exponent.
///
/// `None` if the text is not of the form `1.50e-3` or the exponent does not fit. The exponent may be huge: check it
/// before computing the power.
///
/// ```
/// use pforms_formula::digits_and_exponent;
/// assert_eq!(digits_and_exponent("0.1"), Some(("01".into(), -1)));
/// assert_eq!(digits_and_exponent("1.50e-3"), Some(("150".into(), -5)));
/// ```
pub fn digits_and_exponent(number: &str) -> Option<(String, i64)> {
    let (mantissa, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let exponent = exponent.parse::<i64>().ok()?.checked_sub(fraction.len() as i64)?;
    Some((digits, exponent))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_short_and_exact() {
        for (value, text) in
            [(0.1, "0.1"), (-0.0, "0"), (3.0, "3"), (1e300, "1e300"), (2.5e-7, "2.5e-7")]
        {
            assert_eq!(decimal(value), text);
        }
    }

    #[test]
    fn digits_are_exact() {
        for (text, digits, exponent) in
            [("12", "12", 0), (".5", "5", -1), ("1e3", "1", 3), ("0.25E+2", "025", 0)]
        {
            assert_eq!(digits_and_exponent(text), Some((digits.into(), exponent)));
        }
        for text in ["", ".", "e3", "-1", "1e", "1e99999999999999999999", "1,5"] {
            assert_eq!(digits_and_exponent(text), None, "{text}");
        }
    }
}
