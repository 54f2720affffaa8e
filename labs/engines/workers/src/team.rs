//! Threads that live as long as their owner and work in rounds.
//!
//! The caller starts a round and takes part in it as thread 0. Between rounds a thread first spins,
//! which means that it tests again and again whether the next round has begun. A thread that spins
//! notices a round within a microsecond; a thread that sleeps needs tens of microseconds to wake. A
//! thread that has waited for [`SPIN`] sleeps, so that other programs can use its core.
//!
//! A round does not wait for sleepers. A thread enters the round when it notices the round, and the
//! caller closes the round when no work remains. So a thread that gets no core only reduces the
//! speed.

use std::any::Any;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError, RwLock, TryLockError};
use std::thread::{self, Builder, JoinHandle, Thread};
use std::time::{Duration, Instant};

/// Time for which a waiting thread spins before it sleeps.
const SPIN: Duration = Duration::from_micros(50);
/// Number of tests for a round between two looks at the clock.
const LOOKS: usize = 64;
/// The number of the round that ends the threads.
const END: usize = usize::MAX;

/// The work of a round, called on a thread with the thread's number.
type Act<'a> = &'a (dyn Fn(usize) + Sync);

/// Threads that wait for rounds. Dropping the team ends the threads.
pub struct Team {
    shared: Arc<Shared>,
    /// The number of the last round. The caller holds the lock during a round.
    last: Mutex<usize>,
    threads: Vec<JoinHandle<()>>,
    /// Number of threads that a round wakes, so that there are no more threads than cores.
    helpers: usize,
}

/// The state that the threads share.
#[derive(Default)]
struct Shared {
    /// The number of the last round that has begun.
    begun: Line<AtomicUsize>,
    /// The round that threads may enter.
    open: RwLock<Option<Round>>,
    /// Number of threads that have entered the round.
    entered: Line<AtomicUsize>,
    /// Number of threads that have left the round.
    left: Line<AtomicUsize>,
    /// The payload of a thread's panic in this round.
    panic: Mutex<Option<Box<dyn Any + Send>>>,
}

/// A round of work.
#[derive(Clone)]
struct Round {
    number: usize,
    act: Act<'static>,
    /// The thread that waits for the end of the round.
    caller: Thread,
}

/// A value on its own cache lines, so that writes to neighbouring values do not slow its readers.
#[derive(Default)]
#[repr(align(128))]
struct Line<T>(T);

impl Team {
    /// Starts a team of `count` threads, of which the caller is one.
    pub(crate) fn start(count: usize) -> io::Result<Self> {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let helpers = count.min(cores) - 1;
        let shared = Arc::<Shared>::default();
        let mut team = Self { shared, last: Mutex::default(), threads: Vec::new(), helpers };
        for number in 1..count {
            let shared = Arc::clone(&team.shared);
            let name = format!("worker {number}");
            team.threads.push(Builder::new().name(name).spawn(move || shared.serve(number))?);
        }
        Ok(team)
    }

    /// Returns the number of threads, including the caller.
    pub(crate) fn count(&self) -> usize {
        self.threads.len() + 1
    }

    /// Calls `act` with 0 on this thread. On each thread that wakes in time, calls `act` with the
    /// thread's number.
    ///
    /// The call with 0 must do all work that no other thread has begun.
    pub(crate) fn share(&self, act: Act<'_>) {
        self.round(self.helpers, 0, act);
    }

    /// Calls `act` once on every thread, with the thread's number, and waits for all calls.
    pub(crate) fn on_each(&self, act: Act<'_>) {
        self.round(self.threads.len(), self.threads.len(), act);
    }

    /// Wakes `helpers` threads for a round, and waits until at least `least` of them have left it.
    ///
    /// If the team is in a round already, the caller makes all calls alone, because this call may
    /// be a part of that round.
    fn round(&self, helpers: usize, least: usize, act: Act<'_>) {
        let mut last = match self.last.try_lock() {
            Ok(last) => last,
            Err(TryLockError::Poisoned(last)) => last.into_inner(),
            Err(TryLockError::WouldBlock) => return (0..=least).for_each(act),
        };
        *last += 1;
        let Shared { begun, entered, left, panic, .. } = &*self.shared;
        entered.0.store(0, Ordering::Relaxed);
        left.0.store(0, Ordering::Relaxed);
        // SAFETY: only the lifetime changes. A thread gets `act` from `open`, where it counts as
        // entered under the lock, and counts as left after its last use of `act`. Below, `open` is
        // emptied under the same lock, so no thread enters later, and this function waits until all
        // that have entered have left. This holds even if `act` panics, here or on a thread. So no
        // thread has `act` when this function returns.
        #[allow(unsafe_code)]
        let lasting = unsafe { std::mem::transmute::<Act<'_>, Act<'static>>(act) };
        self.shared.open(Some(Round { number: *last, act: lasting, caller: thread::current() }));
        begun.0.store(*last, Ordering::Release);
        self.threads[..helpers].iter().for_each(|thread| thread.thread().unpark());
        let own = catch_unwind(AssertUnwindSafe(|| act(0)));
        wait(|| left.0.load(Ordering::Acquire) >= least);
        self.shared.open(None);
        let all = entered.0.load(Ordering::Relaxed);
        wait(|| left.0.load(Ordering::Acquire) == all);
        let other = panic.lock().unwrap_or_else(PoisonError::into_inner).take();
        drop(last);
        if let Some(panic) = own.err().or(other) {
            resume_unwind(panic);
        }
    }
}

impl Drop for Team {
    fn drop(&mut self) {
        self.shared.begun.0.store(END, Ordering::Release);
        for thread in self.threads.drain(..) {
            thread.thread().unpark();
            // A thread catches the panics of its work, and does not panic elsewhere.
            let _ = thread.join();
        }
    }
}

impl Shared {
    fn open(&self, round: Option<Round>) {
        *self.open.write().unwrap_or_else(PoisonError::into_inner) = round;
    }

    /// Enters the open round, if there is a round with a number above `last`.
    fn enter(&self, last: usize) -> Option<Round> {
        let open = self.open.read().unwrap_or_else(PoisonError::into_inner);
        let round = open.clone().filter(|round| round.number > last)?;
        self.entered.0.fetch_add(1, Ordering::Relaxed);
        Some(round)
    }

    /// Works in rounds as thread `number`, until the end.
    fn serve(&self, number: usize) {
        let mut seen = 0;
        let mut last = 0;
        while seen != END {
            wait(|| self.begun.0.load(Ordering::Acquire) != seen);
            seen = self.begun.0.load(Ordering::Acquire);
            let Some(round) = self.enter(last) else { continue };
            last = round.number;
            if let Err(panic) = catch_unwind(AssertUnwindSafe(|| (round.act)(number))) {
                *self.panic.lock().unwrap_or_else(PoisonError::into_inner) = Some(panic);
            }
            self.left.0.fetch_add(1, Ordering::Release);
            round.caller.unpark();
        }
    }
}

/// Waits until `is_over`: spins first, then sleeps. A thread that changes the answer must then
/// unpark this thread.
fn wait(is_over: impl Fn() -> bool) {
    let start = Instant::now();
    loop {
        for _ in 0..LOOKS {
            if is_over() {
                return;
            }
            std::hint::spin_loop();
        }
        if start.elapsed() >= SPIN {
            // If another thread has called `unpark` since the last test, `park` returns
            // immediately.
            thread::park();
        }
    }
}
