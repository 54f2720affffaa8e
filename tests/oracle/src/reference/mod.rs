//! Soft discs as exactly as double precision allows: the motion without the error of a time step.
//!
//! The motion is not smooth at two kinds of moments: when a pair crosses the cutoff, and when a
//! wall reflects a particle. A method of high order loses its order in every step that contains
//! such a moment. So each such moment is located, and a step ends there. Between these moments the
//! motion is smooth, and [extrapolation] follows it up to rounding.
//!
//! The motion is computed in short windows of time. A particle that cannot touch another within a
//! window flies freely. All other particles form groups, and each group is followed alone.

mod event;
mod extrapolation;
mod group;

use common::Vec2;
use common::soft::{CUTOFF, Particle, Scene};

use crate::fold;
use group::Group;

/// Accuracy of the reference.
#[derive(Clone, Copy, Debug)]
pub struct Fineness {
    /// Greatest duration of a window. No step is longer than its window.
    pub window: f64,
    /// Allowed error of a step.
    pub tolerance: f64,
}

impl Fineness {
    /// Accuracy of the kit's tables.
    pub const FINE: Self = Self { window: 2e-4, tolerance: 1e-16 };
    /// Accuracy with longer windows, different steps and a looser tolerance. The difference from
    /// the results with [`Self::FINE`] is an estimate of the greater of the two errors.
    pub const CHECK: Self = Self { window: 3.1e-4, tolerance: 1e-15 };
}

/// Moves the particles of a scene exactly for `time`, and returns them in id order.
///
/// # Errors
/// If a pair came closer than the model's least distance, below which the motion is not smooth. The
/// error names the pair.
pub fn exact(scene: &Scene, time: f64, fineness: Fineness) -> Result<Vec<Particle>, String> {
    let mut particles = scene.particles().to_vec();
    let windows = (time / fineness.window).ceil().max(1.0);
    let length = time / windows;
    for _ in 0..windows as u64 {
        window(&mut particles, scene.size(), length, fineness.tolerance)?;
    }
    Ok(particles)
}

fn window(
    particles: &mut [Particle],
    size: f64,
    length: f64,
    tolerance: f64,
) -> Result<(), String> {
    // The loop below computes the window again if a particle exceeds the allowed speed.
    let speeds: Vec<f64> = particles.iter().map(|p| p.vx.hypot(p.vy)).collect();
    let mut allowed = 1.25 * speeds.iter().copied().fold(0.0, f64::max) + 0.1;
    loop {
        let reach = CUTOFF + 2.0 * allowed * length;
        let mut next = particles.to_vec();
        let mut fastest: f64 = 0.0;
        for members in groups(particles, reach) {
            if let [alone] = members[..] {
                let p = &mut next[alone];
                (p.x, p.vx) = fold(p.x + p.vx * length, p.vx, size);
                (p.y, p.vy) = fold(p.y + p.vy * length, p.vy, size);
                continue;
            }
            let mut group = Group::new(members.iter().map(|&i| particles[i]), size);
            fastest = fastest.max(group.advance(length, tolerance)?);
            for (&i, (at, v)) in members.iter().zip(group.particles()) {
                let Vec2 { x, y } = at;
                next[i] = Particle { x, y, vx: v.x, vy: v.y, id: particles[i].id };
            }
        }
        if fastest <= allowed {
            particles.copy_from_slice(&next);
            return Ok(());
        }
        allowed = 1.5 * fastest;
    }
}

/// Returns the groups of particles linked by pairs within `reach`, each in ascending order.
fn groups(particles: &[Particle], reach: f64) -> Vec<Vec<usize>> {
    let mut order: Vec<usize> = (0..particles.len()).collect();
    order.sort_by(|&a, &b| particles[a].x.total_cmp(&particles[b].x));
    let mut parent: Vec<usize> = (0..particles.len()).collect();
    fn find(parent: &mut [usize], mut i: usize) -> usize {
        while parent[i] != i {
            parent[i] = parent[parent[i]];
            i = parent[i];
        }
        i
    }
    for (k, &a) in order.iter().enumerate() {
        for &b in &order[k + 1..] {
            let d = particles[a].to(&particles[b]);
            if d.x > reach {
                break;
            }
            if d.norm_squared() <= reach * reach {
                let (a, b) = (find(&mut parent, a), find(&mut parent, b));
                parent[a.max(b)] = a.min(b);
            }
        }
    }
    let mut groups: Vec<Vec<usize>> = vec![Vec::new(); particles.len()];
    for i in 0..particles.len() {
        groups[find(&mut parent, i)].push(i);
    }
    groups.retain(|group| !group.is_empty());
    groups
}

#[cfg(test)]
mod tests;
