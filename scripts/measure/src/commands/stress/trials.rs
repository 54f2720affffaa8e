//! The trials of programs, and the measurement in each trial.

use common::soft::{CUTOFF, Scene};
use oracle::scenes::crowd;

use super::scenes::{absurd, edges, fast, head_on, one_position, shifted, very_close, walls};

use Observable::{Energy, HeadOn, Inside, Off, Shifted};

/// Scenes for the programs, and the columns for the results.
#[derive(Clone)]
pub(super) struct Trial {
    pub(super) name: &'static str,
    /// One or more scenes. A figure is the worst number of all scenes.
    pub(super) scenes: Vec<Scene>,
    pub(super) steps: u64,
    /// Number of steps between two observed states. If the number is 1, each step is compared with
    /// the method's step.
    pub(super) every: u64,
    /// Length of a step in official steps. Every program supports 1.
    pub(super) stretch: f64,
    pub(super) observable: Observable,
    pub(super) columns: Vec<Column>,
}

/// The quantity that a trial measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Observable {
    /// The energy that pairs (2k, 2k + 1) gain in a head-on collision, and whether they pass
    /// through each other. The pairs are sorted by speed.
    HeadOn { phases: u32 },
    /// Relative change of the total energy.
    Energy,
    /// Distance of particles from their places after the method's step, in cutoffs.
    Off,
    /// Difference between the particles' last positions in the two scenes, without the offset, in
    /// cutoffs.
    Shifted,
    /// No number. All particles must stay finite and inside the box.
    Inside,
}

#[derive(Clone, Copy)]
pub(super) struct Column {
    pub(super) head: &'static str,
    /// Greatest figure that passes.
    pub(super) good: f64,
    /// Section of the chapter that explains a greater figure as a limit of the method; `None` if a
    /// greater figure is a failure.
    pub(super) section: Option<&'static str>,
}

const fn column(head: &'static str, good: f64, section: &'static str) -> Column {
    Column { head, good, section: Some(section) }
}

const fn strict(head: &'static str, good: f64) -> Column {
    Column { head, good, section: None }
}

/// Sections of the chapter *Accurate*.
const STEEP: &str = "Too steep for the step";
const THROUGH: &str = "Through each other";
const FLUNG: &str = "Flung apart";
const LONG: &str = "A step too long";
const HEATING: &str = "A box that heats up";
const DIGITS: &str = "Digits of a wide box";

impl Trial {
    /// Makes a trial of official steps in which every state is observed.
    fn new(
        name: &'static str,
        scenes: Vec<Scene>,
        steps: u64,
        observable: Observable,
        columns: &[Column],
    ) -> Self {
        let columns = columns.to_vec();
        Self { name, scenes, steps, every: 1, stretch: 1.0, observable, columns }
    }

    /// Makes a trial of the official scene that measures the energy of the last state.
    fn long(name: &'static str, n: u64, steps: u64, stretch: f64, column: Column) -> Self {
        let scene = Scene::official(n, 1).expect("a scene");
        let trial = Self::new(name, vec![scene], steps, Energy, &[column]);
        Self { every: steps - 1, stretch, ..trial }
    }
}

/// Returns all trials. With `quick` they have fewer steps, particles and phases.
pub(super) fn all(quick: bool) -> Vec<Trial> {
    let mut all = short(if quick { 4 } else { 25 });
    let n = if quick { 50 } else { 500 };
    for (stretch, head) in [(1.0, "dt 5e-4"), (2.0, "dt 1e-3"), (4.0, "dt 2e-3")] {
        let steps = (if quick { 200.0 } else { 1000.0 } / stretch) as u64;
        let name = "the official scene until t = 0.5";
        all.push(Trial::long(name, n, steps, stretch, column(head, 0.1, LONG)));
    }
    let (steps, head) = if quick { (10_000, "10^4 steps") } else { (1_000_000, "10^6 steps") };
    let name = "a small box for a long time";
    all.push(Trial::long(name, 20, steps, 1.0, column(head, 0.1, HEATING)));
    all
}

/// Returns the trials of a few steps, in which each step is compared with the method's step.
pub(super) fn short(phases: u32) -> Vec<Trial> {
    let head_on_columns = [
        column("w 1-5", 0.01, STEEP),
        column("w 6-10", 0.01, STEEP),
        column("w 11-20", 0.01, STEEP),
        column("through at w", 0.0, THROUGH),
    ];
    let at_one = [strict("one position", 1e-3)];
    let close = [column("very close", 0.01, FLUNG)];
    let mut short = vec![
        Trial::new("head-on pairs", vec![head_on(phases)], 40, HeadOn { phases }, &head_on_columns),
        Trial::new("pairs at one position", vec![one_position()], 20, Off, &at_one),
        Trial::new("pairs nearly at one position", vec![very_close()], 10, Energy, &close),
        Trial::new("a crowd", vec![crowd(1)], 10, Energy, &[column("crowd", 0.01, FLUNG)]),
        Trial::new("one that is very fast", fast(), 20, Off, &[strict("fast", 1e-3)]),
        Trial::new("absurd numbers", absurd(), 20, Inside, &[strict("absurd", 0.0)]),
        // A method of low order may differ from the exact motion by 0.05 cutoffs. Official steps
        // must agree except for rounding.
        Trial::new("walls and corners", vec![walls()], 20, Off, &[strict("walls", 0.05)]),
        Trial::new("edges of bins", vec![edges()], 10, Off, &[strict("edges", 0.05)]),
    ];
    for (cutoffs, head) in [(1e4, "10^4 c"), (1e6, "10^6 c"), (1e8, "10^8 c")] {
        let scenes = shifted(cutoffs * CUTOFF);
        let columns = [column(head, 1e-5, DIGITS)];
        let name = "far from the corner";
        short.push(Trial::new(name, scenes, 20, Shifted, &columns));
    }
    short
}
