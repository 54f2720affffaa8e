//! What programs are set to, and what is observed in each scene.

use common::soft::{CUTOFF, Scene};
use oracle::scenes::crowd;

use super::scenes::{absurd, edges, fast, head_on, one_position, shifted, very_close, walls};

/// A scene that programs are set to, and the columns that it fills.
pub(super) struct Trial {
    pub(super) name: &'static str,
    /// One or more scenes; figures are those of the worst.
    pub(super) scenes: Vec<Scene>,
    pub(super) steps: u64,
    /// How many steps lie between two observed states; each step is compared with the method's if this is 1.
    pub(super) every: u64,
    /// The length of a step in official ones; 1 is what every program can do.
    pub(super) stretch: f64,
    pub(super) observable: Observable,
    pub(super) columns: Vec<Column>,
}

/// What is observed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Observable {
    /// Pairs (2k, 2k + 1) that meet head on, sorted by speed: the energy that they gain, and whether
    /// they pass through each other.
    HeadOn { phases: u32 },
    /// The change of all energy, as a share of what it was; at most as many as that are nothing.
    Energy,
    /// The distance from where the method goes, in cutoffs.
    Off,
    /// How far the first scene's particles end from the second's, in cutoffs, but for the offset.
    Shifted,
    /// Only that all particles stay finite and inside.
    Inside,
}

/// A column of the table.
#[derive(Clone, Copy)]
pub(super) struct Column {
    pub(super) head: &'static str,
    /// A figure up to this passes.
    pub(super) good: f64,
    /// The section of the chapter that explains a figure beyond it as a limit of the method; none if
    /// there is no excuse.
    pub(super) section: Option<&'static str>,
}

const fn column(head: &'static str, good: f64, section: &'static str) -> Column {
    Column { head, good, section: Some(section) }
}

const fn strict(head: &'static str, good: f64) -> Column {
    Column { head, good, section: None }
}

/// Sections of the chapter *Accurate*.
pub(super) const STEEP: &str = "Too steep for the step";
const THROUGH: &str = "Through each other";
const FLUNG: &str = "Flung apart";
const LONG: &str = "A step too long";
const HEATING: &str = "A box that heats up";
const DIGITS: &str = "Digits of a wide box";

/// All trials; `quick` ones are the same with less of everything.
pub(super) fn all(quick: bool) -> Vec<Trial> {
    let phases = if quick { 4 } else { 25 };
    let trial = |name, scenes, steps, observable, columns: &[Column]| {
        let columns = columns.to_vec();
        Trial { name, scenes, steps, every: 1, stretch: 1.0, observable, columns }
    };
    let mut all = vec![
        trial(
            "head-on pairs",
            vec![head_on(phases)],
            40,
            Observable::HeadOn { phases },
            &[
                column("w 1-5", 0.01, STEEP),
                column("w 6-10", 0.01, STEEP),
                column("w 11-20", 0.01, STEEP),
                column("through at w", 0.0, THROUGH),
            ],
        ),
        trial(
            "pairs at one position",
            vec![one_position()],
            20,
            Observable::Off,
            &[strict("one position", 1e-3)],
        ),
        trial(
            "pairs nearly at one position",
            vec![very_close()],
            10,
            Observable::Energy,
            &[column("very close", 0.01, FLUNG)],
        ),
        trial("a crowd", vec![crowd(1)], 10, Observable::Energy, &[column("crowd", 0.01, FLUNG)]),
        trial("one that is very fast", fast(), 20, Observable::Off, &[strict("fast", 1e-3)]),
        trial("absurd numbers", absurd(), 20, Observable::Inside, &[strict("absurd", 0.0)]),
        // A method of low order may be so far from the exact motion; official steps are compared to rounding.
        trial("walls and corners", vec![walls()], 20, Observable::Off, &[strict("walls", 0.05)]),
        trial("edges of bins", vec![edges()], 10, Observable::Off, &[strict("edges", 0.05)]),
    ];
    for (cutoffs, head) in [(1e4, "10^4 c"), (1e6, "10^6 c"), (1e8, "10^8 c")] {
        let (scenes, columns) = (shifted(cutoffs * CUTOFF), [column(head, 1e-5, DIGITS)]);
        all.push(trial("far from the corner", scenes, 20, Observable::Shifted, &columns));
    }
    let (n, steps) = if quick { (50, 200) } else { (500, 1000) };
    let long = |name, n, steps, stretch, column| {
        let scene = Scene::official(n, 1).expect("a scene");
        let trial = trial(name, vec![scene], steps, Observable::Energy, &[column]);
        Trial { every: steps - 1, stretch, ..trial }
    };
    for (stretch, head) in [(1.0, "dt 5e-4"), (2.0, "dt 1e-3"), (4.0, "dt 2e-3")] {
        let (name, steps) = ("the official scene until t = 0.5", (steps as f64 / stretch) as u64);
        all.push(long(name, n, steps, stretch, column(head, 0.1, LONG)));
    }
    let (steps, head) = if quick { (10_000, "10^4 steps") } else { (1_000_000, "10^6 steps") };
    let name = "a small box for a long time";
    all.push(long(name, 20, steps, 1.0, column(head, 0.1, HEATING)));
    all
}
