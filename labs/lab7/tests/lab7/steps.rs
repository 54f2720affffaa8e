//! Questions about one window of a step, and about whole steps that a test's finder divides into
//! windows: task 7.7.

use common::hard::{Disc, Scene, Simulation};
use hard_discs::{Candidate, Choice, Engine, Find, Found, Hit, Square, Window, Workers};
use lab7::{Lab7, collide_in, pair_hit};
use oracle::hard::{What, follow, scenes, state, step};
use oracle::{Ask, Random, beside, integers};

use super::words::hit;

/// A finder that tests all pairs of free discs, and divides a step into a fixed number of windows.
struct Finder {
    windows: usize,
    /// Number of times that the engine has asked for the number of windows.
    cuts: usize,
    /// Begin and end of each requested window, and the number of free discs in it.
    asked: Vec<[f64; 3]>,
}

impl Find for &mut Finder {
    fn windows(&mut self, _: &[Disc], _: Square) -> usize {
        self.cuts += 1;
        self.windows
    }

    fn find(
        &mut self,
        discs: &[Disc],
        free: &[bool],
        square: Square,
        window: Window,
        found: &mut Found,
    ) {
        let count = free.iter().filter(|free| **free).count();
        self.asked.push([window.from, window.to.min(9.0), count as f64]);
        found.clear(1);
        for b in 0..discs.len() as u32 {
            for a in (0..b).filter(|a| free[*a as usize] && free[b as usize]) {
                let hit = pair_hit(discs, a, b, square.radius);
                found.lists[0].extend(hit.filter(|hit| window.contains(hit.time)));
            }
        }
    }
}

/// Record of an engine's steps, in several windows each.
struct Done {
    /// States after each step.
    states: Vec<f64>,
    /// Number of times that the engine has asked for the number of windows, in all steps.
    cuts: usize,
    /// Windows that the engine requested in all steps.
    asked: Vec<[f64; 3]>,
    /// Obstacles and discs of the collisions in the last step, in order.
    hits: Vec<[f64; 3]>,
}

fn run(scene: &Scene, windows: usize, steps: usize) -> Done {
    let mut finder = Finder { windows, cuts: 0, asked: Vec::new() };
    let mut engine = Engine::<Lab7, _>::new(&mut finder, Choice::Sort, Workers::One);
    engine.load(scene);
    let mut states = Vec::new();
    for _ in 0..steps {
        engine.step();
        states.extend(engine.discs.iter().flat_map(state));
    }
    let hits = engine.taken.iter().map(|taken| hit(taken.hit)).collect();
    drop(engine);
    Done { states, cuts: finder.cuts, asked: finder.asked, hits }
}

/// Asks for several steps of a lone disc, and of two discs that meet far from all walls. The
/// collisions of one step must not affect the next.
pub(crate) fn several_steps(random: &mut Random, ask: &mut impl Ask) {
    let speed = random.between(2.5, 3.5);
    let alone = vec![Disc::new(4.0, 5.0, speed, 0.5)];
    let two = vec![Disc::new(495.0, 500.0, speed, 0.5), Disc::new(505.0, 500.5, -speed, 0.5)];
    for (name, side, discs) in [
        (
            format!("a disc that is alone in a square of side 10, with velocity ({speed:?}, 0.5)"),
            10.0,
            alone,
        ),
        (format!("two discs that meet in a square of side 1000, at {speed:?} each"), 1000.0, two),
    ] {
        let scene = Scene::new(side, 1.0, discs).expect("all discs are inside the square");
        for windows in [1, 2] {
            let question = format!(
                "{name}, 8 steps in {windows} windows each: for each disc, x y vx vy and its numbers of collisions \
                 with discs and with walls, after each step"
            );
            let found = || run(&scene, windows, 8).states;
            ask.judge(&question, found, |found| follow(&scene, found, 8));
        }
    }
}

/// Returns the windows of a step divided into `windows`, and the number of free discs at the start
/// of each.
fn right_windows(scene: &Scene, windows: usize) -> Vec<f64> {
    let (_, events) = step(scene.discs(), scene.side(), scene.radius());
    let mut right = Vec::new();
    for window in (0..windows).map(|k| Window::part(k, windows)) {
        let before = events.iter().filter(|event| event.time < window.from);
        let gone = before.map(|event| if let What::Disc(_) = event.what { 2 } else { 1 });
        let free = scene.len() - gone.sum::<usize>();
        right.extend([window.from, window.to.min(9.0), free as f64]);
    }
    right
}

/// Returns the obstacles and discs of the collisions in a step, in order.
fn right_hits(scene: &Scene) -> Vec<f64> {
    let (_, events) = step(scene.discs(), scene.side(), scene.radius());
    let numbers = events.iter().map(|event| {
        let (what, other) = match event.what {
            What::Corner => (0.0, -1.0),
            What::WallX => (1.0, -1.0),
            What::WallY => (2.0, -1.0),
            What::Disc(other) => (3.0, other as f64),
        };
        [what, event.disc as f64, other]
    });
    numbers.flatten().collect()
}

