//! Chapter 4: two particles change bins, and two threads want the same two locks.

use std::cell::Cell;
use std::panic::resume_unwind;
use std::sync::Arc;
use std::thread;

use common_threads::Watch;
use oracle::{Columns, spaced, within};
use parking_lot::{Condvar, Mutex, MutexGuard};
use solution4::{Bin, Change, Meter, Regions, change_bin, remove};

#[test]
fn lower_lock_first() {
    insta::assert_snapshot!(within("4.3", 20, || record(change_bin)));
}

#[test]
fn old_bin_first() {
    fn change_bin(regions: &Regions, meter: &mut Meter, change: Change) {
        include!(concat!(env!("OUT_DIR"), "/old_bin_first.rs"));
    }
    insta::assert_snapshot!(within("4.3", 20, || record(change_bin)));
}

/// Records two changes: particle 30 goes from bin 3 to bin 7 on thread 0, and particle 70 from 7 to
/// 3 on thread 1. Thread 1 begins when thread 0 has its first lock. The recording ends early if
/// both threads wait.
fn record(change_bin: fn(&Regions, &mut Meter, Change)) -> String {
    let changes =
        [(30, 3, 7), (70, 7, 3)].map(|(particle, from, to)| Change { particle, from, to });
    let mut regions = Regions::new(10, 2);
    changes.iter().for_each(|change| regions.bin_mut(change.from).push(change.particle));
    let recorder = Arc::new(Recorder::default());
    let wanted = changes.map(|Change { particle, from, to }| format!("{particle}: {from} -> {to}"));
    recorder.state.lock().table.row("the changes", wanted.into_iter().chain(inside(&mut regions)));
    let watch: Arc<dyn Watch> = recorder.clone();
    regions.watch(&watch);
    let ended = thread::scope(|scope| {
        let threads = [0, 1].map(|number| {
            let (regions, recorder) = (&regions, &recorder);
            scope.spawn(move || {
                THREAD.set(number);
                if number == 1 {
                    recorder.until(|threads| !threads[0].has.is_empty());
                }
                change_bin(regions, &mut Meter::default(), changes[number]);
            })
        });
        threads.map(|thread| thread.join().is_ok())
    });
    let table = &mut recorder.state.lock().table;
    if ended == [true, true] {
        let nothing = ["-", "-"].map(String::from);
        table.row("both are done", nothing.into_iter().chain(inside(&mut regions)));
    }
    table.to_string()
}

/// Lists the particles in the regions of both locks.
fn inside(regions: &mut Regions) -> Vec<String> {
    let each = regions.cut.bins_each;
    let bins = |(region, bins): (usize, &mut Vec<Bin>)| {
        let first = region * each;
        let full = bins.iter().enumerate().filter(|(_, bin)| !bin.is_empty());
        let words = full.map(|(k, bin)| format!("bin {}: {}", first + k, spaced(bin)));
        words.collect::<Vec<_>>().join(", ")
    };
    regions.parts_mut().enumerate().map(bins).collect()
}

thread_local! {
    /// Number of this thread.
    static THREAD: Cell<usize> = const { Cell::new(0) };
}

/// Recorder of both threads' lock operations.
struct Recorder {
    state: Mutex<State>,
    change: Condvar,
}

struct State {
    threads: [Thread; 2],
    table: Columns,
    /// Whether both threads wait. The recorder then ends the deadlock itself.
    over: bool,
}

#[derive(Default)]
struct Thread {
    has: Vec<usize>,
    asks_for: Option<usize>,
    /// Whether the thread has requested a lock in vain, and requests the lock again.
    waits: bool,
}

impl Default for Recorder {
    fn default() -> Self {
        let heads = ["thread 0", "thread 1", "lock 0", "lock 1"].map(String::from);
        let state = State { threads: Default::default(), table: Columns::new(heads), over: false };
        Self { state: Mutex::new(state), change: Condvar::new() }
    }
}

impl Recorder {
    /// Returns when `reached` accepts the threads.
    fn until(&self, mut reached: impl FnMut(&[Thread; 2]) -> bool) {
        self.change.wait_while(&mut self.state.lock(), |state| !reached(&state.threads));
    }

    /// Changes this thread's state, and records the change with the returned description.
    fn note(&self, change: impl FnOnce(&mut Thread) -> String) -> MutexGuard<'_, State> {
        let mut state = self.state.lock();
        if !state.over {
            let number = THREAD.get();
            let what = change(&mut state.threads[number]);
            let holder = |lock| {
                let holder = state.threads.iter().position(|thread| thread.has.contains(&lock));
                holder.map_or("free".into(), |thread| format!("thread {thread}"))
            };
            let cells: Vec<_> =
                state.threads.iter().map(Thread::words).chain([0, 1].map(holder)).collect();
            state.table.row(format!("thread {number} {what}"), cells);
            self.change.notify_all();
        }
        state
    }
}

impl Thread {
    fn words(&self) -> String {
        let has: Vec<_> = self.has.iter().map(usize::to_string).collect();
        let has = (!has.is_empty()).then(|| format!("has {}", has.join(" and ")));
        let verb = if self.waits { "waits" } else { "asks" };
        let asks = self.asks_for.map(|lock| format!("{verb} for {lock}"));
        let words: Vec<_> = has.into_iter().chain(asks).collect();
        if words.is_empty() { "-".into() } else { words.join(", ") }
    }
}

impl Watch for Recorder {
    fn asks(&self, lock: usize) {
        let mut state = self.note(|thread| {
            thread.waits = thread.asks_for.replace(lock) == Some(lock);
            format!("{} for lock {lock}", if thread.waits { "waits" } else { "asks" })
        });
        if state.threads.iter().all(|thread| thread.waits) {
            state.over = true;
            drop(state);
            resume_unwind(Box::new("both threads would wait forever"));
        }
    }

    fn has(&self, lock: usize) {
        let state = self.note(|thread| {
            *thread = Thread { has: [&thread.has[..], &[lock]].concat(), ..Thread::default() };
            format!("has lock {lock}")
        });
        let is_first = THREAD.get() == 0 && state.threads[0].has.len() == 1 && !state.over;
        drop(state);
        if is_first {
            self.until(|threads| threads[1].waits);
        }
    }

    fn returns(&self, lock: usize) {
        drop(self.note(|thread| {
            thread.has.retain(|held| *held != lock);
            format!("gives back lock {lock}")
        }));
    }
}
