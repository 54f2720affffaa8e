//! The tables of trajectories and of times.

use super::trajectories::Moment;
use super::{Results, Timed};
use lab_kit::table::three_digits;
use lab_measure::clock::Ratio;
use lab_measure::columns::Columns;

/// Steps whose states are shown; the record has all.
const SHOWN: [u64; 6] = [1, 51, 101, 201, 501, 1001];

pub(super) fn moments(n: usize, moments: &[Moment]) -> String {
    let shown = moments.iter().filter(|moment| SHOWN.contains(&moment.step));
    let table = Columns::of("after step", |moment: &Moment| moment.step.to_string())
        .text("our program", |moment| moment.program.to_string())
        .text("furthest from LAMMPS's, in cutoffs", |moment| {
            format!("{:.1e}", moment.furthest_in_cutoffs)
        })
        .text("its energy", |moment| format!("{:+.2e}", moment.energy_change))
        .text("LAMMPS's energy", |moment| format!("{:+.2e}", moment.energy_change_lammps))
        .table(shown);
    format!("n = {n}; energies as relative changes since the start\n\n{table}")
}

pub(super) fn times(Results { wheel, workers, times, yardstick, .. }: &Results) -> String {
    let best = |timed: &Timed, of: fn(&Ratio) -> f64| {
        timed.lammps_best_over_this.as_ref().map(|best| format!("{:.2}", of(best)))
    };
    let mut table = Columns::of("ns per particle and step", |timed: &Timed| timed.engine.clone())
        .text("n", |timed| timed.n.to_string())
        .text("steps", |timed| timed.steps.to_string())
        .times("", |timed| timed.nanoseconds_per_particle_and_step)
        .perhaps("LAMMPS's best / this", |timed| best(timed, |best| best.of_minima))
        .perhaps("by medians", |timed| best(timed, |best| best.of_medians))
        .table(times);
    for bound in yardstick {
        let n = bound.n.to_string();
        table.row(["the yardstick", &n, "", &three_digits(bound.nanoseconds)]);
    }
    let takes = times.first().map_or(0, |one| one.times.takes());
    let workers = if *workers == 1 { "one thread".into() } else { format!("{workers} workers") };
    format!("{table}\n{wheel}, {workers} each; {takes} takes in turns")
}
