//! What a student types: test, hint, list and the rest of the way to handing in.

pub(crate) mod hint;
pub(crate) mod list;
mod results;
mod tasks;
pub(crate) mod test;
