//! Runs small groups of the same size, sixteen side by side.

use common::soft::CUTOFF;
use neighbour_list::Bodies;
use neighbour_list::kernels::{coefficient, larger};

use super::slots::{LANES, Slice};
use crate::span::Span;

/// Runs up to sixteen groups of `M` members through the steps of `span`, side by side and without a
/// branch.
///
/// The members are written to `out`: the first member of each group, then the second member of each
/// group, and so on. Returns whether all members stayed in the box. If one left the box, the result
/// is not valid.
///
/// Members are in the order of their ids. Every pair of a group is computed, to avoid a branch. A
/// pair that is not in contact adds zero to the accelerations, which changes no bit. If there are
/// fewer than sixteen groups, the last group is computed several times.
#[inline(always)]
pub(crate) fn run_together<const M: usize>(
    start: &Bodies,
    groups: &[[u32; M]],
    span: &Span,
    out: &mut Slice<'_>,
) -> bool {
    let [mut x, mut y, mut u, mut v] = [[[0.0; LANES]; M]; 4];
    for l in 0..LANES {
        let group = &groups[l.min(groups.len() - 1)];
        for m in 0..M {
            let i = group[m] as usize;
            x[m][l] = start.x[i];
            y[m][l] = start.y[i];
            u[m][l] = start.vx[i];
            v[m][l] = start.vy[i];
        }
    }
    let [x0, y0, u0, v0] = [x, y, u, v];
    let mut deviation = [[0.0; LANES]; M];
    let mut outside = [0_u64; LANES];
    let Span { steps, dt, size } = *span;
    for step in 1..=steps {
        let [mut ax, mut ay] = [[[0.0; LANES]; M]; 2];
        for a in 0..M {
            for b in a + 1..M {
                for l in 0..LANES {
                    let dx = x[b][l] - x[a][l];
                    let dy = y[b][l] - y[a][l];
                    let r2 = dx * dx + dy * dy;
                    let near = coefficient(r2);
                    let coef = if r2 <= CUTOFF * CUTOFF { near } else { 0.0 };
                    ax[a][l] += coef * dx;
                    ay[a][l] += coef * dy;
                    ax[b][l] -= coef * dx;
                    ay[b][l] -= coef * dy;
                }
            }
        }
        let time = f64::from(step) * dt;
        for m in 0..M {
            for l in 0..LANES {
                u[m][l] += ax[m][l] * dt;
                v[m][l] += ay[m][l] * dt;
                x[m][l] += u[m][l] * dt;
                y[m][l] += v[m][l] * dt;
                let inside =
                    (x[m][l] >= 0.0) & (y[m][l] >= 0.0) & (x[m][l] <= size) & (y[m][l] <= size);
                outside[l] |= u64::from(!inside);
            }
        }
        // The last step needs no record, because the next window searches again.
        for m in (0..M).filter(|_| step < steps) {
            let off = &mut out.off[((step as usize - 1) * M + m) * LANES..][..LANES];
            for l in 0..LANES {
                let dx = x[m][l] - (x0[m][l] + u0[m][l] * time);
                let dy = y[m][l] - (y0[m][l] + v0[m][l] * time);
                deviation[m][l] = larger(dx * dx + dy * dy, deviation[m][l]);
                off[l] = [dx as f32, dy as f32];
            }
        }
    }
    for m in 0..M {
        let lanes = m * LANES..(m + 1) * LANES;
        out.x[lanes.clone()].copy_from_slice(&x[m]);
        out.y[lanes.clone()].copy_from_slice(&y[m]);
        out.vx[lanes.clone()].copy_from_slice(&u[m]);
        out.vy[lanes.clone()].copy_from_slice(&v[m]);
        out.deviation[lanes].copy_from_slice(&deviation[m].map(f64::sqrt));
    }
    outside == [0; LANES]
}