/// Asks about a step in several windows: the requests to the finder, the collisions, and the final
/// states.
pub(crate) fn steps_in_windows(_: &mut Random, ask: &mut impl Ask) {
    for seed in 0..20 {
        let scene = [scenes::lattice(seed), scenes::unseen(seed)][seed as usize % 2].clone();
        let windows = [1, 2, 3, 8, 64][seed as usize % 5];
        let name = format!("scene {seed} of {} discs, a step in {windows} windows", scene.len());
        let done = run(&scene, windows, 1);
        ask.exact(
            &format!("{name}: number of times that the finder is asked for the number of windows"),
            || integers([done.cuts]),
            || integers([1]),
        );
        ask.exact(
            &format!(
                "{name}: start and end of each window for which the finder is called (9 for the end of the step), and \
                 number of free discs at that moment"
            ),
            || done.asked.concat(),
            || right_windows(&scene, windows),
        );
        ask.exact(
            &format!(
                "{name}: kind (0 a corner, 1 an x wall, 2 a y wall, 3 a pair) and both discs (-1 for none) of each \
                 collision, in order"
            ),
            || done.hits.concat(),
            || right_hits(&scene),
        );
        let question = format!(
            "{name}: for each disc, x y vx vy and its numbers of collisions with discs and with walls"
        );
        ask.judge(&question, || done.states, |found| follow(&scene, found, 1));
    }
}

/// A finder that finds one pair in every window and replaces the lists, as finders with several
/// workers do.
struct OnePair;

impl Find for OnePair {
    fn find(&mut self, _: &[Disc], _: &[bool], _: Square, window: Window, found: &mut Found) {
        let time = window.from;
        found.lists = vec![vec![Candidate { time, hit: Hit::Pair(0, 1) }]];
    }
}

/// Discs that hit walls at given times, in ascending order, and one of several windows.
struct Walls {
    times: Vec<f64>,
    k: usize,
    count: usize,
}

impl Walls {
    /// Draws times at the start and end of windows, at the neighbouring numbers, and at the end of
    /// the step.
    fn drawn(random: &mut Random, case: usize) -> Self {
        let count = [1, 2, 3, 8, 64][case % 5];
        let mut edge = || beside(random.below(count + 1) as f64 / count as f64)[random.below(3)];
        let mut times = vec![edge().clamp(0.0, 1.0)];
        times.extend((0..case).map(|_| edge().clamp(0.0, 1.0)));
        times.sort_by(f64::total_cmp);
        Self { times, k: random.below(count), count }
    }

    /// Returns the number of wall collisions before a time.
    fn before(&self, time: f64) -> usize {
        self.times.partition_point(|&wall| wall < time)
    }

    /// Returns the number of the disc that hits a wall. These numbers start at 2.
    fn disc(wall: usize) -> u32 {
        wall as u32 + 2
    }

    /// Returns the first wall of a later window, and the first discs of the collisions in this
    /// window.
    fn taken(&self) -> Vec<f64> {
        let mut engine = Engine::<Lab7, _>::new(OnePair, Choice::Sort, Workers::One);
        let discs = vec![Disc::new(5.0, 5.0, 0.0, 0.0); self.times.len() + 2];
        engine.load(&Scene::new(10.0, 1.0, discs).expect("all discs are inside the square"));
        let walls = self.times.iter().enumerate();
        engine.walls = walls
            .map(|(wall, &time)| Candidate { time, hit: Hit::WallX(Self::disc(wall)) })
            .collect();
        let window = Window::part(self.k, self.count);
        let next = collide_in(&mut engine, window, self.before(window.from));
        let mut discs: Vec<u32> = engine.taken.iter().map(|c| c.hit.first()).collect();
        discs.sort_unstable();
        [next as f64].into_iter().chain(discs.into_iter().map(f64::from)).collect()
    }

    /// Returns the correct answer: the wall collisions of the window, and the pair.
    fn right(&self) -> Vec<f64> {
        let window = Window::part(self.k, self.count);
        let walls = self.before(window.from)..self.before(window.to);
        let discs = walls.clone().map(|wall| f64::from(Self::disc(wall)));
        [walls.end as f64, 0.0].into_iter().chain(discs).collect()
    }
}

/// Asks for the collisions of a window, one of one or several: its walls, and the pair that the
/// finder finds.
pub(crate) fn windows(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..300 {
        let walls = Walls::drawn(random, case);
        let question = format!(
            "discs 2 to {} hit walls at λ = {:?}. Discs 0 and 1 touch in window {} of {}, counted from 0: (1) index \
             of the first wall collision of a later window, (2) the first disc of each collision taken, in ascending \
             order",
            walls.times.len() + 1,
            walls.times,
            walls.k,
            walls.count
        );
        ask.exact(&question, || walls.taken(), || walls.right());
    }
}
