//! Questions about one window of a step: task 7.7.

use common::hard::{Disc, Scene, Simulation};
use hard_discs::{Candidate, Choice, Engine, Find, Found, Hit, Square, Window, Workers};
use lab7::{Lab7, collide_in};
use oracle::{Ask, Random, beside};

/// Finds one pair, whatever the window, and replaces the lists, as finders with several workers do.
struct OnePair;

impl Find for OnePair {
    fn find(&mut self, _: &[Disc], _: &[bool], _: Square, window: Window, found: &mut Found) {
        let time = window.from;
        found.lists = vec![vec![Candidate { time, hit: Hit::Pair(0, 1) }]];
    }
}

/// Discs that hit walls at these times, in ascending order, and a window among several.
struct Walls {
    times: Vec<f64>,
    k: usize,
    count: usize,
}

impl Walls {
    /// At the beginning of windows, at their end, at the neighbours of these, and at the end of the step.
    fn drawn(random: &mut Random, case: usize) -> Self {
        let count = [1, 2, 3, 8, 64][case % 5];
        let mut edge = || beside(random.below(count + 1) as f64 / count as f64)[random.below(3)];
        let mut times = vec![edge().clamp(0.0, 1.0)];
        times.extend((0..case).map(|_| edge().clamp(0.0, 1.0)));
        times.sort_by(f64::total_cmp);
        Self { times, k: random.below(count), count }
    }

    /// How many walls are hit before a time.
    fn before(&self, time: f64) -> usize {
        self.times.partition_point(|&wall| wall < time)
    }

    /// The discs that hit the walls have the numbers from 2 on.
    fn disc(wall: usize) -> u32 {
        wall as u32 + 2
    }

    /// The first wall of a later window, and the first discs of what the window takes.
    fn taken(&self) -> Vec<f64> {
        let mut engine = Engine::<Lab7, _>::new(OnePair, Choice::Sort, Workers::One);
        let discs = vec![Disc::new(5.0, 5.0, 0.0, 0.0); self.times.len() + 2];
        engine.load(&Scene::new(10.0, 1.0, discs).expect("all are inside"));
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

    /// What is right: the walls of the window, and the pair.
    fn right(&self) -> Vec<f64> {
        let window = Window::part(self.k, self.count);
        let walls = self.before(window.from)..self.before(window.to);
        let discs = walls.clone().map(|wall| f64::from(Self::disc(wall)));
        [walls.end as f64, 0.0].into_iter().chain(discs).collect()
    }
}

/// A window of one or several takes its walls, and the pair that the finder finds.
pub(crate) fn windows(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..300 {
        let walls = Walls::drawn(random, case);
        let question = format!(
            "discs 2 to {} hit walls at λ = {:?}, window {} of {}, counted from 0, takes walls and the pair of discs \
             0 and 1: the index of the first wall of a later window, and the first disc of each collision taken",
            walls.times.len() + 1,
            walls.times,
            walls.k,
            walls.count
        );
        ask.exact(&question, || walls.taken(), || walls.right());
    }
}
