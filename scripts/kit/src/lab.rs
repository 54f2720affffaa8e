//! The number of a lab.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

/// The number of a lab, 1 or more. It is parsed from `3` or `lab3`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize)]
#[serde(transparent)]
pub struct Lab(u8);

impl Default for Lab {
    fn default() -> Self {
        Self(1)
    }
}

impl fmt::Display for Lab {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl FromStr for Lab {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.strip_prefix("lab").unwrap_or(text).parse() {
            Ok(number) if number > 0 => Ok(Self(number)),
            _ => Err(format!("'{text}' is not the number of a lab, such as 3")),
        }
    }
}
