//! Signs and operators, and how tightly they bind.

/// An operator between two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operator {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `^`, grouped from the right
    Power,
    /// `=`
    Equal,
    /// `<>`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}

impl Operator {
    /// As it is printed.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::Power => "^",
            Self::Equal => "=",
            Self::NotEqual => "<>",
            Self::Less => "<",
            Self::LessEqual => "<=",
            Self::Greater => ">",
            Self::GreaterEqual => ">=",
        }
    }

    /// Whether it compares and gives true or false.
    pub fn compares(self) -> bool {
        self.strength() == COMPARISON
    }

    /// A larger number binds tighter. A sign lies between the products and the power: `-a^2` is `-(a^2)`.
    pub(crate) fn strength(self) -> u8 {
        match self {
            Self::Add | Self::Subtract => SUM,
            Self::Multiply | Self::Divide => PRODUCT,
            Self::Power => POWER,
            _ => COMPARISON,
        }
    }

    /// What an operator of the right operand must reach to stand there without brackets.
    pub(crate) fn right_strength(self) -> u8 {
        if self == Self::Power { POWER } else { self.strength() + 1 }
    }

    /// What an operator of the left operand must reach to stand there without brackets.
    pub(crate) fn left_strength(self) -> u8 {
        if self == Self::Power { POWER + 1 } else { self.strength() }
    }
}

pub(crate) const LOOSEST: u8 = COMPARISON;
const COMPARISON: u8 = 1;
const SUM: u8 = 2;
const PRODUCT: u8 = 3;
pub(crate) const SIGN: u8 = 4;
const POWER: u8 = 5;

/// A sign before an operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sign {
    /// `+`
    Plus,
    /// `-`
    Minus,
}

impl Sign {
    /// As it is printed.
    pub fn symbol(self) -> char {
        match self {
            Self::Plus => '+',
            Self::Minus => '-',
        }
    }
}
