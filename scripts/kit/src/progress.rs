//! Progress on the terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar on a terminal; nothing elsewhere.
pub fn progress(length: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {pos} of {len}, {eta} left  {msg}")
        .expect("the template is valid");
    ProgressBar::new(length).with_style(style)
}
