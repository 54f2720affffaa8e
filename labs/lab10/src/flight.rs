//! Running groups through a window.

use common::soft::{CUTOFF, Observer};
use solution1::bounce;

use crate::Bodies;
use crate::lanes::{coefficient, larger};
use crate::path::Span;
use crate::search::Pair;

/// Couples computed side by side.
pub(crate) const LANES: usize = 8;

/// Where the members of groups are after some steps, and how far they were pushed off their
/// reference paths in between.
#[derive(Clone, Default)]
pub(crate) struct After {
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
    pub(crate) vx: Vec<f64>,
    pub(crate) vy: Vec<f64>,
    pub(crate) bent: Vec<f64>,
}

/// The part of [`After`] that one piece of work writes.
pub(crate) struct Slice<'a> {
    pub(crate) x: &'a mut [f64],
    pub(crate) y: &'a mut [f64],
    pub(crate) vx: &'a mut [f64],
    pub(crate) vy: &'a mut [f64],
    pub(crate) bent: &'a mut [f64],
}

impl After {
    pub(crate) fn resize(&mut self, n: usize) {
        for array in [&mut self.x, &mut self.y, &mut self.vx, &mut self.vy, &mut self.bent] {
            array.resize(n, 0.0);
        }
    }

    /// Cuts all arrays from `first` on at `ends`, counted from there.
    pub(crate) fn cut(&mut self, first: usize, ends: &[usize]) -> Vec<Slice<'_>> {
        let cut = |array| crate::workers::cut(array, ends.iter().copied());
        cut(&mut self.x[first..])
            .into_iter()
            .zip(cut(&mut self.y[first..]))
            .zip(cut(&mut self.vx[first..]).into_iter().zip(cut(&mut self.vy[first..])))
            .zip(cut(&mut self.bent[first..]))
            .map(|(((x, y), (vx, vy)), bent)| Slice { x, y, vx, vy, bent })
            .collect()
    }
}

/// Runs eight couples through `steps` steps, side by side and without a branch, and writes their
/// members to `out` one couple after another. Brings back whether none of them left the box; if
/// one did, what is written is of no use.
///
/// Two particles of a couple are pushed equally, in opposite directions; so both are off their
/// free flight by the same distance. It adds up as a place and a velocity of its own.
#[inline(always)]
pub(crate) fn run_couples(
    start: &Bodies,
    couples: &[Pair; LANES],
    steps: u32,
    span: &Span,
    out: &mut Slice<'_>,
) -> bool {
    let take = |array: &[f64], side: usize| couples.map(|couple| array[couple[side] as usize]);
    let [mut xa, mut ya] = [take(&start.x, 0), take(&start.y, 0)];
    let [mut ua, mut va] = [take(&start.vx, 0), take(&start.vy, 0)];
    let [mut xb, mut yb] = [take(&start.x, 1), take(&start.y, 1)];
    let [mut ub, mut vb] = [take(&start.vx, 1), take(&start.vy, 1)];
    let [mut push_u, mut push_v, mut off_x, mut off_y, mut bent] = [[0.0; LANES]; 5];
    let mut outside = [false; LANES];
    let dt = span.dt;
    for step in 1..=steps {
        for l in 0..LANES {
            let (dx, dy) = (xb[l] - xa[l], yb[l] - ya[l]);
            let r2 = dx * dx + dy * dy;
            let near = coefficient(r2);
            let coef = if r2 <= CUTOFF * CUTOFF { near } else { 0.0 };
            let (pu, pv) = (coef * dx * dt, coef * dy * dt);
            ua[l] += pu;
            va[l] += pv;
            ub[l] -= pu;
            vb[l] -= pv;
            xa[l] += ua[l] * dt;
            ya[l] += va[l] * dt;
            xb[l] += ub[l] * dt;
            yb[l] += vb[l] * dt;
            let inside = (xa[l] >= 0.0)
                & (ya[l] >= 0.0)
                & (xb[l] >= 0.0)
                & (yb[l] >= 0.0)
                & (xa[l] <= span.size)
                & (ya[l] <= span.size)
                & (xb[l] <= span.size)
                & (yb[l] <= span.size);
            outside[l] |= !inside;
            push_u[l] += pu;
            push_v[l] += pv;
            off_x[l] += push_u[l] * dt;
            off_y[l] += push_v[l] * dt;
            // Where a window ends, the next one looks for itself.
            let off = if step < steps { off_x[l] * off_x[l] + off_y[l] * off_y[l] } else { 0.0 };
            bent[l] = larger(off, bent[l]);
        }
    }
    for l in 0..LANES {
        (out.x[2 * l], out.x[2 * l + 1]) = (xa[l], xb[l]);
        (out.y[2 * l], out.y[2 * l + 1]) = (ya[l], yb[l]);
        (out.vx[2 * l], out.vx[2 * l + 1]) = (ua[l], ub[l]);
        (out.vy[2 * l], out.vy[2 * l + 1]) = (va[l], vb[l]);
        let bent = bent[l].sqrt();
        (out.bent[2 * l], out.bent[2 * l + 1]) = (bent, bent);
    }
    outside == [false; LANES]
}

