//! What tests and probe ask alike about the locks of regions of bins.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};
use std::thread::{self, ScopedJoinHandle, ThreadId};
use std::time::{Duration, Instant};

use common_threads::{Lock, LockOrder, Watch};
use lab4::{Change, Cut, Meter, Regions, change_bin};
use parking_lot::Mutex;

use super::ask::{Ask, truth, whole};
use crate::Random;

const BINS: usize = 12;

/// The lock that was asked for last.
struct Asked(AtomicUsize);

impl Watch for Asked {
    fn asks(&self, lock: usize) {
        self.0.store(lock, Ordering::SeqCst);
    }
}

/// The number of each region's lock, as it is asked for.
pub(super) fn numbers(random: &mut Random, ask: Ask<'_>) {
    let count = 5 + random.below(300);
    let mut regions = Regions::new(9 * count, count);
    let asked = Arc::new(Asked(AtomicUsize::new(usize::MAX)));
    let watch: Arc<dyn Watch> = asked.clone();
    regions.watch(&watch);
    let number = |lock: &Lock<_>| {
        drop(lock.lock());
        asked.0.load(Ordering::SeqCst) as f64
    };
    let found = regions.locks.iter().map(number).collect();
    ask(&format!("the numbers of the locks of {count} regions"), found, whole(0..count));
}

