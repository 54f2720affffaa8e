//! The tables of trajectories and of times.

use super::trajectories::Moment;
use super::{Results, Timed};
use lab_kit::table::{Table, three_digits};

/// Steps whose states are shown; the record has all.
const SHOWN: [u64; 6] = [1, 51, 101, 201, 501, 1001];

pub(super) fn moments(n: usize, moments: &[Moment]) -> String {
    let mut table = Table::new([
        "after step",
        "our program",
        "furthest from LAMMPS's, in cutoffs",
        "its energy",
        "LAMMPS's energy",
    ]);
    for moment in moments.iter().filter(|moment| SHOWN.contains(&moment.step)) {
        table.row([
            moment.step.to_string(),
            moment.program.to_string(),
            format!("{:.1e}", moment.furthest_in_cutoffs),
            format!("{:+.2e}", moment.energy_change),
            format!("{:+.2e}", moment.energy_change_lammps),
        ]);
    }
    format!("n = {n}; energies as relative changes since the start\n\n{table}")
}

pub(super) fn times(Results { wheel, workers, times, yardstick, .. }: &Results) -> String {
    let mut table = Table::new([
        "ns per particle and step",
        "n",
        "steps",
        "min",
        "median",
        "LAMMPS's best / this",
        "by medians",
    ]);
    for Timed {
        engine,
        n,
        steps,
        nanoseconds_per_particle_and_step: ns,
        lammps_best_over_this,
        ..
    } in times
    {
        let ratio = |of: f64| format!("{of:.2}");
        table.row([
            engine.clone(),
            n.to_string(),
            steps.to_string(),
            three_digits(ns.min),
            three_digits(ns.median),
            lammps_best_over_this.map_or_else(String::new, |best| ratio(best.of_minima)),
            lammps_best_over_this.map_or_else(String::new, |best| ratio(best.of_medians)),
        ]);
    }
    for bound in yardstick {
        let n = bound.n.to_string();
        table.row(["the yardstick", &n, "", &three_digits(bound.nanoseconds)]);
    }
    let takes = times.first().map_or(0, |one| one.times.takes());
    let workers = if *workers == 1 { "one thread".into() } else { format!("{workers} workers") };
    format!("{table}\n{wheel}, {workers} each; {takes} takes in turns")
}
