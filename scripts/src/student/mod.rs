//! What a student types: test, hint, list and the rest of the way to handing in.

pub(crate) mod check;
pub(crate) mod hint;
pub(crate) mod list;
pub(crate) mod progress;
mod report;
pub(crate) mod reset;
mod results;
pub(crate) mod submit;
mod tasks;
pub(crate) mod test;
pub(crate) mod watch;
