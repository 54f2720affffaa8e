//! Reads the assignment's input: N, L, r, S, `print` or `perf`, and optionally N discs.

use std::io::BufRead;

use super::words::{InputError, Words};
use super::{Disc, RandomScene, Scene, SceneError};

/// The contents of an input.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// Number of discs N.
    pub n: u64,
    /// Side L of the square.
    pub side: f64,
    /// Radius r of a disc.
    pub radius: f64,
    /// Number of time steps S.
    pub steps: u64,
    /// The amount of output.
    pub mode: Mode,
    /// The discs, if the input lists them. Otherwise discs are random.
    pub discs: Option<Vec<Disc>>,
}

/// The amount of a run's output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// The start, every step and the end.
    Print,
    /// The start and the end.
    Perf,
}

impl Problem {
    /// Returns the scene at the start. If no discs are listed, `random` may adjust the random
    /// scene.
    ///
    /// # Errors
    /// The numbers do not make a valid scene.
    pub fn scene(
        &mut self,
        seed: u32,
        random: impl FnOnce(RandomScene) -> RandomScene,
    ) -> Result<Scene, SceneError> {
        match self.discs.take() {
            Some(discs) => Scene::new(self.side, self.radius, discs),
            None => random(RandomScene::new(self.n, self.side, self.radius, seed)).draw(),
        }
    }
}

/// Reads an input. The five fields of the head may be on any lines; each disc is on its own line.
///
/// # Errors
/// An [`InputError`], which names the line and the field.
pub fn read_problem(input: impl BufRead) -> Result<Problem, InputError> {
    let mut lines = Words::new(input);
    let n = lines.head("N", "a whole number of discs, 1 or more", |n: &u64| *n > 0)?;
    Scene::check_count(n).map_err(|e| lines.error(e))?;
    let side = lines.head("L", "a positive finite number", is_positive)?;
    let radius = lines.head("r", "a positive finite number", is_positive)?;
    Scene::check_square(side, radius).map_err(|e| lines.error(e))?;
    let steps = lines.head("S", "a whole number of steps, 0 or more", |_| true)?;
    let mode: String =
        lines.head("mode", "print or perf", |m: &String| m == "print" || m == "perf")?;
    let mode = if mode == "print" { Mode::Print } else { Mode::Perf };
    lines.end_of_line("the head")?;

    // The list grows disc by disc, because an input may claim a billion discs and contain three.
    let mut discs = Vec::new();
    while lines.next_line()? {
        let i = discs.len() as u64;
        if i == n {
            lines.end_of_line(&format!("the last of {n} discs"))?;
        }
        let found: u64 = lines.field("i", "the number of a disc", |_| true)?;
        if found != i {
            let why = if found < i {
                ", which is there already"
            } else {
                "; discs must be in order, 0 to N − 1"
            };
            return Err(lines.error(format!("i: expected disc {i}, found disc {found}{why}")));
        }
        let mut numbers = [0.0; 4];
        for (number, field) in numbers.iter_mut().zip(["x", "y", "vx", "vy"]) {
            let field = format_args!("{field} of disc {i}");
            *number = lines.field(field, "a finite number", |value: &f64| value.is_finite())?;
        }
        let [x, y, vx, vy] = numbers;
        let disc = Disc::new(x, y, vx, vy);
        lines.end_of_line(&format!("vy of disc {i}"))?;
        Scene::check_disc(side, radius, i as usize, &disc).map_err(|e| lines.error(e))?;
        discs.push(disc);
    }
    let found = discs.len() as u64;
    if found > 0 && found < n {
        let what = "is missing: the input ends after";
        return Err(lines.error(format!("disc {found} {what} {found} of {n} discs")));
    }
    Ok(Problem { n, side, radius, steps, mode, discs: (found > 0).then_some(discs) })
}

