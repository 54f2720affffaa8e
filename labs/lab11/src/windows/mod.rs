//! Windows of several steps, and of one.

mod band;
mod counts;
mod ending;
mod listed;
mod missed;
mod verify;
mod window;

pub(crate) use counts::WindowCounts;
pub(crate) use listed::Listed;
pub(crate) use window::Window;
