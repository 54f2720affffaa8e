//! The exact motion: every collision, in order of time, for any number of collisions per disc.

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

use common::hard::Disc;

use super::model::{What, swap_normal_components};

/// An event-driven simulation. Between collisions discs fly straight, so the next collision can be
/// predicted, and time jumps from one collision to the next (Alder and Wainwright, 1959). Nothing
/// is rounded to time steps: the simulation includes the collisions that the greedy model omits.
pub struct Exact {
    low: f64,
    high: f64,
    radius: f64,
    discs: Vec<Disc>,
    /// Time at which `discs[i]` has its stored state.
    at: Vec<f64>,
    queue: BinaryHeap<Reverse<Prediction>>,
    now: f64,
    collisions: u64,
}

/// A collision that will happen unless one of its discs collides earlier.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Prediction {
    time: f64,
    disc: usize,
    what: What,
    /// Collision counts of both discs at the time of the prediction.
    made_at: (u32, u32),
}

impl Eq for Prediction {}

impl Ord for Prediction {
    fn cmp(&self, other: &Self) -> Ordering {
        let rank = |p: &Self| (p.what, p.disc);
        self.time.total_cmp(&other.time).then_with(|| rank(self).cmp(&rank(other)))
    }
}

impl PartialOrd for Prediction {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Exact {
    /// Starts at time 0 with discs that do not overlap, in a square of side `side`.
    pub fn new(discs: &[Disc], side: f64, radius: f64) -> Self {
        let mut exact = Self {
            low: radius,
            high: side - radius,
            radius,
            discs: discs.to_vec(),
            at: vec![0.0; discs.len()],
            queue: BinaryHeap::new(),
            now: 0.0,
            collisions: 0,
        };
        for i in 0..discs.len() {
            exact.predict_walls(i);
            for j in 0..i {
                exact.predict_pair(j, i);
            }
        }
        exact
    }

    /// Returns the number of collisions so far, with walls and with discs.
    pub fn collisions(&self) -> u64 {
        self.collisions
    }

    /// Advances to the time `end`, and returns the discs at that time.
    pub fn run_until(&mut self, end: f64) -> Vec<Disc> {
        while self.queue.peek().is_some_and(|Reverse(next)| next.time <= end) {
            let Some(Reverse(next)) = self.queue.pop() else { break };
            if self.made_at(next.disc, next.what) == next.made_at {
                self.now = next.time;
                self.happen(next);
            }
        }
        self.now = end;
        (0..self.discs.len()).map(|i| self.disc_at(i, end)).collect()
    }

    fn disc_at(&self, i: usize, time: f64) -> Disc {
        let mut disc = self.discs[i];
        disc.x += disc.vx * (time - self.at[i]);
        disc.y += disc.vy * (time - self.at[i]);
        disc
    }

    fn made_at(&self, i: usize, what: What) -> (u32, u32) {
        let count = |i: usize| self.discs[i].pair_collisions + self.discs[i].wall_collisions;
        (count(i), if let What::Disc(j) = what { count(j) } else { 0 })
    }

    fn expect(&mut self, time: f64, disc: usize, what: What) {
        let made_at = self.made_at(disc, what);
        self.queue.push(Reverse(Prediction { time, disc, what, made_at }));
    }

    fn predict_walls(&mut self, i: usize) {
        let disc = self.disc_at(i, self.now);
        for (x, v, what) in [(disc.x, disc.vx, What::WallX), (disc.y, disc.vy, What::WallY)] {
            if v != 0.0 {
                let bound = if v < 0.0 { self.low } else { self.high };
                self.expect(self.now + ((bound - x) / v).max(0.0), i, what);
            }
        }
    }

    fn predict_pair(&mut self, i: usize, j: usize) {
        let (a, b) = (self.disc_at(i, self.now), self.disc_at(j, self.now));
        let (px, py, ux, uy) = (b.x - a.x, b.y - a.y, b.vx - a.vx, b.vy - a.vy);
        let rate = px * ux + py * uy;
        let gap = px * px + py * py - 4.0 * self.radius * self.radius;
        let turn = px * uy - py * ux;
        let under_root = 4.0 * self.radius * self.radius * (ux * ux + uy * uy) - turn * turn;
        if rate < 0.0 && under_root > 0.0 {
            let wait = (gap / (under_root.sqrt() - rate)).max(0.0);
            self.expect(self.now + wait, i.min(j), What::Disc(i.max(j)));
        }
    }