/// What running a group needs for itself.
#[derive(Default)]
pub(crate) struct Room {
    ax: Vec<f64>,
    ay: Vec<f64>,
}

/// Runs one group of any size through `steps` steps, with its walls, and writes its members to
/// `out`. `members` are places in the sorted order by ascending id, `pairs` are numbers in
/// `members`, ascending: then every particle sums its neighbours by ascending id, as all pairs do,
/// and the bits are theirs. `observers`, if any, see one step each.
#[expect(clippy::too_many_arguments, reason = "a window is wide")]
pub(crate) fn run_group<O: Observer>(
    start: &Bodies,
    members: &[u32],
    pairs: &[Pair],
    steps: u32,
    span: &Span,
    room: &mut Room,
    observers: &mut [O],
    out: &mut Slice<'_>,
) {
    let (n, dt) = (members.len(), span.dt);
    for (k, &i) in members.iter().enumerate() {
        let i = i as usize;
        (out.x[k], out.y[k], out.vx[k], out.vy[k]) =
            (start.x[i], start.y[i], start.vx[i], start.vy[i]);
        out.bent[k] = 0.0;
    }
    room.ax.resize(n.max(room.ax.len()), 0.0);
    room.ay.resize(n.max(room.ay.len()), 0.0);
    for step in 1..=steps {
        room.ax[..n].fill(0.0);
        room.ay[..n].fill(0.0);
        let mut observer = observers.get_mut(step as usize - 1);
        for &[a, b] in pairs {
            let [a, b] = [a as usize, b as usize];
            let (dx, dy) = (out.x[b] - out.x[a], out.y[b] - out.y[a]);
            let r2 = dx * dx + dy * dy;
            if r2 <= CUTOFF * CUTOFF {
                let coef = coefficient(r2);
                room.ax[a] += coef * dx;
                room.ay[a] += coef * dy;
                room.ax[b] -= coef * dx;
                room.ay[b] -= coef * dy;
                if let Some(observer) = &mut observer {
                    observer.seen(r2);
                    observer.seen(r2);
                }
            }
        }
        if let Some(observer) = &mut observer {
            observer.tested(pairs.len() as u64);
        }
        let time = f64::from(step) * dt;
        for (k, &member) in members.iter().enumerate() {
            out.vx[k] += room.ax[k] * dt;
            out.vy[k] += room.ay[k] * dt;
            (out.x[k], out.vx[k]) = bounce(out.x[k] + out.vx[k] * dt, out.vx[k], span.size);
            (out.y[k], out.vy[k]) = bounce(out.y[k] + out.vy[k] * dt, out.vy[k], span.size);
            if step < steps {
                let p = start.get(member as usize);
                let still = span.meets_wall(p.x, p.y, p.vx, p.vy);
                let (wx, wy) = if still { (0.0, 0.0) } else { (p.vx, p.vy) };
                let (dx, dy) = (out.x[k] - (p.x + wx * time), out.y[k] - (p.y + wy * time));
                out.bent[k] = out.bent[k].max((dx * dx + dy * dy).sqrt());
            }
        }
    }
}

/// Advances free flyers by `steps` steps, with the very additions of step by step: one rounding
/// for each step, but one visit for all of them.
#[inline(always)]
pub fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64) {
    todo!("task 10.7: free flight")
}

impl Slice<'_> {
    /// A part of the slice.
    pub(crate) fn part(&mut self, range: std::ops::Range<usize>) -> Slice<'_> {
        Slice {
            x: &mut self.x[range.clone()],
            y: &mut self.y[range.clone()],
            vx: &mut self.vx[range.clone()],
            vy: &mut self.vy[range.clone()],
            bent: &mut self.bent[range],
        }
    }
}
