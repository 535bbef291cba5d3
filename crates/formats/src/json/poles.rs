//! An array of numbers, flat or nested, read without trust.

use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, SeqAccess, Visitor};

use super::Number;
use super::number::fraction;

/// Numbers one after the other, and the shape they came in.
pub(super) struct Array<S> {
    pub(super) numbers: Vec<S>,
    pub(super) shape: Vec<usize>,
}

impl<'de, S: Number> serde::Deserialize<'de> for Array<S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut numbers = Vec::new();
        let shape = Part { numbers: &mut numbers }.deserialize(deserializer)?;
        Ok(Self { numbers, shape })
    }
}

/// An array or a number inside it; what is read is its shape, and the numbers are gathered.
struct Part<'a, S> {
    numbers: &'a mut Vec<S>,
}

impl<'de, S: Number> DeserializeSeed<'de> for Part<'_, S> {
    type Value = Vec<usize>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Vec<usize>, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de, S: Number> Visitor<'de> for Part<'_, S> {
    type Value = Vec<usize>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, a fraction such as \"1/3\", or an array of them")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Vec<usize>, E> {
        let number =
            S::from_float(number).ok_or_else(|| E::custom("a number that is not finite"))?;
        self.numbers.push(number);
        Ok(Vec::new())
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Vec<usize>, E> {
        self.visit_str(&number.to_string())
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Vec<usize>, E> {
        self.visit_str(&number.to_string())
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Vec<usize>, E> {
        let number = fraction(text).map(S::from_fraction);
        let number = number.filter(S::is_finite).ok_or_else(|| {
            let shown: String = text.chars().take(40).collect();
            E::custom(format!("{shown:?} is no fraction; expected one such as \"1/3\""))
        })?;
        self.numbers.push(number);
        Ok(Vec::new())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Vec<usize>, A::Error> {
        let mut count = 0;
        let mut common: Option<Vec<usize>> = None;
        while let Some(shape) = items.next_element_seed(Part { numbers: &mut *self.numbers })? {
            match &common {
                Some(common) if *common != shape => {
                    let message = format!("ragged: {} beside {}", said(common), said(&shape));
                    return Err(A::Error::custom(message));
                }
                Some(_) => {}
                None => common = Some(shape),
            }
            count += 1;
        }
        let mut shape = vec![count];
        shape.extend(common.unwrap_or_default());
        Ok(shape)
    }
}

fn said(shape: &[usize]) -> String {
    match shape {
        [] => "a number".to_owned(),
        [count] => format!("an array of {count} numbers"),
        _ => {
            let sides: Vec<String> = shape.iter().map(usize::to_string).collect();
            format!("an array of {}", sides.join("×"))
        }
    }
}
