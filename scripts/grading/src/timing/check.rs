//! Whether a timed run did what it should: its result, and the processors that it took.

use crate::record::Run;

/// Two programs differ by rounding, and chaos makes more of it: this share of the particles may
/// differ by more than [`CLOSE`] after the steps. Whoever leaves out a step moves all of them.
const STRAY: f64 = 0.001;
const CLOSE: f64 = 1e-9;

/// What is wrong with a state; none if it is the right one up to rounding.
pub(crate) fn difference(right: &[f64], given: &[f64]) -> Option<String> {
    if right.len() != given.len() {
        return Some(format!("{} particles came back, not {}", given.len() / 4, right.len() / 4));
    }
    let close = |(want, got): (&f64, &f64)| (want - got).abs() <= CLOSE * (1.0 + want.abs());
    let pairs = right.chunks(4).zip(given.chunks(4)).enumerate();
    let strays: Vec<_> =
        pairs.filter(|(_, (want, got))| !want.iter().zip(got.iter()).all(close)).collect();
    let (number, (want, got)) = strays.first()?;
    let allowed = STRAY * (right.len() / 4) as f64;
    (strays.len() as f64 > allowed.max(1.0)).then(|| {
        format!(
            "after the timed steps {} of {} particles are not where they should be; particle \
             {number} is at ({:e}, {:e}), not at ({:e}, {:e})",
            strays.len(),
            right.len() / 4,
            got[0],
            got[1],
            want[0],
            want[1]
        )
    })
}

/// A program that found its way to more processors than it was given. The system counts time in
/// hundredths of a second, for each process.
pub(crate) fn too_many_processors(run: &Run) -> Option<String> {
    let wall: f64 = run.seconds.iter().sum();
    let slack = 0.03 * run.seconds.len() as f64;
    let busy = run.processors?;
    (busy > 1.1 * run.workers as f64 * wall + slack).then(|| {
        format!("it kept {:.1} processors busy where it was given {}", busy / wall, run.workers)
    })
}

#[cfg(test)]
mod tests {
    use super::{difference, too_many_processors};
    use crate::record::{Outcome, Run, Whose};

    #[test]
    fn rounding_is_no_difference_and_a_step_left_out_is() {
        let right: Vec<f64> = (0..4000).map(|i| f64::from(i) * 1e-3).collect();
        let mut given: Vec<f64> = right.iter().map(|x| x + 1e-13).collect();
        assert_eq!(difference(&right, &given), None);
        // One particle of a thousand may have met chaos; two may not.
        given[8] += 1.0;
        assert_eq!(difference(&right, &given), None);
        given[12] = f64::NAN;
        let message = difference(&right, &given).unwrap();
        assert!(
            message.contains("2 of 1000 particles") && message.contains("particle 2"),
            "{message}"
        );
        assert!(difference(&right, &right[..8]).unwrap().contains("2 particles came back"));
    }

    #[test]
    fn nobody_takes_more_processors_than_it_was_given() {
        let mut run = Run {
            whose: Whose::Own,
            variant: String::new(),
            n: 1000,
            workers: 1,
            steps: 50,
            seconds: vec![1.0; 5],
            processors: Some(5.3),
            outcome: Outcome::Timed,
            message: String::new(),
            counted: Default::default(),
        };
        assert_eq!(too_many_processors(&run), None);
        run.processors = Some(9.0);
        assert!(too_many_processors(&run).unwrap().contains("1.8 processors"));
        run.workers = 2;
        assert_eq!(too_many_processors(&run), None);
    }
}
