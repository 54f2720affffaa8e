//! Questions about a `Vec` for each bin, tasks 2.3 to 2.5.

use common::Vec2;
use common::soft::{CUTOFF, Particle};
use lab2::{Grid, VecBins, take_leavers};
use oracle::{Ask, Count, Near, Random, acceleration_of_pair, integers};

use super::particles::{Binned, binned, ids, in_any_order, inside, particles_of};

/// Asks for bins that are refilled repeatedly, with more particles and finally with fewer.
pub(crate) fn refills(random: &mut Random, ask: &mut impl Ask) {
    for (along, most) in [(1, 65_537), (2, 4097), (5, 257), (300, 1025)] {
        let mut bins = VecBins::new(Grid::with_bins_along(1.0, along));
        let often = (0..if along == 5 { 1000 } else { 1 }).map(|step| step % 40);
        for n in random.sizes(most).into_iter().chain(often).chain([2, 0, 1]) {
            refill(&mut bins, n, random, ask);
        }
    }
}

/// Asks for bins that are refilled with `n` particles, and then receive one more particle.
fn refill(bins: &mut VecBins, n: usize, random: &mut Random, ask: &mut impl Ask) {
    let along = bins.grid().rows();
    let all = binned(random, along, &(0..along), n + 1);
    let particles = particles_of(&all);
    let before: Vec<usize> = bins.bins().iter().map(Vec::capacity).collect();
    bins.refill(&particles[..n]);
    let question = format!(
        "{along} bins along a wall, filled again with {n} particles: number of bins that released their memory"
    );
    let poorer = bins.bins().iter().zip(&before).filter(|(bin, before)| bin.capacity() < **before);
    ask.exact(&question, || integers([poorer.count()]), || vec![0.0]);
    bins.put(particles[n]);
    let question = format!(
        "{along} bins along a wall, filled again with {n} particles. Then particle {n} is added: bin and id of each \
         particle, bin by bin"
    );
    let found = || {
        let filled = bins.bins().iter().enumerate();
        filled.flat_map(|(bin, inside)| in_bin(bin, in_any_order(ids(inside)))).collect()
    };
    ask.exact(&question, found, || {
        let mut all = all;
        all.sort_by_key(|one| one.bin);
        all.iter().flat_map(|one| in_bin(one.bin, ids([&one.particle]))).collect()
    });
}

/// Returns the bin and the number of each particle.
fn in_bin(bin: usize, ids: Vec<f64>) -> impl Iterator<Item = f64> {
    ids.into_iter().flat_map(move |id| [bin as f64, id])
}

/// Asks for the force on some of the particles. All particles outside the nine bins around the
/// particle are decoys within its reach, so a program that includes them finds a different force.
pub(crate) fn nine_bins(random: &mut Random, ask: &mut impl Ask) {
    for (along, most) in [(1, 1025), (2, 4097), (3, 1025), (7, 1025), (300, 257)] {
        for n in random.sizes(most).into_iter().filter(|&n| n > 0) {
            let crowd = Crowd::drawn(random, along, n);
            for _ in 0..4 {
                crowd.ask(crowd.all[random.below(n)], ask);
            }
        }
    }
}

/// Scales a coordinate to a box of side `side`.
fn scaled(x: f64, side: f64, on_the_wall: bool) -> f64 {
    if on_the_wall { side } else { x * side }
}

/// Particles in a box of bins a little wider than the cutoff.
struct Crowd {
    along: usize,
    side: f64,
    all: Vec<Binned>,
}

impl Crowd {
    /// Draws `n` particles. Some of the particles next to a far wall are on it.
    fn drawn(random: &mut Random, along: usize, n: usize) -> Self {
        let side = 1.02 * along as f64 * CUTOFF;
        let mut all = binned(random, along, &(0..along), n);
        for one in &mut all {
            let p = &mut one.particle;
            p.x = scaled(p.x, side, p.id % 3 == 0 && one.bin % along + 1 == along);
            p.y = scaled(p.y, side, p.id % 3 == 0 && one.bin / along + 1 == along);
        }
        Self { along, side, all }
    }

    /// Returns whether two bins are the same or touch.
    fn touch(&self, a: usize, b: usize) -> bool {
        let far_up = (a / self.along).abs_diff(b / self.along);
        let far_right = (a % self.along).abs_diff(b % self.along);
        far_up.max(far_right) <= 1
    }

