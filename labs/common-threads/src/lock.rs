//! A mutex with a number, which a test can watch.

use std::ops::{Deref, DerefMut};
use std::sync::Arc;

use parking_lot::{Mutex, MutexGuard};

/// An observer of locks. Its methods are called on the thread that uses the lock.
pub trait Watch: Send + Sync {
    /// The thread asks for the lock, and may have to wait.
    fn asks(&self, _lock: usize) {}
    /// The thread has the lock now.
    fn has(&self, _lock: usize) {}
    /// The thread releases the lock.
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
    /// Returns lock number `number`, which guards `value`.
    pub fn new(number: usize, value: T) -> Self {
        Self { number, mutex: Mutex::new(value), watch: None }
    }
    // ANCHOR_END: lock

    /// Reports all uses from now on to `watch`.
    pub fn watch(&mut self, watch: Arc<dyn Watch>) {
        self.watch = Some(watch);
    }

    /// Returns the guarded value without taking the lock: `&mut` proves that no other thread has
    /// access.
    pub fn get_mut(&mut self) -> &mut T {
        self.mutex.get_mut()
    }

    /// Takes the lock if it is free.
    #[inline]
    pub fn try_lock(&self) -> Option<Guard<'_, T>> {
        self.tell(|watch| watch.asks(self.number));
        self.mutex.try_lock().map(|guard| self.taken(guard))
    }

    /// Waits until the lock is free, and takes it.
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

/// Access to the value that a lock guards. Dropping it releases the lock.
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