    fn happen(&mut self, event: Prediction) {
        self.collisions += 1;
        let i = event.disc;
        let mut a = self.disc_at(i, self.now);
        let mut changed = vec![i];
        match event.what {
            What::Disc(j) => {
                let mut b = self.disc_at(j, self.now);
                swap_normal_components(&mut a, &mut b);
                a.pair_collisions += 1;
                b.pair_collisions += 1;
                (self.discs[j], self.at[j]) = (b, self.now);
                changed.push(j);
            }
            wall => {
                if wall == What::WallX {
                    a.vx = -a.vx;
                } else {
                    a.vy = -a.vy;
                }
                a.wall_collisions += 1;
            }
        }
        (self.discs[i], self.at[i]) = (a, self.now);
        for &i in &changed {
            self.predict_walls(i);
            for j in (0..self.discs.len()).filter(|&j| j != i) {
                self.predict_pair(i, j);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Random;

    fn near(disc: &Disc, (x, y, vx, vy): (f64, f64, f64, f64)) {
        for (found, expected) in [(disc.x, x), (disc.y, y), (disc.vx, vx), (disc.vy, vy)] {
            assert!((found - expected).abs() < 1e-12, "{disc:?}, not {:?}", (x, y, vx, vy));
        }
    }

    #[test]
    fn two_discs_head_on_exchange_velocities() {
        let discs = [Disc::new(10.0, 50.0, 2.0, 0.0), Disc::new(32.0, 50.0, -3.0, 0.0)];
        let after = Exact::new(&discs, 100.0, 1.0).run_until(5.0);
        // The discs touch at time 4, at 18 and 20.
        near(&after[0], (15.0, 50.0, -3.0, 0.0));
        near(&after[1], (22.0, 50.0, 2.0, 0.0));
    }

    #[test]
    fn two_discs_off_centre_turn_by_a_right_angle() {
        // The discs touch when the line of centres is at 45 degrees.
        let off = 2f64.sqrt();
        let discs = [Disc::new(20.0, 50.0, 4.0, 0.0), Disc::new(40.0, 50.0 + off, 0.0, 0.0)];
        let mut exact = Exact::new(&discs, 100.0, 1.0);
        let after = exact.run_until(6.0);
        assert_eq!(exact.collisions(), 1);
        near(&after[0], (after[0].x, after[0].y, 2.0, -2.0));
        near(&after[1], (after[1].x, after[1].y, 2.0, 2.0));
    }

    #[test]
    fn three_discs_in_a_row_pass_the_velocity_on() {
        let discs = [
            Disc::new(10.0, 50.0, 5.0, 0.0),
            Disc::new(20.0, 50.0, 0.0, 0.0),
            Disc::new(30.0, 50.0, 0.0, 0.0),
        ];
        let after = Exact::new(&discs, 100.0, 1.0).run_until(5.0);
        near(&after[0], (18.0, 50.0, 0.0, 0.0));
        near(&after[1], (28.0, 50.0, 0.0, 0.0));
        near(&after[2], (39.0, 50.0, 5.0, 0.0));
    }

    #[test]
    fn a_disc_alone_follows_the_folded_path() {
        let discs = [Disc::new(3.0, 4.0, 7.0, -11.0)];
        let after = Exact::new(&discs, 10.0, 1.0).run_until(10.0);
        // The centres are in a square from 0 to 8: 2 + 70 = 72 and 3 − 110 = −107, folded at 16.
        near(&after[0], (1.0 + 8.0, 1.0 + 5.0, after[0].vx, -11.0));
    }

    #[test]
    fn time_runs_backwards_to_the_start() {
        let mut random = Random::new(17);
        let discs: Vec<_> = (0..25)
            .map(|k| {
                let (x, y) = (f64::from(k % 5), f64::from(k / 5));
                let mut v = || random.between(-1.0, 1.0);
                Disc::new(10.0 + 20.0 * x, 10.0 + 20.0 * y, v(), v())
            })
            .collect();
        let mut exact = Exact::new(&discs, 100.0, 4.0);
        let mut turned = exact.run_until(60.0);
        turned.iter_mut().for_each(|disc| (disc.vx, disc.vy) = (-disc.vx, -disc.vy));
        let mut back = Exact::new(&turned, 100.0, 4.0);
        let ends = back.run_until(60.0);
        assert!(exact.collisions() > 60, "only {} collisions", exact.collisions());
        assert_eq!(back.collisions(), exact.collisions(), "on the way back and forth");
        for (start, end) in discs.iter().zip(&ends) {
            let error = (start.x - end.x).abs().max((start.y - end.y).abs());
            assert!(error < 1e-6, "{start:?} came back to {end:?}");
        }
    }
}
