//! Questions about the cost of a lock.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};
use std::thread;
use std::time::{Duration, Instant};

use common_threads::{Lock, Stopwatch, Watch};
use lab4::Meter;
use oracle::{Ask, Random, Table, integers};

/// Asks about a lock that no other thread wants, with a new meter and with a meter that has waited.
pub(crate) fn free(random: &mut Random, ask: &mut impl Ask) {
    for waits in [0, 1 + random.below(9)] {
        let times = 257 + random.below(500);
        let waited = Duration::from_millis(3 * waits as u64);
        let found = || {
            let lock = Lock::new(0, 5.0);
            let contended = waits as u64;
            let mut meter =
                Meter { locks: contended, contended, waiting: waited, ..Meter::default() };
            let before = Stopwatch::started();
            (0..times).for_each(|_| *meter.lock(&lock) += 1.0);
            let started = Stopwatch::started() - before;
            let guarded = *lock.lock();
            let counts = [meter.locks, meter.contended].map(|count| count as f64);
            vec![guarded, counts[0], counts[1], meter.waiting.as_secs_f64(), started as f64]
        };
        let question = format!(
            "a meter that has waited for {waits} locks before. It takes a free lock {times} times. The lock guards a \
             number that is 5 at first, and each time 1 is added to this number: (1) the number at the end, (2) locks \
             taken, (3) locks waited for, (4) seconds waited, (5) stopwatches started"
        );
        let [times, waits] = [times, waits].map(|count| count as f64);
        let right = vec![times + 5.0, times + waits, waits, waited.as_secs_f64(), 0.0];
        ask.exact(&question, found, || right);
    }
}

/// A counter of lock requests.
#[derive(Default)]
pub(crate) struct Requests(AtomicUsize);

impl Requests {
    /// Returns the number of requests so far.
    pub(crate) fn count(&self) -> usize {
        self.0.load(Ordering::SeqCst)
    }
}

impl Watch for Requests {
    fn asks(&self, _lock: usize) {
        self.0.fetch_add(1, Ordering::SeqCst);
    }
}

/// Two locks that a meter requested one after the other while another thread held them.
struct Waits {
    meter: Meter,
    /// Time until the meter had both locks.
    waited: Duration,
    /// Number of lock requests by both threads.
    requests: usize,
}

impl Waits {
    fn measured() -> Self {
        // On a busy machine a lock may be free before the meter requests it. The measurement is
        // then repeated.
        let mut tries = (0..20).map(|_| Self::once());
        tries.find(|waits| waits.meter.contended == 2).unwrap_or_else(Self::once)
    }

    fn once() -> Self {
        let mut meter = Meter::default();
        let mut waited = Duration::ZERO;
        let requests = Arc::<Requests>::default();
        for pause in [40, 20] {
            let mut lock = Lock::new(0, ());
            lock.watch(Arc::<Requests>::clone(&requests));
            let lock = &lock;
            let (held, go) = mpsc::channel();
            thread::scope(|scope| {
                scope.spawn(move || {
                    let _guard = lock.lock();
                    held.send(()).expect("the meter waits for the lock");
                    thread::sleep(Duration::from_millis(pause));
                });
                go.recv().expect("the lock is held");
                let start = Instant::now();
                drop(meter.lock(lock));
                waited += start.elapsed();
            });
        }
        Self { meter, waited, requests: requests.count() }
    }
}

/// Asks about two locks that another thread holds.
pub(crate) fn held(_: &mut Random, ask: &mut impl Ask) {
    let Waits { meter, waited, requests } = Waits::measured();
    let name = "two locks, each held by another thread for some milliseconds";
    let question = format!("{name}: (1) locks taken, (2) locks waited for");
    let counts = [meter.locks, meter.contended].map(|count| count as f64);
    ask.exact(&question, || counts.to_vec(), || vec![2.0, 2.0]);
    let question = format!(
        "{name}: seconds of both waits together, (1) measured by the meter, (2) measured by a clock around both waits"
    );
    let times = [meter.waiting, waited].map(|time| time.as_secs_f64());
    ask.judge(
        &question,
        || times.to_vec(),
        |found| match found {
            [metered, clock] if *metered > clock / 2.0 && metered <= clock => Ok(()),
            _ => Err(format!("     found: {found:?}\n  expected: two times that are nearly equal")),
        },
    );
    let question = format!("{name}: number of requests for the locks, by both threads together");
    ask.judge(
        &question,
        || integers([requests]),
        |found| match found {
            [requests] if *requests <= 6.0 => Ok(()),
            _ => Err(format!(
                "{found:?} requests: the thread requests the lock again and again in a loop, but it must wait for the \
                 lock instead"
            )),
        },
    );
}

/// Takes a lock, which another thread holds at first. The other thread releases it when the meter
/// has requested it twice, or after two seconds.
fn wait_for_it(meter: &mut Meter) {
    let mut lock = Lock::new(0, ());
    let requests = Arc::<Requests>::default();
    lock.watch(Arc::<Requests>::clone(&requests));
    let lock = &lock;
    let requests = &requests;
    let (held, go) = mpsc::channel();
    thread::scope(|scope| {
        scope.spawn(move || {
            let _guard = lock.lock();
            held.send(()).expect("the meter waits for the lock");
            let end = Instant::now() + Duration::from_secs(2);
            // The first of the counted requests is this thread's own.
            while requests.count() < 3 && Instant::now() < end {
                thread::yield_now();
            }
            thread::sleep(Duration::from_millis(5));
        });
        go.recv().expect("the lock is held");
        drop(meter.lock(lock));
    });
}

/// Shows the worked example: a meter, moment by moment.
pub(crate) fn table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["", "locks taken", "locks waited for", "time waited"]);
        let mut meter = Meter::default();
        let free = Lock::new(0, ());
        let mut row = |what: &str, meter: &Meter| {
            let time = if meter.waiting.is_zero() { "0" } else { "more than 0" };
            table.row([&what, &meter.locks, &meter.contended, &time]);
        };
        row("at first", &meter);
        for _ in 0..2 {
            drop(meter.lock(&free));
            row("a free lock is taken", &meter);
        }
        for _ in 0..2 {
            wait_for_it(&mut meter);
            row("a lock is taken that another thread held", &meter);
        }
        drop(meter.lock(&free));
        row("a free lock is taken", &meter);
        table.to_string()
    });
}
