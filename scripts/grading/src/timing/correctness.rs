//! Checks whether the result of a timed run is right.

/// Share of the particles that may differ by more than [`CLOSE`] after the timed steps.
///
/// Two programs differ by rounding, and chaos enlarges the difference. A program that skips a step
/// moves all particles.
pub(crate) const STRAY: f64 = 0.001;
/// Difference of two numbers that rounding can explain.
const CLOSE: f64 = 1e-9;

/// Describes the difference between two states; `None` if they agree.
///
/// They agree if at most the share `stray` of the particles differs by more than rounding.
pub(crate) fn difference(right: &[f64], given: &[f64], stray: f64) -> Option<String> {
    if right.len() != given.len() {
        return Some(format!("{} particles came back, not {}", given.len() / 4, right.len() / 4));
    }
    let pairs = right.chunks(4).zip(given.chunks(4)).enumerate();
    let strays: Vec<_> = pairs.filter(|(_, (want, got))| !are_close(want, got)).collect();
    let (number, (want, got)) = strays.first()?;
    let allowed = stray * (right.len() / 4) as f64;
    (strays.len() as f64 > allowed).then(|| {
        format!(
            "after the steps {} of {} particles are not where they should be; particle \
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

fn are_close(wanted: &[f64], given: &[f64]) -> bool {
    wanted.iter().zip(given).all(|(want, got)| (want - got).abs() <= CLOSE * (1.0 + want.abs()))
}

/// Whether a program has exactly the serial program's result, although the solution's result
/// differs.
///
/// If so, it is the serial program, or a parallel program of a different lab that sums in the
/// serial order.
pub(crate) fn is_another(own: &[f64], serial: &[f64], solution: &[f64]) -> bool {
    same_bits(own, serial) && !same_bits(solution, serial)
}

fn same_bits(a: &[f64], b: &[f64]) -> bool {
    a.iter().map(|x| x.to_bits()).eq(b.iter().map(|x| x.to_bits()))
}

#[cfg(test)]
mod tests {
    use super::{STRAY, difference, is_another};

    #[test]
    fn rounding_is_no_difference_and_a_step_left_out_is() {
        let right: Vec<f64> = (0..4000).map(|i| f64::from(i) * 1e-3).collect();
        let mut given: Vec<f64> = right.iter().map(|x| x + 1e-13).collect();
        assert_eq!(difference(&right, &given, STRAY), None);
        // Chaos may explain one wrong particle in a thousand, but not two.
        given[8] += 1.0;
        assert_eq!(difference(&right, &given, STRAY), None);
        assert!(difference(&right, &given, 0.0).is_some(), "chaos needs many steps");
        given[12] = f64::NAN;
        let message = difference(&right, &given, STRAY).unwrap();
        assert!(
            message.contains("2 of 1000 particles") && message.contains("particle 2"),
            "{message}"
        );
        assert!(difference(&right, &right[..8], STRAY).unwrap().contains("2 particles came back"));
    }

    #[test]
    fn who_sums_as_another_program_is_that_program() {
        let serial = [0.25, 0.5];
        let solution = [0.25, 0.5_f64.next_up()];
        assert!(is_another(&serial, &serial, &solution));
        assert!(!is_another(&[0.25_f64.next_up(), 0.5], &serial, &solution));
        assert!(!is_another(&serial, &serial, &serial), "the solution sums so too");
    }
}
