//! Questions about particles that move and report their changes of bins.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

use common::Vec2;
use common::soft::{CUTOFF, DT, Particle};
use lab4::{Change, move_own};
use oracle::{Ask, Random, Table, integers};
use solution1::advance;
use solution2::Grid;

/// Particles that are about to move.
struct Case {
    grid: Grid,
    particles: Vec<Particle>,
    accelerations: Vec<Vec2>,
}

impl Case {
    /// Draws `n` particles, which do not begin with particle 0, in few or many bins.
    fn drawn(random: &mut Random, n: usize) -> Self {
        let along = [1 + random.size(40), 256, 300][random.below(3)];
        let size = along as f64 * CUTOFF;
        let first = random.size(70_000) as u32;
        let speed = random.magnitude(1.0, 100.0);
        let mut particle = |id: u32| {
            let [x, y] = [(); 2].map(|()| random.between(0.0, size));
            let [vx, vy] = [(); 2].map(|()| random.between(-speed, speed));
            Particle { x, y, vx, vy, id: first + id }
        };
        let particles: Vec<Particle> = (0..n as u32).map(&mut particle).collect();
        let numbers = particles.iter().map(|p| f64::from(p.id));
        let accelerations = numbers.map(|number| Vec2::new(number, -number)).collect();
        Self { grid: Grid::with_bins_along(size, along), particles, accelerations }
    }

    fn name(&self) -> String {
        let first = self.particles.first().map_or(0, |p| p.id);
        let n = self.particles.len();
        let along = self.grid.rows();
        format!("{n} particles in {along} rows of bins, with ids from {first} on")
    }

    /// Returns the particles after the move, and the changes of bins: particle, old bin, new bin.
    fn moved(&self) -> (Vec<Particle>, Vec<[usize; 3]>) {
        let mut particles = self.particles.clone();
        for (p, a) in particles.iter_mut().zip(&self.accelerations) {
            advance(p, *a, self.grid.size());
        }
        let bins =
            |p: &Particle, now: &Particle| [p.id as usize, self.grid.bin(p), self.grid.bin(now)];
        let all = self.particles.iter().zip(&particles).map(|(p, now)| bins(p, now));
        let changes = all.filter(|[_, from, to]| from != to).collect();
        (particles, changes)
    }

    /// Returns the number of particles that have changed their bin when the first change is
    /// reported.
    fn changed_at_first(&self) -> usize {
        let mut particles = self.particles.clone();
        // A panic at the first report stops the move.
        let first = AssertUnwindSafe(|| {
            let give_up = |_| resume_unwind(Box::new(()));
            move_own(&self.grid, &mut particles, &self.accelerations, give_up);
        });
        _ = catch_unwind(first);
        let bins = self.particles.iter().zip(&particles);
        bins.filter(|(p, now)| self.grid.bin(p) != self.grid.bin(now)).count()
    }
}

/// Returns x, y, vx, vy of each particle.
fn numbers(particles: &[Particle]) -> Vec<f64> {
    particles.iter().flat_map(|p| [p.x, p.y, p.vx, p.vy]).collect()
}

/// Asks for the move of any number of particles.
pub(crate) fn moves(random: &mut Random, ask: &mut impl Ask) {
    for n in [random.sizes(1025), random.sizes(1025)].concat() {
        let case = Case::drawn(random, n);
        let mut particles = case.particles.clone();
        let mut reported = Vec::new();
        move_own(&case.grid, &mut particles, &case.accelerations, |change| {
            reported.push([change.particle as usize, change.from, change.to]);
        });
        // The particles may move in any order.
        reported.sort_unstable();
        let name = case.name();
        let question = format!("{name}: x y vx vy of each particle");
        ask.exact(&question, || numbers(&particles), || numbers(&case.moved().0));
        let question = format!(
            "{name}: the particle, the old bin and the new bin of each change that is reported, in ascending order of \
             particles"
        );
        let right = || integers(case.moved().1.into_flattened());
        ask.exact(&question, || integers(reported.into_flattened()), right);
        let question = format!(
            "{name}: number of particles that have already changed their bins when the first change is reported"
        );
        let right = || integers([case.moved().1.len().min(1)]);
        ask.exact(&question, || integers([case.changed_at_first()]), right);
    }
}

/// Shows the worked example: five particles in four rows of bins of side 1.
pub(crate) fn table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let grid = Grid::with_bins_along(4.0, 4);
        // Displacements of the particles in a step, in sides of a bin.
        let flights = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 1.0), (0.25, 0.0)];
        let particle = |(id, (dx, dy)): (u32, (f64, f64))| {
            let vx = dx / DT;
            let vy = dy / DT;
            Particle { x: 1.5, y: 0.5 + f64::from(id % 2), vx, vy, id }
        };
        let before: Vec<Particle> = (0..).zip(flights).map(particle).collect();
        let mut particles = before.clone();
        let mut reported = vec![None; before.len()];
        let at_rest = vec![Vec2::ZERO; before.len()];
        move_own(&grid, &mut particles, &at_rest, |change: Change| {
            reported[change.particle as usize] = Some(change);
        });
        let mut table = Table::new(["particle", "x", "y", "x after", "y after", "reported change"]);
        for ((p, after), reported) in before.iter().zip(&particles).zip(reported) {
            let cell = reported.map_or("-".into(), |change| {
                format!("{} from bin {} to bin {}", change.particle, change.from, change.to)
            });
            let [x, y] = [after.x, after.y].map(|along| format!("{along:.2}"));
            table.row([&p.id, &p.x, &p.y, &x, &y, &cell]);
        }
        table.to_string()
    });
}
