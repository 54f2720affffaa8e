//! A fence that a test can observe.

use std::cell::Cell;
use std::sync::atomic::{self, Ordering};

thread_local! {
    /// Fences that this thread has passed since its last operation on a watched number.
    static PASSED: Cell<Passed> = const { Cell::new(Passed { acquire: false, release: false }) };
}

#[derive(Clone, Copy, Default)]
pub(crate) struct Passed {
    pub(crate) acquire: bool,
    pub(crate) release: bool,
}

/// Calls [`std::sync::atomic::fence`] and reports it to a [`Memory`](crate::Memory), which does not
/// see the fence of `std`.
///
/// Stores after a fence with [`Ordering::Release`] pass on the thread's knowledge at the fence. A
/// fence with [`Ordering::Acquire`] takes over the knowledge that the loads before it received.
///
/// # Panics
/// If `ordering` is [`Ordering::Relaxed`], which a fence cannot have.
#[inline]
pub fn fence(ordering: Ordering) {
    atomic::fence(ordering);
    let mut passed = PASSED.get();
    passed.acquire |= ordering != Ordering::Release;
    passed.release |= ordering != Ordering::Acquire;
    PASSED.set(passed);
}

/// Returns the fences since the last call.
pub(crate) fn take_passed() -> Passed {
    PASSED.take()
}
