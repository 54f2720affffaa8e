//! Given: a barrier, at which threads wait for each other.

use std::sync::{Condvar, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

/// A barrier that breaks when a member panics.
///
/// At a [`std::sync::Barrier`], the other members would wait forever for a thread that has
/// panicked. Here the other members panic too, so a mistake ends the run. The message of the first
/// panic names the mistake. Members do not wait for a member that has finished.
#[derive(Debug)]
pub struct Barrier {
    state: Mutex<State>,
    change: Condvar,
}

#[derive(Debug, Default)]
struct State {
    /// The number of members that have not finished yet.
    members: usize,
    waiting: usize,
    /// The number of times that all members have met. A waiting member continues when this number
    /// changes. It cannot watch `waiting` instead, because another member may already be waiting at
    /// the next barrier.
    meetings: u64,
    broken: bool,
}

impl Barrier {
    /// Makes a barrier for `members` members.
    pub fn new(members: usize) -> Self {
        let state = State { members, ..State::default() };
        Self { state: Mutex::new(state), change: Condvar::new() }
    }

    /// Waits until every other member has either called this function or finished.
    ///
    /// # Panics
    /// If a member has panicked.
    pub fn wait(&self) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let meeting = state.meetings;
        state.waiting += 1;
        self.meet(&mut state);
        while state.meetings == meeting && !state.broken {
            state = self.change.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        let broken = state.meetings == meeting;
        drop(state);
        assert!(!broken, "another member of the team has panicked");
    }

    /// Releases all members if every member that has not finished is waiting.
    fn meet(&self, state: &mut State) {
        if state.waiting == state.members {
            state.waiting = 0;
            state.meetings += 1;
            self.change.notify_all();
        }
    }

    /// The number of times that all members have met so far.
    pub fn meetings(&self) -> u64 {
        self.state.lock().unwrap_or_else(PoisonError::into_inner).meetings
    }

    /// Returns when all *other* members wait in [`wait`](Self::wait), or the barrier is broken.
    ///
    /// A member that calls this continues only when the others can no longer continue without it.
    pub fn be_last(&self) {
        while !self.others_wait() {
            thread::sleep(Duration::from_micros(20));
        }
    }

    /// Whether all members but one wait in [`wait`](Self::wait), or the barrier is broken.
    pub fn others_wait(&self) -> bool {
        let state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        state.waiting + 1 >= state.members || state.broken
    }

    /// Returns a guard, which a member holds until it finishes.
    ///
    /// When the guard is dropped, the others no longer wait for the member. If the member's thread
    /// panics, the barrier breaks.
    pub fn membership(&self) -> Membership<'_> {
        Membership(self)
    }
}

/// The guard of a member, dropped when the member finishes.
#[derive(Debug)]
pub struct Membership<'a>(&'a Barrier);

impl Drop for Membership<'_> {
    fn drop(&mut self) {
        let mut state = self.0.state.lock().unwrap_or_else(PoisonError::into_inner);
        if thread::panicking() {
            state.broken = true;
            self.0.change.notify_all();
        } else {
            state.members -= 1;
            if state.waiting > 0 {
                self.0.meet(&mut state);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::thread;
    use std::time::Duration;

    use oracle::Random;

    use super::Barrier;

    /// Members arrive late in turn, and some sleep between barriers.
    ///
    /// So the members arrive and leave in a different order at each meeting.
    #[test]
    fn no_member_passes_before_all_have_come() {
        for members in 1..=5 {
            let (barrier, count) = (Barrier::new(members), AtomicUsize::new(0));
            thread::scope(|scope| {
                for member in 0..members {
                    let (barrier, count) = (&barrier, &count);
                    scope.spawn(move || {
                        let mut random = Random::new(1 + member as u64);
                        for round in 1..=500 {
                            delay(&mut random);
                            count.fetch_add(1, Ordering::Relaxed);
                            barrier.wait();
                            assert_eq!(count.load(Ordering::Relaxed), members * round);
                            delay(&mut random);
                            barrier.wait();
                        }
                    });
                }
            });
        }
    }

    /// Continues at once, yields the core, or spins or sleeps for some microseconds.
    fn delay(random: &mut Random) {
        match random.below(64) {
            0 => thread::sleep(Duration::from_micros(random.bits() % 50)),
            1..8 => thread::yield_now(),
            8..24 => (0..random.below(1000)).for_each(|_| std::hint::spin_loop()),
            _ => {}
        }
    }

    #[test]
    fn the_last_comes_when_the_others_wait() {
        let (barrier, waiting) = (Barrier::new(3), AtomicUsize::new(0));
        thread::scope(|scope| {
            for _ in 0..2 {
                scope.spawn(|| {
                    waiting.fetch_add(1, Ordering::Relaxed);
                    barrier.wait();
                });
            }
            barrier.be_last();
            assert_eq!(waiting.load(Ordering::Relaxed), 2);
            barrier.wait();
        });
    }

    #[test]
    fn nobody_waits_for_a_member_that_has_ended() {
        let barrier = Barrier::new(3);
        thread::scope(|scope| {
            for waits in [0, 1, 2] {
                let barrier = &barrier;
                scope.spawn(move || {
                    let _membership = barrier.membership();
                    (0..waits).for_each(|_| barrier.wait());
                });
            }
        });
        assert_eq!(barrier.meetings(), 2);
    }

    #[test]
    fn a_panic_sets_the_others_free() {
        let barrier = Barrier::new(3);
        let ends = thread::scope(|scope| {
            let members = [false, true, false].map(|dies| {
                let barrier = &barrier;
                scope.spawn(move || {
                    let _membership = barrier.membership();
                    assert!(!dies, "first");
                    barrier.wait();
                })
            });
            members.map(|member| member.join().is_err())
        });
        assert_eq!(ends, [true; 3]);
    }
}
