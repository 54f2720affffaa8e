//! The worked examples of changes that are recorded or handed over.

use crossbeam::channel::unbounded;
use crossbeam::queue::SegQueue;
use lab4::{Change, Cut, Regions, apply_all, apply_own, post, receive, send, take};
use oracle::{Ask, Columns, Random};

use super::bins::{inside, ten};

/// Three changes among ten bins in two regions of five: two changes between the regions, and one
/// within region 1.
const CHANGES: [Change; 3] = [
    Change { particle: 30, from: 3, to: 7 },
    Change { particle: 70, from: 7, to: 3 },
    Change { particle: 60, from: 6, to: 8 },
];

/// Bins that the changes concern.
const BINS: [usize; 4] = [3, 6, 7, 8];

/// Two regions of five bins.
const CUT: Cut = Cut { bins_each: 5 };

/// A table of the bins at several moments.
struct Moments {
    regions: Regions,
    table: Columns,
}

impl Moments {
    fn new() -> Self {
        let table = Columns::new(BINS.map(|bin| format!("bin {bin}")));
        let mut moments = Self { regions: ten(), table };
        moments.note("at first");
        moments
    }

    fn note(&mut self, what: &str) {
        self.table.row(what, inside(&mut self.regions, BINS));
    }

    /// Shows the bins after each owner has made its part of the changes with `part`.
    fn by_owners(mut self, part: impl Fn(usize, &mut [Vec<u32>])) -> String {
        for own in 0..2 {
            part(own, self.regions.locks[own].get_mut());
            self.note(&format!("owner {own} has made its part"));
        }
        self.table.to_string()
    }
}

pub(crate) fn buffers(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let buffers = [&CHANGES[..2], &[], &CHANGES[2..]];
        let mut by_one = Moments::new();
        apply_all(&mut by_one.regions, buffers.into_iter());
        by_one.note("one thread has made all changes");
        let by_all = Moments::new().by_owners(|own, bins| {
            apply_own(CUT, own, bins, buffers.into_iter().flatten().copied());
        });
        format!("{}\n{by_all}", by_one.table)
    });
}

/// Shows the changes that each of two owners receives, in the order of the particles.
fn letters(sent: [Vec<Change>; 2]) -> Columns {
    let mut table = Columns::new(["of owner 0", "of owner 1"].map(String::from));
    for change in CHANGES {
        let cell = |sent: &Vec<Change>| {
            let times = sent.iter().filter(|letter| **letter == change).count();
            match times {
                0 => "-".into(),
                1 => "once".into(),
                _ => format!("{times} times"),
            }
        };
        let Change { particle, from, to } = change;
        let name = format!("particle {particle} from bin {from} to bin {to}");
        table.row(name, sent.iter().map(cell));
    }
    table
}

pub(crate) fn queues(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let queues = [SegQueue::new(), SegQueue::new()];
        CHANGES.iter().for_each(|change| post(CUT, &queues, *change));
        let sent = queues.each_ref().map(|queue| std::iter::from_fn(|| queue.pop()).collect());
        let sent = letters(sent);
        CHANGES.iter().for_each(|change| post(CUT, &queues, *change));
        let taken = Moments::new().by_owners(|own, bins| take(CUT, own, bins, &queues[own]));
        format!("{sent}\n{taken}")
    });
}

pub(crate) fn channels(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let (senders, receivers): (Vec<_>, Vec<_>) = (0..2).map(|_| unbounded()).unzip();
        CHANGES.iter().for_each(|change| send(CUT, &senders, *change));
        let sent = letters([0, 1].map(|owner: usize| receivers[owner].try_iter().collect()));
        CHANGES.iter().for_each(|change| send(CUT, &senders, *change));
        let received =
            Moments::new().by_owners(|own, bins| receive(CUT, own, bins, &receivers[own]));
        format!("{sent}\n{received}")
    });
}
