//! Epochs: steps without a message, and the rollback if some of these steps were wrong.
//!
//! The ghosts of an epoch of four steps reach four cutoffs beyond the strip, plus the distance that
//! particles move. In each step the outermost correct ghosts become wrong (`x`), because they lack
//! neighbours:
//!
//! ```text
//!              own particles of the strip │ ghosts
//! exchange     ● ● ● ● ● ● ● ● ● ● ● ● ●  │ ○ ○ ○ ○    messages to all partners; checkpoint
//! step 1       ● ● ● ● ● ● ● ● ● ● ● ● ●  │ ○ ○ ○ x    no messages
//! step 2       ● ● ● ● ● ● ● ● ● ● ● ● ●  │ ○ ○ x x
//! step 3       ● ● ● ● ● ● ● ● ● ● ● ● ●  │ ○ x x x
//! step 4       ● ● ● ● ● ● ● ● ● ● ● ● ●  │ x x x x
//! confirm      how many steps were right on all ranks?  one reduction
//!                 all 4:     the next epoch begins
//!                 only 3:    back to the checkpoint, 3 steps again, then the next epoch
//! ```
//!
//! A step can be wrong if a particle became faster than the choice of ghosts allowed for.

use common::soft::NoStatistics;

use crate::deep::{Deep, Epoch};
use crate::deep_halo::{DeepHalo, Outlook};
use crate::domain::{Domain, lists_last};

/// Speed that the choice of ghosts allows for, as a multiple of the speed of the fastest particle
/// at that moment.
///
/// A rollback costs an epoch, and slightly deeper ghosts cost almost nothing.
const FASTER: f64 = 1.5;

impl<T: DeepHalo> Deep<T> {
    /// Chooses ghosts for the next epoch. All ranks call this function together.
    pub(crate) fn begin_epoch(&mut self) {
        self.drop_ghosts();
        self.domain.keep_balance::<T>();
        let steps = T::best_depth(self.outlook);
        let width = T::deep_width(self.outlook.fastest, steps);
        self.exchange(width);
        let engine = &mut self.domain.engine;
        let bodies = std::mem::take(engine.bodies_mut());
        let n = bodies.len();
        // The engine forgets all knowledge from the last list. So steps that are taken again have
        // the same lists and the same bits.
        engine.start(bodies, self.domain.grid.size());
        engine.rebuild_keeping(&mut self.kept);
        let own = [self.domain.wear(), (n - self.ghosts.len()) as f64];
        self.epoch = Epoch { planned: steps as usize, width, moves: Vec::new(), own };
    }

    /// Takes `steps` steps without a message.
    // ANCHOR: advance
    pub(crate) fn advance(&mut self, steps: u64) {
        for _ in 0..steps {
            let moved = self.domain.engine.advance() + self.domain.rounding();
            self.epoch.moves.push(moved);
        }
    }
    // ANCHOR_END: advance

    /// Agrees with all ranks on the number of right steps, and goes back if some steps are wrong.
    ///
    /// Returns the number of steps that must be taken again. All ranks call this function together.
    // ANCHOR: confirm
    pub(crate) fn confirm(&mut self) -> u64 {
        let Epoch { planned, width, moves, own } = &self.epoch;
        let steps = moves.len();
        let mut numbers = [&moves[..], own].concat();
        self.domain.count_reduction(&numbers);
        let right = T::confirm(&self.domain.world, &mut numbers, steps, *width);
        assert!((1..=steps).contains(&right), "of {steps} steps {right} are said to be right");
        let (moves, others) = numbers.split_at(steps);
        self.gone = moves[..right].iter().sum();
        if right == *planned || right < steps {
            self.outlook = self.domain.outlook(moves[right - 1], others);
            self.epoch.planned = 0;
        }
        if right < steps {
            self.go_back(right as u64);
        }
        (steps - right) as u64
    }
    // ANCHOR_END: confirm

    /// Goes back to the start of the epoch, and takes only the steps that were right.
    fn go_back(&mut self, right: u64) {
        let kept = std::mem::take(&mut self.kept);
        self.domain.engine.start(kept, self.domain.grid.size());
        self.domain.engine.rebuild();
        self.advance(right);
        self.taken_again += 1;
    }
}

impl Domain<NoStatistics> {
    /// Returns the facts for the next plan, after a step in which no particle went further than
    /// `far`.
    fn outlook(&self, far: f64, others: &[f64]) -> Outlook {
        Outlook {
            fastest: FASTER * far,
            height: self.height(),
            particles: others[1].max(1.0),
            most: lists_last(others[0]),
        }
    }
}