/// A free lock, which costs no look at the clock, and two that another thread holds, which are waited for.
pub(super) fn meters(random: &mut Random, ask: Ask<'_>) {
    let (lock, mut meter) = (Lock::new(0, 5.0), Meter::default());
    let times = 257 + random.below(500);
    (0..times).for_each(|_| *meter.lock(&lock) += 1.0);
    let question = format!(
        "a free lock, {times} times: what it guards, 5 before; locks taken, locks waited for, time waited"
    );
    ask(
        &question,
        vec![*lock.lock(), meter.locks as f64, meter.contended as f64, meter.waiting.as_secs_f64()],
        vec![times as f64 + 5.0, times as f64, 0.0, 0.0],
    );
    let (meter, waited, requests) = two_waits();
    let measured = meter.waiting > waited / 2 && meter.waiting <= waited;
    let name = "two locks that another thread holds";
    let counts = vec![meter.locks as f64, meter.contended as f64];
    ask(&format!("{name}: locks taken, locks waited for"), counts, vec![2.0, 2.0]);
    let question = format!("{name}: are both waits measured, 1 for yes");
    ask(&question, vec![truth(measured)], vec![1.0]);
    let question = format!("{name}: are they asked for again and again in a loop, 1 for yes");
    ask(&question, vec![truth(requests > 6)], vec![0.0]);
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
fn two_waits() -> (Meter, Duration, usize) {
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

/// The bin of each of the particles of 12 bins, -1 for none, and how many particles there are in all bins together.
fn bins_of(regions: &mut Regions) -> Vec<f64> {
    let (mut found, mut all) = (vec![-1.0; 30 * BINS + 1], 0.0);
    let lists = regions.locks.iter_mut().flat_map(|lock| lock.get_mut().clone());
    for (bin, list) in (0..).zip(lists) {
        all += list.len() as f64;
        list.into_iter().for_each(|particle| found[particle as usize] = f64::from(bin));
    }
    found[30 * BINS] = all;
    found
}

fn ask_bins(ask: Ask<'_>, name: &str, regions: &mut Regions, right: impl Fn(u32) -> usize) {
    let found = bins_of(regions);
    let right: Vec<f64> = (0..360).map(|particle| right(particle) as f64).chain([360.0]).collect();
    let question = match (0..360).find(|particle| found[*particle] != right[*particle]) {
        Some(particle) => {
            let question = format!("{name}: the bin of particle {particle}, -1 for none");
            return ask(&question, vec![found[particle]], vec![right[particle]]);
        }
        None => format!("{name}: how many particles are in all bins together, of 360"),
    };
    ask(&question, vec![found[360]], vec![360.0]);
}

/// Changes one after the other, as several threads might make them: what they cost, the most locks at once, and
/// where the particles are; also of bins and particles of large numbers.
pub(super) fn one_by_one(random: &mut Random, ask: Ask<'_>) {
    for each in [1, 3, 12] {
        let mut regions = filled(BINS, each);
        let order = Arc::new(LockOrder::default());
        let watch: Arc<dyn Watch> = order.clone();
        regions.watch(&watch);
        let (mut meter, changes) = (Meter::default(), changes(random).concat());
        changes.iter().for_each(|change| change_bin(&regions, &mut meter, *change));
        let name = format!("132 changes, {each} of 12 bins in a region");
        let two = changes.iter().filter(|change| change.from / each != change.to / each).count();
        ask(
            &format!("{name}: locks taken, locks waited for, most at once"),
            vec![meter.locks as f64, meter.contended as f64, order.most_held() as f64],
            vec![(132 + two) as f64, 0.0, if each == 12 { 1.0 } else { 2.0 }],
        );
        ask_bins(ask, &name, &mut regions, |particle| {
            let change = changes.iter().find(|change| change.particle == particle);
            change.map_or(particle as usize / 30, |change| change.to)
        });
    }
    let (from, to, particle) = (65_537, 69_999, u32::MAX - 1);
    let region = |number| Lock::new(number, vec![Vec::new(); 7]);
    let mut regions =
        Regions { cut: Cut { bins_each: 7 }, locks: (0..10_000).map(region).collect() };
    regions.locks[from / 7].get_mut()[from % 7].extend([5, particle]);
    let mut meter = Meter::default();
    change_bin(&regions, &mut meter, Change { particle, from, to });
    let mut told = vec![meter.locks as f64];
    told.extend([from, to].iter().flat_map(|bin| regions.bin_mut(*bin).clone()).map(f64::from));
    let question = format!(
        "particle {particle} changes from bin {from} of 70000, where there is 5 too, to {to}: locks taken, who \
         is in the two bins"
    );
    ask(&question, told, vec![2.0, 5.0, f64::from(particle)]);
}

/// Changes by several threads at the same time.
pub(super) fn many_threads(random: &mut Random, ask: Ask<'_>) {
    for each in [1, 3, 12] {
        let (threads, times) = (3 + random.below(9), 20 + random.below(12));
        let (mut regions, taken) = sent(each, threads, times as u32);
        let name = format!(
            "{times} changes of each of 360 particles by {threads} threads, {each} of 12 bins in a region"
        );
        let locks = if each == 12 { 360 * times } else { 720 * times };
        ask(&format!("{name}: locks taken"), vec![taken as f64], whole([locks]));
        ask_bins(ask, &name, &mut regions, |particle| sent_on(particle, times as u32));
    }
}

/// The bin of a particle that began in bin p / 30 and has been sent on so often, five bins each time.
fn sent_on(particle: u32, times: u32) -> usize {
    ((particle / 30 + 5 * times) % 12) as usize
}

/// 12 bins, `each` in a region, when each of some threads has sent its part of the particles on so often; and the locks
/// that it took.
fn sent(each: usize, threads: usize, times: u32) -> (Regions, u64) {
    let mut regions = filled(BINS, each);
    let watch: Arc<dyn Watch> = Arc::new(LockOrder::default());
    regions.watch(&watch);
    let shared = &regions;
    let send = |number: usize| {
        let mut meter = Meter::default();
        for round in 0..times {
            for particle in (number as u32..360).step_by(threads) {
                let (from, to) = (sent_on(particle, round), sent_on(particle, round + 1));
                change_bin(shared, &mut meter, Change { particle, from, to });
            }
        }
        meter.locks
    };
    let locks = thread::scope(|scope| {
        let start = |number| scope.spawn(move || send(number));
        let threads: Vec<_> = (0..threads).map(start).collect();
        let locks = |thread: ScopedJoinHandle<'_, u64>| {
            thread.join().unwrap_or_else(|panic| resume_unwind(panic))
        };
        threads.into_iter().map(locks).sum()
    });
    (regions, locks)
}

/// When thread `victim` asks for a lock for the second time, another thread comes in and does
/// something, and the victim waits until it has, or for `patience`.
struct Intruder {
    victim: ThreadId,
    patience: Duration,
    requests: AtomicUsize,
    go: mpsc::Sender<()>,
    done: Mutex<mpsc::Receiver<()>>,
    /// Whether the other thread has done it while the victim waited.
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

/// One change, and another that another thread makes between the requests of the first. Whether it was done while the
/// first one waited.
fn in_between(regions: &mut Regions, one: Change, other: Change, patience: Duration) -> bool {
    let ((go, come), (finished, done)) = (mpsc::channel(), mpsc::channel());
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
    let change = |change| change_bin(shared, &mut Meter::default(), change);
    thread::scope(|scope| {
        scope.spawn(move || {
            if come.recv_timeout(Duration::from_secs(2)).is_ok() {
                change(other);
                let _ = finished.send(());
            }
        });
        // Where it is depends on the other particles.
        change(one);
    });
    in_time.load(Ordering::SeqCst)
}

/// Two changes from one bin to another, up and down: one of the last particle of its bin, and one of another, which
/// another thread makes between the requests of the first.
pub(super) fn another_between(random: &mut Random, ask: Ask<'_>) {
    let (low, high) = (random.below(6), 6 + random.below(6));
    for (from, to) in [(low, high), (high, low)] {
        let [last, other] = [29, random.below(29)].map(|k| (30 * from + k) as u32);
        let change = |particle| Change { particle, from, to };
        let mut regions = filled(BINS, 3);
        in_between(&mut regions, change(last), change(other), Duration::from_millis(100));
        let name = format!(
            "particles {other} and {last} change from bin {from} to {to}, by two threads at once, 3 of 12 bins in a region"
        );
        let right = |p| if [other, last].contains(&p) { to } else { p as usize / 30 };
        ask_bins(ask, &name, &mut regions, right);
    }
}

/// A change between two other regions, in between: it need not wait.
pub(super) fn elsewhere(ask: Ask<'_>) {
    let one = Change { particle: 89, from: 2, to: 10 };
    let other = Change { particle: 120, from: 4, to: 8 };
    let went_on = in_between(&mut filled(BINS, 3), one, other, Duration::from_secs(5));
    let question = "a thread holds the lock of region 0 and asks for that of region 3: can another one change a bin of \
                    region 1 for one of region 2 meanwhile, 1 for yes";
    ask(question, vec![truth(went_on)], vec![1.0]);
}
