//! Finds a deadlock that has not happened yet.

use std::collections::{HashMap, HashSet};
use std::thread::{self, ThreadId};

use parking_lot::Mutex;

use crate::Watch;

/// Records which lock is asked for while which is held.
///
/// If one thread asks for lock 7 while it holds lock 3, and at any other time a thread asks for lock 3
/// while it holds lock 7, then the two wait for each other for ever on the day on which they do it at
/// once. So it need not happen to be found: it panics at the second request, and names both locks.
#[derive(Default)]
pub struct LockOrder(Mutex<Orders>);

#[derive(Default)]
struct Orders {
    held: HashMap<ThreadId, Vec<usize>>,
    /// (held, asked for)
    asked: HashSet<(usize, usize)>,
    most_held: usize,
}

impl LockOrder {
    /// The most locks that one thread has held at once.
    pub fn most_held(&self) -> usize {
        self.0.lock().most_held
    }
}

impl Watch for LockOrder {
    fn asks(&self, lock: usize) {
        let mut orders = self.0.lock();
        let held = orders.held.entry(thread::current().id()).or_default().clone();
        let opposite = held.iter().find(|held| orders.asked.contains(&(lock, **held))).copied();
        orders.asked.extend(held.iter().map(|held| (*held, lock)));
        // A panic gives the thread's locks back, which is recorded too.
        drop(orders);
        assert!(
            !held.contains(&lock),
            "a thread asks for lock {lock}, which it holds already, so it would wait for itself forever"
        );
        if let Some(held) = opposite {
            panic!(
                "a thread holds lock {held} and asks for lock {lock}. Earlier, a thread held lock {lock} and asked for \
                 lock {held}. If both do so at once, each waits for the other forever"
            );
        }
    }

    fn has(&self, lock: usize) {
        let orders = &mut *self.0.lock();
        let held = orders.held.entry(thread::current().id()).or_default();
        held.push(lock);
        orders.most_held = orders.most_held.max(held.len());
    }

    fn returns(&self, lock: usize) {
        if let Some(held) = self.0.lock().held.get_mut(&thread::current().id()) {
            held.retain(|held| *held != lock);
        }
    }
}