    /// Returns bins in which `own` has all particles around it, and only decoys further away.
    fn bins(&self, own: Binned) -> VecBins {
        let p = own.particle;
        let mut bins = VecBins::new(Grid::with_bins_along(self.side, self.along));
        for one in &self.all {
            let decoy = Particle { x: p.x + 0.3 * CUTOFF, y: p.y - 0.4 * CUTOFF, ..one.particle };
            let is_near = self.touch(own.bin, one.bin);
            bins.bins_mut()[one.bin].push(if is_near { one.particle } else { decoy });
        }
        bins
    }

    fn ask(&self, own: Binned, ask: &mut impl Ask) {
        let p = own.particle;
        let bins = self.bins(own);
        let mut count = Count::default();
        let a = bins.acceleration(&p, &mut count);
        let name = format!(
            "{} particles in {} rows of bins with the side {:?}, particle {} at ({:?}, {:?})",
            self.all.len(),
            self.along,
            bins.grid().bin_side(),
            p.id,
            p.x,
            p.y
        );
        ask.near(
            &format!("{name}: acceleration of this particle, ax ay"),
            || vec![a.x, a.y],
            || self.acceleration(own),
        );
        let question = format!(
            "{name}: number of particles against which this particle was tested (`tested`), which are the particles in \
             the bins around it, including itself"
        );
        let looked_at = || integers([count.tested as usize]);
        ask.exact(&question, looked_at, || integers([self.around(own).count()]));
    }

    /// Returns the particles in the nine bins around `own`, including `own`.
    fn around(&self, own: Binned) -> impl Iterator<Item = &Binned> {
        self.all.iter().filter(move |one| self.touch(own.bin, one.bin))
    }

    fn acceleration(&self, own: Binned) -> Vec<Near> {
        let mut sum = Vec2::ZERO;
        let mut scale = 0.0;
        for one in self.around(own) {
            let d = own.particle.to(&one.particle);
            let a = acceleration_of_pair(d.x, d.y);
            sum += a;
            scale += a.norm_squared().sqrt();
        }
        [sum.x, sum.y].map(|right| Near { right, scale }).to_vec()
    }
}

/// Asks for the particles that leave a bin. Each particle has stayed, or has left its row, its
/// column, or both.
pub(crate) fn leavers(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..800 {
        let along = if case < 100 { 4 } else { [4, 300][case % 2] };
        let bin = random.below(along * along);
        // In the last case all particles leave.
        let n = match case {
            799 => 65_537,
            _ if case % 50 == 49 => random.size(4097),
            _ => random.size(12),
        };
        let now = (0..n).map(|id| moved(random, along, bin, id, case == 799)).collect();
        leave(along, bin, now, ask);
    }
}

/// Returns a particle of `bin` after a move.
fn moved(random: &mut Random, along: usize, bin: usize, id: usize, leaves: bool) -> Binned {
    let up = if leaves { 1 } else { random.below(2) * (1 + random.below(along - 1)) };
    let right = random.below(2) * (1 + random.below(along - 1));
    let row = (bin / along + up) % along;
    let column = (bin % along + right) % along;
    inside(random, along, row * along + column, id)
}

fn leave(along: usize, bin: usize, now: Vec<Binned>, ask: &mut impl Ask) {
    let grid = Grid::with_bins_along(1.0, along);
    let mut particles = particles_of(&now);
    let mut changed = vec![Particle { id: 99_999, ..Particle::default() }];
    take_leavers(&grid, bin, &mut particles, &mut changed);
    let mut name = format!(
        "bin {bin} in a grid of {along} rows. Its list contains {} particles, numbered from 0",
        now.len()
    );
    if now.len() < 12 {
        let bins: Vec<usize> = now.iter().map(|one| one.bin).collect();
        name += &format!(", which are in bins {bins:?} after a move");
    }
    let stay = || in_any_order(ids(&particles));
    ask.exact(&format!("{name}: particles that stay in the list"), stay, || {
        ids(now.iter().filter(|one| one.bin == bin).map(|one| &one.particle))
    });
    let question = format!("{name}: particles in `changed`, which contained particle 99999 before");
    ask.exact(
        &question,
        || in_any_order(ids(&changed)),
        || {
            let left = now.iter().filter(|one| one.bin != bin).map(|one| &one.particle);
            in_any_order([ids(left), vec![99_999.0]].concat())
        },
    );
}