fn is_positive(value: &f64) -> bool {
    value.is_finite() && *value > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_input_without_discs_is_a_head() {
        let problem = read_problem(&b"3 10\n0.5 7\nperf\n\n"[..]).unwrap();
        assert_eq!((problem.n, problem.side, problem.radius, problem.steps), (3, 10.0, 0.5, 7));
        assert_eq!((problem.mode, problem.discs), (Mode::Perf, None));
    }

    #[test]
    fn discs_are_read_in_order() {
        let problem = read_problem(&b"2\n10\n1\n5\nprint\n0 1 2 3 4\n\n1 5 6 -7e0 .5"[..]).unwrap();
        let discs = vec![Disc::new(1.0, 2.0, 3.0, 4.0), Disc::new(5.0, 6.0, -7.0, 0.5)];
        assert_eq!(problem.discs, Some(discs));
    }

    #[test]
    fn a_byte_order_mark_is_no_part_of_a_number() {
        let problem = read_problem("\u{feff}3 10\n0.5 7\nperf\n".as_bytes()).unwrap();
        assert_eq!((problem.n, problem.steps), (3, 7));
        let scene = crate::soft::read_scene("\u{feff}1 2\n1 1 0 0\n".as_bytes()).unwrap();
        assert_eq!(scene.len(), 1);
    }

    #[test]
    fn a_bad_input_gets_one_line_that_names_line_and_field() {
        for (input, message) in [
            ("", "line 1: N is missing"),
            ("0 10 1 5 perf", "line 1: N: expected a whole number of discs, 1 or more, found '0'"),
            (
                "-3 10 1 5 perf",
                "line 1: N: expected a whole number of discs, 1 or more, found '-3'",
            ),
            (
                "99999999999 10 1 5 perf",
                "line 1: a scene holds at most 2147483647 discs, not 99999999999",
            ),
            ("2\nten 1 5 perf", "line 2: L: expected a positive finite number, found 'ten'"),
            ("2\n10\ninf 5 perf", "line 3: r: expected a positive finite number, found 'inf'"),
            (
                "2\n10\n6 5 perf",
                "line 3: a disc of radius r = 6 does not fit into a square of side L = 10",
            ),
            (
                "2 10 1 5.5 perf",
                "line 1: S: expected a whole number of steps, 0 or more, found '5.5'",
            ),
            ("2 10 1 5 fast", "line 1: mode: expected print or perf, found 'fast'"),
            ("2 10 1 5", "line 1: mode is missing"),
            (
                "2 10 1 5 perf\n0 5 5 0 0\n",
                "line 2: disc 1 is missing: the input ends after 1 of 2 discs",
            ),
            ("2 10 1 5 perf\n0 5 5 0\n", "line 2: vy of disc 0 is missing"),
            (
                "2 10 1 5 perf\n1 5 5 0 0\n",
                "line 2: i: expected disc 0, found disc 1; discs must be in order, 0 to N − 1",
            ),
            (
                "2 10 1 5 perf\n0 5 5 0 0\n0 5 5 0 0\n",
                "line 3: i: expected disc 1, found disc 0, which is there already",
            ),
            (
                "1 10 1 5 perf\n0 5 5 nan 0\n",
                "line 2: vx of disc 0: expected a finite number, found 'nan'",
            ),
            (
                "1 10 1 5 perf\n0 5 5 1e999 0\n",
                "line 2: vx of disc 0: expected a finite number, found '1e999'",
            ),
            (
                "1 10 1 5 perf\n0 5 9.5 0 0\n",
                "line 2: disc 0: y = 9.5 lies outside 1 to 9, so it reaches beyond a wall",
            ),
            ("1 10 1 5 perf\n0 5 5 0 0 1\n", "line 2: '1' after vy of disc 0"),
            ("1 10 1 5 perf\n0 5 5 0 0\n1 5 5 0 0\n", "line 3: '1' after the last of 1 discs"),
        ] {
            assert_eq!(
                read_problem(input.as_bytes()).unwrap_err().to_string(),
                message,
                "{input:?}"
            );
        }
    }
}
