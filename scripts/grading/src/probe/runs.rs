//! Judging runs: the states of soft discs after each step.
//!
//! A run is written as the side of the box, the number of particles, and x, y, vx, vy of each
//! particle before the first step and after every one. Particles are chaotic, so a program that
//! promises no bits is followed: the model takes every step again from where the program began it.

use common::soft::Particle;
use oracle::{check_step, difference};

/// What is wrong with a run that may add in an order of its own.
pub(crate) fn off_the_model(expected: &[f64], given: &[f64]) -> Option<String> {
    let (size, right) = states(expected)?;
    let (_, given) = match states(given) {
        Some(run) if run.1.len() == right.len() => run,
        _ => return Some("the run is not whole".into()),
    };
    // Where it begins is for the grader to say.
    let mut before = &right[0];
    for (step, after) in given.iter().enumerate().skip(1) {
        if after.len() != before.len() {
            return Some(format!("step {step}: {} particles, not {}", after.len(), before.len()));
        }
        if let Err(words) = check_step(size, before, after) {
            return Some(format!("step {step}, {words}"));
        }
        before = after;
    }
    None
}

/// What is wrong with a run that must have the solution's bits.
pub(crate) fn other_bits(expected: &[f64], given: &[f64]) -> Option<String> {
    let (_, right) = states(expected)?;
    let Some((_, found)) = states(given) else { return Some("the run is not whole".into()) };
    let states = found.iter().zip(&right).enumerate();
    let other = |(step, (found, right)): (usize, (&Vec<_>, &Vec<_>))| {
        Some(format!("step {step}, {}", difference(found, right)?))
    };
    let whole =
        found.len() == right.len() && found.first().map(Vec::len) == right.first().map(Vec::len);
    states.filter_map(other).next().or_else(|| (!whole).then(|| "the run is not whole".into()))
}

/// The side of the box and the states; none if these are no whole states.
fn states(values: &[f64]) -> Option<(f64, Vec<Vec<Particle>>)> {
    let [size, n, rest @ ..] = values else { return None };
    let n = *n as usize;
    if n == 0 || !rest.len().is_multiple_of(4 * n) {
        return None;
    }
    let state = |values: &[f64]| {
        let particles = values.chunks_exact(4).enumerate();
        let particle = |(id, v): (usize, &[f64])| Particle {
            x: v[0],
            y: v[1],
            vx: v[2],
            vy: v[3],
            id: id as u32,
        };
        particles.map(particle).collect()
    };
    Some((*size, rest.chunks_exact(4 * n).map(state).collect()))
}

#[cfg(test)]
mod tests {
    use super::{off_the_model, other_bits};

    /// One particle, two steps.
    fn run() -> Vec<f64> {
        let dt = common::soft::DT;
        let x = [0.5, 0.5 + dt, 0.5 + dt + dt];
        let state = |x: f64| [x, 0.25, 1.0, 0.0];
        [1.0, 1.0].into_iter().chain(x.into_iter().flat_map(state)).collect()
    }

    #[test]
    fn who_flies_straight_on_is_right() {
        assert_eq!(off_the_model(&run(), &run()), None);
        assert_eq!(other_bits(&run(), &run()), None);
    }

    #[test]
    fn a_wrong_step_is_named() {
        let mut wrong = run();
        wrong[10] += 1e-9;
        assert!(off_the_model(&run(), &wrong).unwrap().starts_with("step 2, particle 0"));
        assert!(other_bits(&run(), &wrong).unwrap().starts_with("step 2, particle 0: x is"));
    }

    #[test]
    fn a_run_from_elsewhere_is_wrong() {
        let moved: Vec<f64> =
            run().iter().enumerate().map(|(i, v)| if i % 4 == 2 { v + 0.1 } else { *v }).collect();
        assert!(off_the_model(&run(), &moved).unwrap().starts_with("step 1"));
    }

    #[test]
    fn half_a_run_is_no_run() {
        assert!(off_the_model(&run(), &run()[..10]).is_some());
        assert!(other_bits(&run(), &run()[..10]).is_some());
        assert!(other_bits(&run(), &[]).is_some());
    }
}
