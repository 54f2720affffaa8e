//! A step of very high order: Störmer's rule, extrapolated to substeps of length zero.
//!
//! Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, section II.14. The rule
//! works with displacements, not with positions, so that rounding errors are relative to the
//! distance that a particle moved.

use common::Vec2;

/// Number of columns of the extrapolation; the order is twice as high.
const COLUMNS: usize = 9;

/// Positions and velocities of particles.
#[derive(Clone, Debug, Default)]
pub(super) struct State {
    pub(super) at: Vec<Vec2>,
    pub(super) v: Vec<Vec2>,
}

/// Advances `start` by `h` under accelerations that `field` computes from positions. Returns the
/// end and an estimate of the greatest error of a coordinate.
pub(super) fn step(start: &State, h: f64, field: &impl Fn(&[Vec2], &mut [Vec2])) -> (State, f64) {
    let n = start.at.len();
    let mut first = vec![Vec2::ZERO; n];
    field(&start.at, &mut first);
    // The last row of the extrapolation table: displacements, then changes of velocity × h.
    let mut table: Vec<Vec<Vec2>> = Vec::new();
    let mut error = f64::INFINITY;
    for column in 1..=COLUMNS {
        let mut above = rule(start, h, column, &first, field);
        for (back, old) in table.iter_mut().rev().enumerate() {
            let ratio = column as f64 / (column - 1 - back) as f64;
            let weight = 1.0 / (ratio * ratio - 1.0);
            let next: Vec<_> =
                above.iter().zip(&*old).map(|(&a, &o)| a + weight * (a - o)).collect();
            *old = std::mem::replace(&mut above, next);
        }
        // The table keeps one row, the newest entry of each column of the tableau.
        if let Some(last) = table.first() {
            error = above
                .iter()
                .zip(last)
                .map(|(a, b)| (a.x - b.x).abs().max((a.y - b.y).abs()))
                .fold(0.0, f64::max);
        }
        table.insert(0, above);
        if error < 1e-19 {
            break;
        }
    }
    let best = &table[0];
    let mut end = start.clone();
    for i in 0..n {
        end.at[i] = start.at[i] + best[i];
        end.v[i] = start.v[i] + (1.0 / h) * best[n + i];
    }
    (end, error)
}

/// Applies Störmer's rule with `substeps` substeps. Returns displacements, then changes of velocity
/// × h.
fn rule(
    start: &State,
    h: f64,
    substeps: usize,
    first: &[Vec2],
    field: &impl Fn(&[Vec2], &mut [Vec2]),
) -> Vec<Vec2> {
    let n = start.at.len();
    let part = h / substeps as f64;
    // `kick` is the difference between a substep's displacement and the displacement in free
    // flight.
    let mut kick: Vec<Vec2> = first.iter().map(|&a| (0.5 * part * part) * a).collect();
    let mut bend = kick.clone();
    let mut at = start.at.clone();
    let mut force = vec![Vec2::ZERO; n];
    for done in 1..=substeps {
        for i in 0..n {
            at[i] = start.at[i] + ((part * done as f64) * start.v[i] + bend[i]);
        }
        field(&at, &mut force);
        if done < substeps {
            for i in 0..n {
                kick[i] += (part * part) * force[i];
                let more = kick[i];
                bend[i] += more;
            }
        }
    }
    let displacement = (0..n).map(|i| h * start.v[i] + bend[i]);
    let change = (0..n).map(|i| h * ((1.0 / part) * kick[i] + (0.5 * part) * force[i]));
    displacement.chain(change).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_oscillator_returns() {
        let field = |at: &[Vec2], a: &mut [Vec2]| a[0] = -at[0];
        let mut state = State { at: vec![Vec2::new(1.0, 0.0)], v: vec![Vec2::new(0.0, 1.0)] };
        let h = std::f64::consts::TAU / 16.0;
        for _ in 0..16 {
            let (next, error) = step(&state, h, &field);
            assert!(error < 1e-11, "{error}");
            state = next;
        }
        assert!((state.at[0].x - 1.0).abs() < 1e-13, "{state:?}");
        assert!(state.at[0].y.abs() < 1e-13, "{state:?}");
        assert!((state.v[0].y - 1.0).abs() < 1e-13, "{state:?}");
    }
}
