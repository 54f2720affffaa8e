//! Who may reach a wall, asked of few.

use crate::Bodies;
use crate::path::Span;
use crate::signs::EIGHT;

/// Who may reach a wall until the list is worn out, and who within this step.
#[derive(Default)]
pub(crate) struct Walls {
    /// In sorted order.
    near: Vec<u32>,
    /// Whether each of all particles may reach a wall within the step.
    pub(crate) at: Vec<bool>,
}

impl Walls {
    /// Finds the particles no further than `strip` from a wall.
    pub(crate) fn find(&mut self, bodies: &Bodies, strip: f64, size: f64) {
        let Self { near, at } = self;
        at.clear();
        at.resize(bodies.len(), false);
        near.clear();
        let (least, most) = (strip, size - strip);
        let is_near =
            |(x, y): (&f64, &f64)| !((*x >= least) & (*x <= most) & (*y >= least) & (*y <= most));
        for (k, (x, y)) in bodies.x.chunks(EIGHT).zip(bodies.y.chunks(EIGHT)).enumerate() {
            if x.iter().zip(y).fold(false, |any, place| any | is_near(place)) {
                let some = x.iter().zip(y).enumerate().filter(|(_, place)| is_near(*place));
                near.extend(some.map(|(l, _)| (k * EIGHT + l) as u32));
            }
        }
    }

    /// Has `more` particles asked as well, who may go further than the others.
    pub(crate) fn add(&mut self, more: impl Iterator<Item = u32>) {
        self.near.extend(more);
        self.near.sort_unstable();
        self.near.dedup();
    }

    /// Asks them again at the beginning of a step; brings back those who may reach one in it.
    pub(crate) fn meet(&mut self, bodies: &Bodies, span: &Span) -> Vec<u32> {
        let Self { near, at } = self;
        let meets = |&i: &u32| {
            let k = i as usize;
            at[k] = span.meets_wall(bodies.x[k], bodies.y[k], bodies.vx[k], bodies.vy[k]);
            at[k]
        };
        near.iter().copied().filter(meets).collect()
    }
}
