//! The worked example of two locks: the locks that a change takes, and two threads moment by
//! moment. Threads are delayed so that the moments have the same order in every run.

use std::cell::Cell;
use std::panic::resume_unwind;
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use common_threads::{LockOrder, Watch};
use lab4::{Change, Meter, change_bin};
use oracle::{Ask, Columns, Random, Table, within};
use parking_lot::{Condvar, Mutex};

use super::bins::{filled, inside, ten};

/// Time that a thread is delayed for another thread that may never come.
const PATIENCE: Duration = Duration::from_secs(2);

thread_local! {
    /// The number of this thread.
    static THREAD: Cell<usize> = const { Cell::new(0) };
}

/// Locks that one thread has, and locks that it waits for.
#[derive(Default)]
struct Thread {
    has: Vec<usize>,
    asked: Option<usize>,
    waits: bool,
}

impl Thread {
    fn description(&self) -> String {
        let has = match self.has.len() {
            0 => "-".into(),
            1 => "1 lock".into(),
            count => format!("{count} locks"),
        };
        if self.waits { format!("{has}, waits") } else { has }
    }
}

struct State {
    threads: [Thread; 2],
    table: Columns,
    /// Whether both threads wait for each other. The recorder then ends the deadlock itself.
    over: bool,
}

impl State {
    fn note(&mut self, what: &str, bins: [String; 2]) {
        if !self.over {
            let description = self.threads.each_ref().map(Thread::description);
            self.table.row(what, description.into_iter().chain(bins));
        }
    }
}

/// Records the lock operations of two threads. The lab decides which of two locks a thread takes
/// first, so locks are counted and not named.
struct Recorder {
    state: Mutex<State>,
    change: Condvar,
}

impl Recorder {
    fn new() -> Self {
        let heads = ["thread 0", "thread 1", "bin 3", "bin 7"].map(String::from);
        let table = Columns::new(heads);
        let state = State { threads: Default::default(), table, over: false };
        Self { state: Mutex::new(state), change: Condvar::new() }
    }

    /// Changes this thread's state, and records the name of the change if it has a name.
    fn note(&self, change: impl FnOnce(&mut [Thread; 2], usize) -> Option<&'static str>) {
        let mut state = self.state.lock();
        let number = THREAD.get();
        if let Some(what) = change(&mut state.threads, number) {
            state.note(&format!("thread {number} {what}"), Default::default());
        }
        self.change.notify_all();
    }

    /// Returns when `reached` accepts the threads, or when it is clear that it never will.
    fn until(&self, mut reached: impl FnMut(&[Thread; 2]) -> bool) {
        let mut state = self.state.lock();
        let is_not_yet = |state: &mut State| !state.over && !reached(&state.threads);
        self.change.wait_while_for(&mut state, is_not_yet, PATIENCE);
    }
}

impl Watch for Recorder {
    fn asks(&self, lock: usize) {
        self.note(|threads, number| {
            let is_held = threads[1 - number].has.contains(&lock);
            let own = &mut threads[number];
            let is_new = own.asked.replace(lock) != Some(lock) && is_held;
            own.waits = is_held;
            is_new.then_some("waits for a lock of the other")
        });
        let state = &mut *self.state.lock();
        if state.threads.iter().all(|thread| thread.waits) {
            state.over = true;
            self.change.notify_all();
            resume_unwind(Box::new("both threads would wait forever"));
        }
    }

    fn has(&self, _lock: usize) {
        let number = THREAD.get();
        if self.state.lock().threads[number].waits {
            // The other thread is about to release its remaining locks.
            self.until(|threads| threads[1 - number].has.is_empty());
        }
        self.note(|threads, number| {
            let own = &mut threads[number];
            own.has.extend(own.asked.take());
            own.waits = false;
            Some("has a lock")
        });
        if number == 0 && self.state.lock().threads[0].has.len() == 1 {
            self.until(|threads| threads[1].waits);
        }
    }

    fn returns(&self, lock: usize) {
        self.note(|threads, number| {
            threads[number].has.retain(|held| *held != lock);
            threads[number].has.is_empty().then_some("has none left")
        });
    }
}

/// Shows two changes: particle 30 goes from bin 3 to bin 7 on thread 0, and particle 70 from bin 7
/// to bin 3 on thread 1. Thread 1 begins when thread 0 has its first lock.
fn two_threads() -> String {
    let mut regions = ten();
    let recorder = Arc::new(Recorder::new());
    recorder.state.lock().note("at first", inside(&mut regions, [3, 7]));
    let watch: Arc<dyn Watch> = recorder.clone();
    regions.watch(&watch);
    let [one, other] =
        [(30, 3, 7), (70, 7, 3)].map(|(particle, from, to)| Change { particle, from, to });
    let ended = thread::scope(|scope| {
        let threads = [(0, one), (1, other)].map(|(number, change)| {
            let regions = &regions;
            let recorder = &recorder;
            scope.spawn(move || {
                THREAD.set(number);
                if number == 1 {
                    recorder.until(|threads| !threads[0].has.is_empty());
                }
                change_bin(regions, &mut Meter::default(), change);
            })
        });
        threads.map(|thread| thread.join().is_ok())
    });
    let state = &mut *recorder.state.lock();
    if ended == [true, true] {
        state.note("both are done", inside(&mut regions, [3, 7]));
    } else {
        state.over = false;
        state.note("both wait forever", Default::default());
    }
    state.table.to_string()
}

/// Shows the locks that changes of bins take, for regions of several sizes.
fn counts() -> Table {
    let headings = ["bins in a region", "from bin", "to bin", "locks taken", "held at once"];
    let mut table = Table::new(headings);
    for each in [1, 3, 12] {
        for (from, to) in [(2, 10), (10, 2), (4, 5)] {
            let mut regions = filled(12, each);
            let order = Arc::new(LockOrder::default());
            let watch: Arc<dyn Watch> = order.clone();
            regions.watch(&watch);
            let mut meter = Meter::default();
            change_bin(&regions, &mut meter, Change { particle: 30 * from as u32, from, to });
            table.row([&each, &from, &to, &meter.locks, &order.most_held()]);
        }
    }
    table
}

pub(crate) fn table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| within("4.3", 30, || format!("{}\n{}", counts(), two_threads())));
}
