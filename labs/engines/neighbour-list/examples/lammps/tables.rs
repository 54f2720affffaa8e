//! Tables of forces, trajectories and times.

use lab_kit::table::three_digits;
use lab_measure::columns::Columns;
use lab_measure::experiment::Bound;

use crate::compare::{Moment, PairError};
use crate::race::Timed;

/// Numbers of the states that the table shows; the first state is number 0. The data file contains
/// all states.
const SHOWN: [u64; 6] = [0, 1, 2, 4, 10, 20];

pub(crate) fn pairs(errors: &[PairError]) -> String {
    let table = Columns::of("force of a pair", |of: &PairError| format!("LAMMPS {}", of.style))
        .text("distances", |of| of.distances.to_string())
        .text("largest error beyond c/2", |of| format!("{:.1e}", of.beyond_half_a_cutoff))
        .text("beyond c/100", |of| format!("{:.1e}", of.largest))
        .table(errors);
    format!("{table}\nrelative to the exact force at the same distance\n")
}

pub(crate) fn moments(n: usize, moments: &[Moment]) -> String {
    let every = moments.iter().map(|moment| moment.step - 1).filter(|steps| *steps > 0).min();
    let every = every.unwrap_or(1);
    let shown = moments.iter().filter(|moment| SHOWN.contains(&((moment.step - 1) / every)));
    let table = Columns::of("after step", |moment: &Moment| moment.step.to_string())
        .text("our program", |moment| moment.program.to_string())
        .text("LAMMPS", |moment| moment.style.to_string())
        .perhaps("furthest from LAMMPS's, in cutoffs", |moment| {
            Some(format!("{:.1e}", moment.furthest_in_cutoffs?))
        })
        .perhaps("its error", |moment| Some(format!("{:.2e}", moment.rms_error?)))
        .perhaps("LAMMPS's error", |moment| Some(format!("{:.2e}", moment.rms_error_lammps?)))
        .text("its energy", |moment| format!("{:+.2e}", moment.energy_change))
        .perhaps("LAMMPS's energy", |moment| Some(format!("{:+.2e}", moment.energy_change_lammps?)))
        .table(shown);
    format!(
        "n = {n}; errors are rms distances from the exact positions, energies relative changes since \
         the start\n\n{table}"
    )
}

/// Formats a table of all setups of LAMMPS.
pub(crate) fn tried(tried: &[Timed]) -> String {
    let takes = tried.first().map_or(0, |one| one.times.takes.len());
    format!("All setups of LAMMPS, {takes} takes each\n\n{}", columns().table(tried))
}

/// Formats a table of the best setup of each style and of the programs, with the streaming bound.
pub(crate) fn times(times: &[Timed], yardstick: &[Bound]) -> String {
    let takes = times.first().map_or(0, |one| one.times.takes.len());
    let mut table = columns()
        .number("LAMMPS's best / this", |timed| Some(timed.lammps_best_over_this?.of_minima))
        .number("by medians", |timed| Some(timed.lammps_best_over_this?.of_medians))
        .number("plugin / this", |timed| Some(timed.plugin_over_this?.of_minima))
        .number("plugin by medians", |timed| Some(timed.plugin_over_this?.of_medians))
        .table(times);
    for bound in yardstick {
        let n = bound.n.to_string();
        table.row(["the yardstick", &n, "", &three_digits(bound.nanoseconds)]);
    }
    format!("The best of each style and the programs, {takes} takes in turns\n\n{table}")
}

fn columns() -> Columns<'static, Timed> {
    Columns::of("ns per particle and step", Timed::name)
        .text("n", |timed| timed.n.to_string())
        .text("steps", |timed| timed.steps.to_string())
        .times("", |timed| timed.nanoseconds_per_particle_and_step)
}
