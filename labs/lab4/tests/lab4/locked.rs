//! Regions of bins, and what is asked of their locks.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

use common_threads::{Lock, LockOrder, Watch};
use lab4::{Change, Cut, Meter, Regions, change_bin};
use parking_lot::Mutex;

use crate::Random;

pub(super) const BINS: usize = 12;

/// The lock that was asked for last.
struct Asked(AtomicUsize);

impl Watch for Asked {
    fn asks(&self, lock: usize) {
        self.0.store(lock, Ordering::SeqCst);
    }
}

/// The number of each region's lock, as it is asked for.
pub(super) fn numbers(regions: &mut Regions) -> Vec<usize> {
    let asked = Arc::new(Asked(AtomicUsize::new(usize::MAX)));
    let watch: Arc<dyn Watch> = asked.clone();
    regions.watch(&watch);
    let number = |lock: &Lock<_>| {
        drop(lock.lock());
        asked.0.load(Ordering::SeqCst)
    };
    regions.locks.iter().map(number).collect()
}

/// Counts how often a lock is asked for.
#[derive(Default)]
struct Requests(AtomicUsize);

impl Watch for Requests {
    fn asks(&self, _lock: usize) {
        self.0.fetch_add(1, Ordering::SeqCst);
    }
}

/// A meter that asked for two locks, one after the other, while another thread held them; how long it
/// took to get both; and how often they were asked for.
pub(super) fn two_waits() -> (Meter, Duration, usize) {
    // On a busy machine a lock may be free again before it is asked for: then again.
    let mut tries = (0..20).map(|_| wait_twice());
    tries.find(|(meter, ..)| meter.contended == 2).unwrap_or_else(wait_twice)
}

fn wait_twice() -> (Meter, Duration, usize) {
    let (mut meter, mut waited, requests) = (Meter::default(), Duration::ZERO, Arc::default());
    for pause in [40, 20] {
        let mut lock = Lock::new(0, ());
        lock.watch(Arc::<Requests>::clone(&requests));
        let (lock, (held, go)) = (&lock, mpsc::channel());
        thread::scope(|scope| {
            scope.spawn(move || {
                let _guard = lock.lock();
                held.send(()).expect("the meter waits");
                thread::sleep(Duration::from_millis(pause));
            });
            go.recv().expect("the lock is held");
            let start = Instant::now();
            drop(meter.lock(lock));
            waited += start.elapsed();
        });
    }
    (meter, waited, requests.0.load(Ordering::SeqCst))
}

/// Regions of `bins_each` bins with 30 particles in each bin, number b · 30 and on in bin b.
pub(super) fn filled(bins: usize, bins_each: usize) -> Regions {
    let region = |number: usize| {
        let first = number * bins_each;
        let bin = |bin: usize| (0..30).map(|k| (bin * 30 + k) as u32).collect();
        Lock::new(number, (first..bins.min(first + bins_each)).map(bin).collect())
    };
    let locks = (0..bins.div_ceil(bins_each)).map(region).collect();
    Regions { cut: Cut { bins_each }, locks }
}

/// Changes of 132 of the 360 particles of 12 bins, one from each bin to each other one, in 17 buffers.
pub(super) fn changes(random: &mut Random) -> Vec<Vec<Change>> {
    let mut all = Vec::new();
    for from in 0..BINS {
        let mut numbers: Vec<u32> = (0..30).map(|k| (30 * from + k) as u32).collect();
        random.shuffle(&mut numbers);
        let targets = (0..BINS).filter(|to| *to != from);
        all.extend(targets.zip(numbers).map(|(to, particle)| Change { particle, from, to }));
    }
    random.shuffle(&mut all);
    all.chunks(8).map(<[Change]>::to_vec).collect()
}

/// The bin of a particle that began in bin p / 30 and has been sent on so often, five bins each time.
pub(super) fn sent_on(particle: u32, times: u32) -> usize {
    ((particle / 30 + 5 * times) % 12) as usize
}

/// 12 bins, `each` in a region, when each of four threads has sent every fourth particle on so often; and
/// the locks that it took.
pub(super) fn sent_by_four(each: usize, times: u32) -> (Regions, u64) {
    let mut regions = filled(BINS, each);
    let watch: Arc<dyn Watch> = Arc::new(LockOrder::default());
    regions.watch(&watch);
    let shared = &regions;
    let send = |number: u32| {
        let mut meter = Meter::default();
        for round in 0..times {
            for particle in (number..360).step_by(4) {
                let (from, to) = (sent_on(particle, round), sent_on(particle, round + 1));
                change_bin(shared, &mut meter, Change { particle, from, to });
            }
        }
        meter.locks
    };
    let locks = thread::scope(|scope| {
        let threads = [0, 1, 2, 3].map(|number| scope.spawn(move || send(number)));
        threads.map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)))
    });
    (regions, locks.iter().sum())
}

/// When thread `victim` asks for a lock for the second time, another thread comes in and does
/// something, and the victim waits until it has, or until it is clear that it cannot.
struct Intruder {
    victim: ThreadId,
    requests: AtomicUsize,
    go: mpsc::Sender<()>,
    done: Mutex<mpsc::Receiver<()>>,
}

impl Watch for Intruder {
    fn asks(&self, _lock: usize) {
        let own = thread::current().id() == self.victim;
        if own && self.requests.fetch_add(1, Ordering::SeqCst) == 1 {
            let _ = self.go.send(());
            let _ = self.done.lock().recv_timeout(Duration::from_millis(100));
        }
    }
}

/// 12 bins, three in a region, after two changes from bin 2 to bin 10: one of particle 89, the last of
/// its bin, and one of particle 61, which another thread makes between the requests of the first.
pub(super) fn changed_by_two() -> Regions {
    let mut regions = filled(12, 3);
    let ((go, come), (finished, done)) = (mpsc::channel(), mpsc::channel());
    let (victim, requests) = (thread::current().id(), AtomicUsize::new(0));
    let watch: Arc<dyn Watch> = Arc::new(Intruder { victim, requests, go, done: Mutex::new(done) });
    regions.watch(&watch);
    let shared = &regions;
    let change = |particle| {
        change_bin(shared, &mut Meter::default(), Change { particle, from: 2, to: 10 });
    };
    thread::scope(|scope| {
        scope.spawn(move || {
            if come.recv_timeout(Duration::from_secs(2)).is_ok() {
                change(61);
                let _ = finished.send(());
            }
        });
        // Where it is depends on the other particles.
        change(89);
    });
    regions
}
