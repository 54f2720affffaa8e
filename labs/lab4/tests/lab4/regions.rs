//! Questions about regions of bins and their locks.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use common_threads::{Lock, Watch};
use lab4::{Cut, Regions};
use oracle::{Ask, Random, Table, integers, spaced};

/// Asks for the sizes of few and many regions, of few and many bins.
pub(crate) fn sizes(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..60 {
        // Every tenth case has many regions and many bins.
        let most = if case % 10 == 9 { 70_000 } else { 1025 };
        let bins = 1 + random.size(most);
        let count = 1 + random.size(most);
        let found = || integers(Regions::new(bins, count).parts_mut().map(|bins| bins.len()));
        let question =
            format!("{bins} bins in at most {count} regions: number of bins in each region");
        ask.exact(&question, found, || {
            let each = bins.div_ceil(count);
            integers((0..bins.div_ceil(each)).map(|number| each.min(bins - number * each)))
        });
    }
}

/// Asks for the region of any bin in regions of any size.
pub(crate) fn places(random: &mut Random, ask: &mut impl Ask) {
    for _ in 0..60 {
        let each = 1 + random.size(70_000);
        for bin in [random.size(70_000), random.size(1 << 40)] {
            let found = || {
                let (region, index) = Cut { bins_each: each }.find(bin);
                integers([region, index])
            };
            let question = format!(
                "bin {bin}, {each} bins in each region: (1) the bin's region, (2) the bin's index in this region"
            );
            ask.exact(&question, found, || integers([bin / each, bin % each]));
        }
    }
}

/// The lock that was requested last.
struct Asked(AtomicUsize);

impl Watch for Asked {
    fn asks(&self, lock: usize) {
        self.0.store(lock, Ordering::SeqCst);
    }
}

/// Returns the number of each region's lock.
fn numbers_of(regions: &mut Regions) -> Vec<usize> {
    let asked = Arc::new(Asked(AtomicUsize::new(usize::MAX)));
    let watch: Arc<dyn Watch> = asked.clone();
    regions.watch(&watch);
    let number = |lock: &Lock<_>| {
        drop(lock.lock());
        asked.0.load(Ordering::SeqCst)
    };
    regions.locks.iter().map(number).collect()
}

/// Asks for the number of each region's lock, as seen in the requests.
pub(crate) fn numbers(random: &mut Random, ask: &mut impl Ask) {
    let count = 5 + random.below(300);
    let found = || integers(numbers_of(&mut Regions::new(9 * count, count)));
    let question = format!("{count} regions of 9 bins: number of the lock of each region");
    ask.exact(&question, found, || integers(0..count));
}

/// Shows the worked example.
pub(crate) fn table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let headings = ["bins", "regions at most", "bins in each", "numbers of the locks"];
        let mut regions = Table::new(headings);
        for (bins, count) in [(12, 1), (12, 3), (12, 5), (10, 4), (3, 5)] {
            let mut made = Regions::new(bins, count);
            let sizes = spaced(made.parts_mut().map(|bins| bins.len()));
            regions.row([&bins, &count, &sizes, &spaced(numbers_of(&mut made))]);
        }
        let mut bins = Table::new(["bins in each region", "bin", "its region", "its index there"]);
        for bin in [0, 4, 5, 9, 11] {
            let (region, index) = Cut { bins_each: 5 }.find(bin);
            bins.row([&5, &bin, &region, &index]);
        }
        format!("{regions}\n{bins}")
    });
}
