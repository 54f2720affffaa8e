//! Questions about the mail of a team's member.

use std::ops::Range;

use common::soft::Particle;
use lab3::take_posted;
use oracle::{Ask, Random, integers, truth};
use parking_lot::Mutex;
use solution2::{Grid, SortedBins};

use super::bins::states;
use super::workers::some_rows;

/// Mail of a team: `mail[from][to]` holds the particles on their way from one member to another.
pub(crate) type Mail = Vec<Vec<Mutex<Vec<Particle>>>>;

/// A member's particles and the team's mail.
struct Case {
    number: usize,
    bins: SortedBins,
    mail: Mail,
}

impl Case {
    fn drawn(random: &mut Random, case: usize) -> Self {
        let along = [6, 300][case % 2];
        let rows = some_rows(random, along - 1);
        let mut letters = Letters { along, rows: rows.start..rows.end + 1, id: 0 };
        let mut bins = SortedBins::new(Grid::with_bins_along(1.0, along), letters.rows.clone());
        let own = random.size(33);
        bins.refill((0..own).map(|_| letters.next(random)));
        // The particles have moved within the rows since they were sorted.
        let moved = |p: &Particle, to: Particle| Particle { id: p.id, ..to };
        bins.particles_mut().iter_mut().for_each(|p| *p = moved(p, letters.next(random)));
        let members = 1 + random.size(40);
        let number = random.below(members);
        let mut mail = Mail::new();
        for _ in 0..members {
            let count = random.below(2) * random.size(if members < 4 { 4097 } else { 9 });
            let mut to: Vec<_> =
                (0..members).map(|_| Mutex::new(vec![letters.next(random)])).collect();
            to[number] = Mutex::new((0..count).map(|_| letters.next(random)).collect());
            mail.push(to);
        }
        Self { number, bins, mail }
    }

    /// Returns all particles that the member has after it has taken its mail.
    fn with_mail(&self) -> Vec<Particle> {
        let posted = self.mail.iter().flat_map(|to| to[self.number].lock().clone());
        self.bins.particles().iter().copied().chain(posted).collect()
    }

    /// Returns the number of letters in some boxes: `is` tests the number of a box's receiver and
    /// the member's own number.
    fn letters(&self, is: fn(usize, usize) -> bool) -> Vec<f64> {
        let boxes = self.mail.iter().flat_map(|to| to.iter().enumerate());
        let chosen = boxes.filter(|(to, _)| is(*to, self.number));
        integers([chosen.map(|(_, letters)| letters.lock().len()).sum()])
    }
}

/// A source of particles with new ids in some rows.
struct Letters {
    along: usize,
    rows: Range<usize>,
    id: u32,
}

impl Letters {
    fn next(&mut self, random: &mut Random) -> Particle {
        self.id += 1;
        let row = self.rows.start + random.below(self.rows.len());
        let y = (row as f64 + random.between(0.05, 0.95)) / self.along as f64;
        Particle { x: random.between(0.0, 1.0), y, id: self.id, ..Particle::default() }
    }
}

/// Returns row, column and id of each particle that the bins hold, in their order in memory.
fn held(bins: &SortedBins) -> Vec<f64> {
    let columns = bins.grid().columns();
    let cells = bins.rows().flat_map(|row| (0..columns).map(move |column| (row, column)));
    let inside = |(row, column)| {
        bins.bin(row, column).iter().flat_map(move |p: &Particle| [row, column, p.id as usize])
    };
    integers(cells.flat_map(inside))
}

/// Returns the expected row, column and id of each particle, bin by bin. Particles of a bin are in
/// the order of `all`.
fn rows_and_columns(grid: &Grid, all: &[Particle]) -> Vec<f64> {
    let place = |p: &Particle| [grid.row(p.y), grid.column(p.x), p.id as usize];
    let mut places: Vec<_> = all.iter().map(place).collect();
    places.sort_by_key(|place| [place[0], place[1]]);
    integers(places.into_iter().flatten())
}

/// Returns 1 if a member sorts twice after each of `members` members has posted one particle. Each
/// sort exchanges two arrays, so after two sorts the particles are in the original array.
fn is_sorted_twice(members: usize) -> f64 {
    let mut bins = SortedBins::new(Grid::with_bins_along(1.0, 4), 0..4);
    // Refilling gives both arrays room for all particles.
    bins.refill(vec![Particle::default(); 100]);
    bins.refill([]);
    let before = bins.particles().as_ptr();
    let letter = || Mutex::new(vec![Particle::default()]);
    let mail: Mail = (0..members).map(|_| vec![letter()]).collect();
    take_posted(&mut bins, 0, &mail);
    truth(bins.particles().as_ptr() == before)
}

/// Asks about mail to a member from any number of members, some of which have posted nothing.
pub(crate) fn letters(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..60 {
        let mut case = Case::drawn(random, case);
        let own = case.bins.particles().len();
        let all = case.with_mail();
        let members = case.mail.len();
        take_posted(&mut case.bins, case.number, &case.mail);
        let name = format!(
            "a member with {own} particles, and {} letters from {members} members, some of which posted no letter",
            all.len() - own
        );
        let question = format!("{name}: id x y vx vy of each of the member's particles afterwards");
        ask.exact(&question, || states(case.bins.particles()), || states(&all));
        let question = format!(
            "{name}: row, column and id of each particle in the member's bins. Within a bin, particles must be in the \
             order of the senders"
        );
        ask.exact(&question, || held(&case.bins), || rows_and_columns(case.bins.grid(), &all));
        let question = format!("{name}: number of letters that are left in the member's boxes");
        ask.exact(&question, || case.letters(|to, own| to == own), || integers([0]));
        let question = format!(
            "{name}: number of letters in the boxes of the other members. One letter was put into each of these boxes, \
             and it must stay there"
        );
        ask.exact(
            &question,
            || case.letters(|to, own| to != own),
            || integers([members * (members - 1)]),
        );
    }
    for members in [2, 3] {
        let question = format!(
            "each of {members} members has posted a particle: 1 if the receiver sorts its particles more than once, 0 \
             if not"
        );
        ask.exact(&question, || vec![is_sorted_twice(members)], || vec![0.0]);
    }
}
