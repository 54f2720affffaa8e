//! Finds a deadlock that has not happened yet.

use std::collections::{HashMap, HashSet};
use std::thread::{self, ThreadId};

use parking_lot::Mutex;

use crate::Watch;

/// Records which locks a thread holds when it asks for another lock.
///
/// Suppose that one thread asks for lock 7 while it holds lock 3, and that at any other time a thread
/// asks for lock 3 while it holds lock 7. If both requests come at the same time, the threads wait
/// for each other forever. This watch finds the deadlock even if it does not happen: the second
/// request panics and names both locks.
#[derive(Default)]
pub struct LockOrder(Mutex<Orders>);

#[derive(Default)]
struct Orders {
    held: HashMap<ThreadId, Vec<usize>>,
    /// Pairs of a held lock and a lock that was asked for.
    asked: HashSet<(usize, usize)>,
    most_held: usize,
}

impl LockOrder {
    /// Returns the greatest number of locks that one thread has held at the same time.
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
        // A panic releases the thread's locks, which is recorded too.
        drop(orders);
        assert!(
            !held.contains(&lock),
            "a thread asks for lock {lock}, which it already holds, so it would wait for itself forever"
        );
        if let Some(held) = opposite {
            panic!(
                "a thread holds lock {held} and asks for lock {lock}. Earlier, a thread held lock {lock} and asked \
                 for lock {held}. If two threads do so at the same time, each waits for the other forever"
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
