//! Charts of lines and bars as SVG, the one look of all figures.
//!
//! ```ignore
//! let chart = Chart::new("Run time against n", Axis::log("particles n"), Axis::log("time [s]"))
//!     .with(Series::new(Kind::Measured, "sorted", points))
//!     .with(Series::new(Kind::Published, "CS267, Table 1", table))
//!     .with(Series::new(Kind::Guide, "slope 1", line));
//! write_file(&path, svg(&[vec![chart]], Form::Page))?;
//! ```
//!
//! Points are (x, y) pairs in any order. On a logarithmic axis a value that is not positive, and
//! on every axis a value that is not finite, is left out. Colours can be told apart with any kind of
//! colour vision, and every series has its own mark as well.

mod axis;
mod draw;
mod figure;
mod layout;
mod look;
mod plane;

pub use axis::{Axis, number};
pub use draw::svg;
pub use figure::{Chart, Form, Kind, Series, Sheet};
