//! Questions about a change of bins that another thread interrupts.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};
use std::thread::{self, ThreadId};
use std::time::Duration;

use common_threads::Watch;
use lab4::{Change, Meter, Regions, change_bin};
use oracle::{Ask, Random, truth};
use parking_lot::Mutex;

use super::bins::filled;
use super::locks::{BINS, ask_bins};

/// A second thread that acts when thread `victim` requests a lock for the second time. The victim
/// waits until the second thread has finished, or for `patience`.
struct Intruder {
    victim: ThreadId,
    patience: Duration,
    requests: AtomicUsize,
    go: mpsc::Sender<()>,
    done: Mutex<mpsc::Receiver<()>>,
    /// Whether the other thread finished while the victim waited.
    in_time: Arc<AtomicBool>,
}

impl Watch for Intruder {
    fn asks(&self, _lock: usize) {
        let own = thread::current().id() == self.victim;
        if own && self.requests.fetch_add(1, Ordering::SeqCst) == 1 {
            let _ = self.go.send(());
            let in_time = self.done.lock().recv_timeout(self.patience).is_ok();
            self.in_time.store(in_time, Ordering::SeqCst);
        }
    }
}

/// Makes a change, during which another thread makes the change `other` between two lock requests.
/// Returns whether the other change was finished while the first waited.
fn in_between(regions: &mut Regions, one: Change, other: Change, patience: Duration) -> bool {
    let (go, come) = mpsc::channel();
    let (finished, done) = mpsc::channel();
    let in_time = Arc::new(AtomicBool::new(false));
    let watch: Arc<dyn Watch> = Arc::new(Intruder {
        victim: thread::current().id(),
        patience,
        requests: AtomicUsize::new(0),
        go,
        done: Mutex::new(done),
        in_time: Arc::clone(&in_time),
    });
    regions.watch(&watch);
    let shared = &*regions;
    thread::scope(|scope| {
        scope.spawn(move || {
            if come.recv_timeout(Duration::from_secs(2)).is_ok() {
                change_bin(shared, &mut Meter::default(), other);
                let _ = finished.send(());
            }
        });
        change_bin(shared, &mut Meter::default(), one);
    });
    in_time.load(Ordering::SeqCst)
}

/// Asks about two changes from one bin to another, up and down. One change concerns the last
/// particle of the bin. The other is of a particle that another thread moves between the lock
/// requests of the first change.
pub(crate) fn same_bins(random: &mut Random, ask: &mut impl Ask) {
    let low = random.below(6);
    let high = 6 + random.below(6);
    for (from, to) in [(low, high), (high, low)] {
        let [last, other] = [29, random.below(29)].map(|k| (30 * from + k) as u32);
        let change = |particle| Change { particle, from, to };
        let mut regions = filled(BINS, 3);
        in_between(&mut regions, change(last), change(other), Duration::from_millis(100));
        let name = format!(
            "12 bins in regions of 3. At the same time, one thread moves particle {other} and another thread moves \
             particle {last} from bin {from} to bin {to}"
        );
        ask_bins(ask, &name, &mut regions, |particle| {
            if [other, last].contains(&particle) { to } else { particle as usize / 30 }
        });
    }
}

/// Asks about a change between two other regions, which need not wait.
pub(crate) fn other_regions(_: &mut Random, ask: &mut impl Ask) {
    let one = Change { particle: 89, from: 2, to: 10 };
    let other = Change { particle: 120, from: 4, to: 8 };
    let found = || in_between(&mut filled(BINS, 3), one, other, Duration::from_secs(5));
    let question = "12 bins, 3 in each region. A thread moves a particle from bin 2 to bin 10, and holds one of the \
                    two locks that it needs: 1 if another thread can move a particle from bin 4 to bin 8 at that \
                    moment, 0 if not";
    ask.exact(question, || vec![truth(found())], || vec![1.0]);
}
