//! Task 7.7: one step, the same for every variant.

use hard_discs::{Collisions, Engine, Find, Window};

/// Finds the collisions of one window, and marks them as taken.
///
/// 1. Clear `engine.found`, with one list ([`Found::clear`]). This function needs only one.
/// 2. Let the finder find the pairs of the window ([`Find::find`]). The finder may replace the
///    lists.
/// 3. Add the wall collisions whose time is in the window to one of the lists.
/// 4. Call `engine.choice.take::<C>` ([`Choice::take`]), which chooses the collisions that happen.
///
/// `engine.walls` contains the wall collisions. If there are several windows, the wall collisions
/// are sorted by time. The collisions before index `next_wall` belong to earlier windows. Return
/// the index of the first wall collision that belongs to a later window.
///
/// Book: chapter 7, *A step*.
///
/// [`Choice::take`]: hard_discs::Choice::take
/// [`Found::clear`]: hard_discs::Found::clear
pub fn collide_in<C: Collisions, F: Find>(
    engine: &mut Engine<C, F>,
    window: Window,
    next_wall: usize,
) -> usize {
    todo!("task 7.7b: what happens in a window")
}

/// Computes one step.
///
/// 1. Ask the finder for the number of windows into which to cut the step ([`Find::windows`]).
/// 2. Mark every disc as free, and every candidate as not taken.
/// 3. Find the wall collisions ([`Engine::find_walls`]).
/// 4. Call [`collide_in`] for each window ([`Window::part`]), in the order of time.
/// 5. Advance the discs that are still marked as free through the whole step, and carry out the
///    collisions that were taken ([`Engine::move_discs`]).
///
/// All candidates refer to the discs at the start of the step, so no disc may move before item 5.
///
/// Book: chapter 7, *A step*.
pub fn step<C: Collisions, F: Find>(engine: &mut Engine<C, F>) {
    todo!("task 7.7: one step")
}
