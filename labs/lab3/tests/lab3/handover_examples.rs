//! The worked examples of particles and numbers that are handed over: in change buffers, by mail,
//! in a notice.

use common::soft::{Particle, Statistics};
use lab3::{Notice, rebin_by_one, take_arrivals, take_posted};
use oracle::{Ask, Columns, Random, Table, ascending};
use parking_lot::Mutex;
use solution2::{Grid, SortedBins, VecBins};

use super::bins::ids;
use super::mail::Mail;
use super::notices::readings;

/// Returns five particles in two bins along a wall: one in its bin, four in three change buffers.
fn five() -> [Particle; 5] {
    let places = [(0.5, 0.5), (0.5, 1.5), (1.5, 0.5), (1.2, 1.8), (0.8, 0.2)];
    std::array::from_fn(|k| {
        let (x, y) = places[k];
        Particle { x, y, id: k as u32, ..Particle::default() }
    })
}

/// Positions of the five particles before rebinning.
const BEFORE: [&str; 5] = [
    "bin 0",
    "buffer of worker 0",
    "buffer of worker 0",
    "buffer of worker 2",
    "buffer of worker 2",
];

/// Returns the change buffers of three workers.
fn buffers(five: &[Particle; 5]) -> [&[Particle]; 3] {
    [&five[1..3], &[], &five[3..]]
}

/// Returns the numbers of those `bins` that hold particle `id`. The first bin has number `first`.
fn holding(id: u32, first: usize, bins: &[Vec<Particle>]) -> String {
    let holds = |(_, inside): &(usize, &Vec<Particle>)| inside.iter().any(|p| p.id == id);
    ascending((first..).zip(bins).filter(holds).map(|(bin, _)| bin))
}

pub(crate) fn rebinning_by_one(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let five = five();
        let mut bins = VecBins::new(Grid::with_bins_along(2.0, 2));
        bins.put(five[0]);
        rebin_by_one(&mut bins, buffers(&five).into_iter());
        let mut table = Table::new(["particle", "x", "y", "is in", "afterwards in bin"]);
        for (p, before) in five.iter().zip(BEFORE) {
            table.row([&p.id, &p.x, &p.y, &before, &holding(p.id, 0, bins.bins())]);
        }
        table.to_string()
    });
}

pub(crate) fn rebinning_by_all(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let five = five();
        let mut bins = VecBins::new(Grid::with_bins_along(2.0, 2));
        bins.put(five[0]);
        let grid = *bins.grid();
        let (lower, upper) = bins.bins_mut().split_at_mut(2);
        for (first, own) in [(0, &mut *lower), (2, &mut *upper)] {
            take_arrivals(&grid, first, own, buffers(&five).into_iter());
        }
        let headings =
            ["particle", "x", "y", "is in", "afterwards in bin of worker 0", "of worker 1"];
        let mut table = Table::new(headings);
        for (p, before) in five.iter().zip(BEFORE) {
            let [of_0, of_1] = [holding(p.id, 0, lower), holding(p.id, 2, upper)];
            table.row([&p.id, &p.x, &p.y, &before, &of_0, &of_1]);
        }
        table.to_string()
    });
}

/// Returns particle `id` in the middle of a bin of row `row`.
fn letter(id: u32, row: u32) -> Particle {
    let x = 0.5 + f64::from(id % 6);
    Particle { x, y: 0.5 + f64::from(row), id, ..Particle::default() }
}

/// Returns the letters of three members. Member 1 owns rows 2 and 3.
fn posted() -> Mail {
    let mail: Mail = (0..3).map(|_| (0..3).map(|_| Mutex::default()).collect()).collect();
    mail[0][1].lock().push(letter(1, 2));
    mail[2][1].lock().extend([letter(9, 3), letter(8, 2)]);
    mail[2][0].lock().push(letter(7, 1));
    mail
}

pub(crate) fn mail(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut bins = SortedBins::new(Grid::with_bins_along(6.0, 6), 2..4);
        bins.refill([letter(4, 2), letter(5, 3)]);
        // Particle 5 has moved from row 3 to row 2.
        bins.particles_mut()[1].y = 2.9;
        let mail = posted();
        let headings = ["in row 2", "in row 3", "mail from 0", "from 1", "from 2", "from 2 to 0"];
        let mut table = Columns::new(headings.map(String::from));
        let mut row = |when: &str, bins: &SortedBins| {
            let rows = [2, 3].map(|row| ids(bins.bins(row, 0..6)));
            let letters = [(0, 1), (1, 1), (2, 1), (2, 0)];
            let letters = letters.map(|(from, to)| ids(&*mail[from][to].lock()));
            table.row(when, rows.into_iter().chain(letters));
        };
        row("before", &bins);
        take_posted(&mut bins, 1, &mail);
        row("after", &bins);
        table.to_string()
    });
}

pub(crate) fn notices(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["", "what is read", "dmin", "davg", "navg", "pair tests"]);
        let mut row = |when: &str, read: Option<Statistics>| match read {
            None => table.row([&when, &"nothing", &"-", &"-", &"-", &"-"]),
            Some(s) => table.row([&when, &"a notice", &s.dmin, &s.davg, &s.navg, &s.pair_tests]),
        };
        let posted = Statistics { dmin: 0.25, davg: 1.5, navg: 4, pair_tests: 9 };
        let notice = Notice::default();
        row("before it is posted", notice.read());
        let mut all: Vec<_> = readings(&posted).into_iter().map(|reading| reading.found).collect();
        all.sort_by_key(|read| {
            read.map(|s| (s.navg, s.pair_tests, s.dmin.to_bits(), s.davg.to_bits()))
        });
        all.dedup();
        all.into_iter().for_each(|read| row("while it is posted, perhaps", read));
        notice.post(&posted);
        row("when it is posted", notice.read());
        table.to_string()
    });
}
