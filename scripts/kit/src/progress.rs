//! Progress bars on the terminal.

use std::env;
use std::io::IsTerminal;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Whether a stream is a terminal with escape codes. An editor's shell sets `TERM` to `dumb`.
pub fn can_draw(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && is_clever(env::var("TERM").ok().as_deref())
}

fn is_clever(terminal: Option<&str>) -> bool {
    terminal.is_none_or(|terminal| terminal != "dumb")
}

/// Makes a progress bar. Without a terminal, the bar counts but is not drawn.
pub fn progress(length: u64) -> ProgressBar {
    if !can_draw(&std::io::stderr()) {
        return ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::hidden());
    }
    let style = ProgressStyle::with_template("{bar:30} {pos} of {len}, {eta} left  {msg}")
        .expect("the template is valid");
    ProgressBar::new(length).with_style(style)
}

#[cfg(test)]
mod tests {
    use super::{is_clever, progress};

    #[test]
    fn a_bar_counts_wherever_it_is() {
        assert_eq!(progress(7).length(), Some(7));
    }

    #[test]
    fn nothing_is_drawn_on_a_dumb_terminal() {
        let clever = [Some("dumb"), Some("xterm-256color"), None].map(is_clever);
        assert_eq!(clever, [false, true, true]);
    }
}
