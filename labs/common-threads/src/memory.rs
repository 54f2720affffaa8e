//! Everything that one thread may see of another thread's writes.

use std::fmt::Write;
use std::sync::atomic::Ordering;

use parking_lot::Mutex;

use crate::fence::take_passed;

/// The memory of a writing thread and a reading thread, with only the guarantees of the language.
///
/// Processors of the x86 family keep more order, so a wrong ordering may do no harm on such a
/// processor for years. Here every reading that the orderings allow occurs, one after the other. A
/// location keeps all numbers that were ever written to it. A load takes any number that is not
/// older than a number that its thread knows. A store with [`Ordering::Release`] passes on the
/// knowledge of its thread, and a load with [`Ordering::Acquire`] takes it over. A
/// [`fence`](crate::fence) has the same effect on the relaxed stores after it and the relaxed loads
/// before it.
#[derive(Default)]
pub struct Memory(Mutex<State>);

#[derive(Default)]
struct State {
    locations: Vec<Location>,
    /// For each location, the newest message that the thread knows. The thread reads no older
    /// message.
    known: Vec<usize>,
    /// Knowledge of the thread at its last release fence; empty if there was none.
    released: Vec<usize>,
    /// Knowledge that the thread takes over at its next acquire fence.
    handed: Vec<usize>,
    /// Whether the reading thread is running.
    reads: bool,
    /// For each load, the index of the message that it takes, and the number of messages that it may
    /// take.
    choices: Vec<(usize, usize)>,
    loads: usize,
    log: String,
}

struct Location {
    name: &'static str,
    messages: Vec<Message>,
}

struct Message {
    bits: u64,
    /// For each location, the message that a thread knows once it has acquired this message.
    known: Vec<usize>,
}

/// More loads than a thread needs if it does not wait.
const MOST: usize = 64;

impl Memory {
    pub(crate) fn location(&self, name: &'static str, bits: u64) -> usize {
        let state = &mut *self.0.lock();
        let messages = vec![Message { bits, known: Vec::new() }];
        state.locations.push(Location { name, messages });
        state.known.push(0);
        state.handed.push(0);
        state.locations.len() - 1
    }

    /// Runs `write` once as one thread, and `read` as another thread once for each possible outcome
    /// of its loads. Returns the result of each reading, and the operations of both threads in words.
    pub fn readings<T>(
        &self,
        write: impl FnOnce(),
        mut read: impl FnMut() -> T,
    ) -> Vec<(T, String)> {
        write();
        let written = std::mem::take(&mut self.0.lock().log);
        let mut readings = Vec::new();
        loop {
            {
                let state = &mut *self.0.lock();
                // A fence after the last operation orders nothing.
                take_passed();
                state.reads = true;
                state.loads = 0;
                state.log.clone_from(&written);
                state.known.fill(0);
                state.handed.fill(0);
            }
            let came = read();
            let state = &mut *self.0.lock();
            readings.push((came, state.log.clone()));
            state.choices.truncate(state.loads);
            while state.choices.pop_if(|(taken, of)| *taken + 1 == *of).is_some() {}
            match state.choices.last_mut() {
                Some((taken, _)) => *taken += 1,
                None => return readings,
            }
        }
    }

    pub(crate) fn store(&self, location: usize, bits: u64, ordering: Ordering) {
        let state = &mut *self.0.lock();
        state.pass_fences();
        assert!(!state.reads, "the reading thread writes {}", state.locations[location].name);
        let messages = &state.locations[location].messages;
        state.known[location] = messages.len();
        let known = match ordering {
            Ordering::Relaxed => state.released.clone(),
            _ => state.known.clone(),
        };
        state.locations[location].messages.push(Message { bits, known });
        let name = state.locations[location].name;
        let _ = writeln!(state.log, "  the writer writes {name}, {ordering:?}");
    }

    pub(crate) fn load(&self, location: usize, ordering: Ordering) -> u64 {
        let state = &mut *self.0.lock();
        state.pass_fences();
        let oldest = state.known[location];
        let newest = state.locations[location].messages.len() - 1;
        if !state.reads {
            return state.locations[location].messages[newest].bits;
        }
        state.loads += 1;
        assert!(
            state.loads <= MOST,
            "the reader reads again and again until the value changes, but it must not wait"
        );
        if state.choices.len() < state.loads {
            state.choices.push((0, newest - oldest + 1));
        }
        // The newest message comes first.
        let taken = newest - state.choices[state.loads - 1].0;
        let Location { name, messages } = &state.locations[location];
        let when = if taken == 0 { "as it was before" } else { "as it was written" };
        let _ = writeln!(state.log, "  the reader reads  {name}, {ordering:?}: {when}");
        state.known[location] = taken;
        learn(&mut state.handed, &messages[taken].known);
        if ordering != Ordering::Relaxed {
            learn(&mut state.known, &messages[taken].known);
        }
        messages[taken].bits
    }
}

