//! A fence that a test can see.

use std::cell::Cell;
use std::sync::atomic::{self, Ordering};

thread_local! {
    /// The fences that this thread has passed since its last operation on a watched number.
    static PASSED: Cell<Passed> = const { Cell::new(Passed { acquire: false, release: false }) };
}

#[derive(Clone, Copy, Default)]
pub(crate) struct Passed {
    pub(crate) acquire: bool,
    pub(crate) release: bool,
}

/// [`std::sync::atomic::fence`], of which a [`Memory`](crate::Memory) learns: it does not see that of `std`.
///
/// Stores that follow a fence of [`Ordering::Release`] hand on what the thread knew at the fence. A fence of
/// [`Ordering::Acquire`] takes over what the loads before it were handed.
///
/// # Panics
/// `ordering` is [`Ordering::Relaxed`], which a fence does not have.
#[inline]
pub fn fence(ordering: Ordering) {
    atomic::fence(ordering);
    let mut passed = PASSED.get();
    passed.acquire |= ordering != Ordering::Release;
    passed.release |= ordering != Ordering::Acquire;
    PASSED.set(passed);
}

/// The fences since the last call.
pub(crate) fn take_passed() -> Passed {
    PASSED.take()
}
