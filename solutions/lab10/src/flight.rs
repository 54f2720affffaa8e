//! Flying freely, and running one group through a window.

use common::soft::{CUTOFF, Observer};
use solution1::bounce;

use crate::Bodies;
use crate::lanes::coefficient;
use crate::path::{Path, Span};
use crate::record::Slice;
use crate::search::Pair;

/// What running a group needs for itself.
#[derive(Default)]
pub(crate) struct Room {
    ax: Vec<f64>,
    ay: Vec<f64>,
    paths: Vec<Path>,
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
    room.paths.clear();
    for (k, &i) in members.iter().enumerate() {
        let p = start.get(i as usize);
        (out.x[k], out.y[k], out.vx[k], out.vy[k]) = (p.x, p.y, p.vx, p.vy);
        out.bent[k] = 0.0;
        room.paths.push(span.path(&p));
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
        for (k, path) in room.paths.iter().enumerate() {
            out.vx[k] += room.ax[k] * dt;
            out.vy[k] += room.ay[k] * dt;
            (out.x[k], out.vx[k]) = bounce(out.x[k] + out.vx[k] * dt, out.vx[k], span.size);
            (out.y[k], out.vy[k]) = bounce(out.y[k] + out.vy[k] * dt, out.vy[k], span.size);
            if step < steps {
                let dx = out.x[k] - (path.x + path.wx * time);
                let dy = out.y[k] - (path.y + path.wy * time);
                let beyond = (dx * dx + dy * dy).sqrt() - path.spread;
                out.bent[k] = out.bent[k].max(beyond);
                let place = (step as usize - 1) * n + k;
                (out.off_x[place], out.off_y[place]) = (dx as f32, dy as f32);
            }
        }
    }
}

/// Advances free flyers by `steps` steps, with the very additions of step by step: one rounding
/// for each step, but one visit for all of them.
#[inline(always)]
pub fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64) {
    // task 10.7: free flight
    // Many side by side, in registers: of one alone each addition waits for the one before.
    const MANY: usize = 32;
    let (mut places, mut speeds) = (x.chunks_exact_mut(MANY), v.chunks_exact(MANY));
    for (x, v) in places.by_ref().zip(speeds.by_ref()) {
        let (mut now, mut ways) = ([0.0; MANY], [0.0; MANY]);
        now.copy_from_slice(x);
        ways.iter_mut().zip(v).for_each(|(way, v)| *way = v * dt);
        for _ in 0..steps {
            for l in 0..MANY {
                now[l] += ways[l];
            }
        }
        x.copy_from_slice(&now);
    }
    for (x, v) in places.into_remainder().iter_mut().zip(speeds.remainder()) {
        for _ in 0..steps {
            *x += v * dt;
        }
    }
    // end 10.7
}