impl State {
    /// Applies the fences that the thread has passed since its last load or store.
    fn pass_fences(&mut self) {
        let passed = take_passed();
        let who = if self.reads { "the reader" } else { "the writer" };
        if passed.acquire {
            learn(&mut self.known, &self.handed);
            let _ = writeln!(self.log, "  {who} passes a fence, Acquire");
        }
        if passed.release {
            self.released.clone_from(&self.known);
            let _ = writeln!(self.log, "  {who} passes a fence, Release");
        }
    }
}

/// Takes over newer knowledge about each location.
fn learn(known: &mut [usize], newer: &[usize]) {
    for (known, newer) in known.iter_mut().zip(newer) {
        *known = (*known).max(*newer);
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;
    use std::sync::atomic::Ordering::{self, Acquire, Relaxed, Release, SeqCst};

    use crate::{Atomic, Memory, fence};

    /// Returns what a thread may read from a number and a flag. Each is 0 first and then 1.
    fn seen(raise: [Ordering; 2], flag_first: bool) -> Vec<[u64; 2]> {
        let memory = Arc::new(Memory::default());
        let [number, flag] = ["number", "flag"].map(|name| Atomic::watched(0, &memory, name));
        let write = || {
            if flag_first {
                flag.store(1, raise[0]);
            }
            number.store(1, Relaxed);
            if !flag_first {
                flag.store(1, raise[0]);
            }
        };
        let readings = memory.readings(write, || {
            let flag = flag.load(raise[1]);
            [number.load(Relaxed), flag]
        });
        let mut seen: Vec<_> = readings.into_iter().map(|(seen, _)| seen).collect();
        seen.sort_unstable();
        seen
    }

    #[test]
    fn an_acquired_flag_shows_what_was_written_before_its_release() {
        for both in [[Release, Acquire], [SeqCst, SeqCst]] {
            assert_eq!(seen(both, false), [[0, 0], [1, 0], [1, 1]]);
            assert_eq!(seen(both, true), [[0, 0], [0, 1], [1, 0], [1, 1]]);
        }
    }

    #[test]
    fn release_or_acquire_alone_orders_nothing() {
        for half in [[Relaxed, Acquire], [Release, Relaxed], [Relaxed, Relaxed]] {
            assert_eq!(seen(half, false), [[0, 0], [0, 1], [1, 0], [1, 1]]);
        }
    }

    /// Returns what a thread may read from a number and a flag that is stored relaxed, with a fence in
    /// each thread.
    fn seen_with_fences(fences: [Ordering; 2], load: Ordering) -> Vec<[u64; 2]> {
        let memory = Arc::new(Memory::default());
        let [number, flag] = ["number", "flag"].map(|name| Atomic::watched(0, &memory, name));
        let write = || {
            number.store(1, Relaxed);
            fence(fences[0]);
            flag.store(1, Relaxed);
        };
        let readings = memory.readings(write, || {
            let flag = flag.load(load);
            fence(fences[1]);
            [number.load(Relaxed), flag]
        });
        let mut seen: Vec<_> = readings.into_iter().map(|(seen, _)| seen).collect();
        seen.sort_unstable();
        seen
    }

    #[test]
    fn fences_order_relaxed_operations() {
        for both in [[Release, Acquire], [SeqCst, SeqCst]] {
            for load in [Relaxed, Acquire] {
                assert_eq!(seen_with_fences(both, load), [[0, 0], [1, 0], [1, 1]]);
            }
        }
        for wrong in [[Acquire, Acquire], [Release, Release]] {
            assert_eq!(seen_with_fences(wrong, Relaxed), [[0, 0], [0, 1], [1, 0], [1, 1]]);
        }
    }

    #[test]
    fn a_location_does_not_go_back_in_time() {
        let memory = Arc::new(Memory::default());
        let number = Atomic::watched(0, &memory, "number");
        let readings = memory.readings(
            || [1, 2].into_iter().for_each(|bits| number.store(bits, Relaxed)),
            || [number.load(Relaxed), number.load(Relaxed)],
        );
        for ([first, second], _) in readings {
            assert!(first <= second);
        }
    }

    #[test]
    #[should_panic = "it must not wait"]
    fn a_waiting_thread_panics() {
        let memory = Arc::new(Memory::default());
        let flag = Atomic::watched(0, &memory, "flag");
        memory.readings(|| {}, || while flag.load(Acquire) == 0 {});
    }
}
