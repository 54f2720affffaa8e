//! Free flight.

/// Advances free flyers by `steps` steps, with the very additions of step by step: one rounding
/// for each step, but one visit for all of them.
#[inline(always)]
pub fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64) {
    // task 11.1: free flight
    // Many side by side, in registers: of one alone each addition waits for the one before.
    const MANY: usize = 32;
    let (mut places, mut speeds) = (x.chunks_exact_mut(MANY), v.chunks_exact(MANY));
    for (x, v) in places.by_ref().zip(speeds.by_ref()) {
        let (mut now, mut displacements) = ([0.0; MANY], [0.0; MANY]);
        now.copy_from_slice(x);
        displacements.iter_mut().zip(v).for_each(|(displacement, v)| *displacement = v * dt);
        for _ in 0..steps {
            for l in 0..MANY {
                now[l] += displacements[l];
            }
        }
        x.copy_from_slice(&now);
    }
    for (x, v) in places.into_remainder().iter_mut().zip(speeds.remainder()) {
        for _ in 0..steps {
            *x += v * dt;
        }
    }
    // end 11.1
}
