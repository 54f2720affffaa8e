//! A mutex with a number, which a test can watch.

use std::ops::{Deref, DerefMut};
use std::sync::Arc;

use parking_lot::{Mutex, MutexGuard};

/// What is told of a lock, on the thread that uses it.
pub trait Watch: Send + Sync {
    /// The thread asks for the lock, and may have to wait.
    fn asks(&self, _lock: usize) {}
    /// The thread has the lock now.
    fn has(&self, _lock: usize) {}
    /// The thread gives the lock back.
    fn returns(&self, _lock: usize) {}
}

/// A [`Mutex`] with a number.
// ANCHOR: lock
pub struct Lock<T> {
    number: usize,
    mutex: Mutex<T>,
    watch: Option<Arc<dyn Watch>>,
}

impl<T> Lock<T> {
    /// Lock number `number`, which guards `value`.
    pub fn new(number: usize, value: T) -> Self {
        Self { number, mutex: Mutex::new(value), watch: None }
    }
    // ANCHOR_END: lock

    /// Tells `watch` of all that happens from now on.
    pub fn watch(&mut self, watch: Arc<dyn Watch>) {
        self.watch = Some(watch);
    }

    /// What the lock guards, without taking it: `&mut` says that no other thread can see it.
    pub fn get_mut(&mut self) -> &mut T {
        self.mutex.get_mut()
    }

    /// The lock, if it is free.
    #[inline]
    pub fn try_lock(&self) -> Option<Guard<'_, T>> {
        self.tell(|watch| watch.asks(self.number));
        self.mutex.try_lock().map(|guard| self.taken(guard))
    }

    /// The lock, as soon as it is free.
    #[inline]
    pub fn lock(&self) -> Guard<'_, T> {
        self.tell(|watch| watch.asks(self.number));
        self.taken(self.mutex.lock())
    }

    fn taken<'a>(&'a self, guard: MutexGuard<'a, T>) -> Guard<'a, T> {
        self.tell(|watch| watch.has(self.number));
        Guard { lock: self, guard }
    }

    #[inline]
    fn tell(&self, what: impl FnOnce(&dyn Watch)) {
        if let Some(watch) = &self.watch {
            what(&**watch);
        }
    }
}

/// The right to use what a lock guards, until it is dropped.
pub struct Guard<'a, T> {
    lock: &'a Lock<T>,
    guard: MutexGuard<'a, T>,
}

impl<T> Deref for Guard<'_, T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.guard
    }
}

impl<T> DerefMut for Guard<'_, T> {
    fn deref_mut(&mut self) -> &mut T {
        &mut self.guard
    }
}

impl<T> Drop for Guard<'_, T> {
    fn drop(&mut self) {
        self.lock.tell(|watch| watch.returns(self.lock.number));
    }
}
