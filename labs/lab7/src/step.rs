//! Task 7.7: one step, the same for every variant.

use hard_discs::{Collisions, Engine, Find, Window};

/// Finds what happens in one window and marks it as taken.
///
/// Four things, in this order: clear `engine.found` ([`Found::clear`]; one list will do); let the finder find
/// the pairs of the window ([`Find::find`]), which may replace the lists; add the wall collisions whose time lies in
/// the window to the first list; let `engine.choice` choose ([`Choice::take`], with `C`: `take::<C>`). Wall collisions
/// are in `engine.walls`, sorted by time if there are several windows; the ones before index `next_wall` belong to
/// earlier windows. Returns the index of the first that belongs to a later window.
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

/// One step.
///
/// 1. Ask the finder into how many windows it wants the step cut ([`Find::windows`]).
/// 2. Every disc is free; nothing is taken.
/// 3. Look for wall collisions ([`Engine::find_walls`]).
/// 4. Window by window ([`Window::part`]), in order of time: [`collide_in`].
/// 5. Move the discs that are still free, by a whole step, and carry out what was taken
///    ([`Engine::move_discs`]).
///
/// All candidates are about the discs at the start of the step, so no disc moves before step 5.
///
/// Book: chapter 7, *A step*.
pub fn step<C: Collisions, F: Find>(engine: &mut Engine<C, F>) {
    todo!("task 7.7: one step")
}
