//! Task 7.7: one step, the same for every variant.

use common::hard::{Disc, Scene, Simulation};

use crate::{Engine, Find, Window};

impl<F: Find> Engine<F> {
    /// Finds what happens in one window and marks it as taken.
    ///
    /// Four things, in this order: clear `self.found` ([`Found::clear`]; one list will do); let the finder find
    /// the pairs of the window ([`Find::find`]); add the wall collisions whose time lies in the window to
    /// the first list; let [`Choice::take`] choose. Wall collisions are in `self.walls`, sorted by time if there
    /// are several windows; the ones before index `next_wall` belong to earlier windows. Returns the index
    /// of the first that belongs to a later window.
    ///
    /// Book: chapter 7, *A step*.
    ///
    /// [`Choice::take`]: crate::Choice::take
    /// [`Found::clear`]: crate::Found::clear
    fn collide_in(&mut self, window: Window, next_wall: usize) -> usize {
        todo!("task 7.7b: what happens in a window")
    }

    /// One step.
    ///
    /// 1. Ask the finder into how many windows it wants the step cut ([`Find::windows`]).
    /// 2. Every disc is free; nothing is taken.
    /// 3. Look for wall collisions ([`Self::find_walls`]).
    /// 4. Window by window ([`Window::part`]), in order of time: [`Self::collide_in`].
    /// 5. Move the discs that are still free, by a whole step, and carry out what was taken
    ///    ([`Self::move_discs`]).
    ///
    /// All candidates are about the discs at the start of the step, so no disc moves before step 5.
    ///
    /// Book: chapter 7, *A step*.
    fn step_once(&mut self) {
        todo!("task 7.7: one step")
    }
}

impl<F: Find> Simulation for Engine<F> {
    fn load(&mut self, scene: &Scene) {
        self.start(scene);
    }

    fn step(&mut self) {
        self.finder.home().within(|| self.step_once());
    }

    fn read(&self, first: usize, out: &mut [Disc]) {
        out.copy_from_slice(&self.discs[first..first + out.len()]);
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        self.counts()
    }
}
