//! What a student types: test, hint, list and the rest of the way to handing in.

pub(crate) mod check;
pub(crate) mod hint;
pub(crate) mod list;
pub(crate) mod reset;
mod results;
mod tasks;
pub(crate) mod test;
