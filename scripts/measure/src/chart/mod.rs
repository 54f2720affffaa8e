//! Charts of lines and bars as SVG, with the same look in all figures.
//!
//! Points are (x, y) pairs in any order. Values that are not finite are omitted, and on a
//! logarithmic axis also values that are not positive. The colours differ for every kind of colour
//! vision, and every series has a different mark as well.

mod axis;
mod draw;
mod figure;
mod layout;
mod look;
mod plane;

pub use axis::{Axis, number};
pub use draw::svg;
pub use figure::{Chart, Form, Kind, Series, Sheet};
