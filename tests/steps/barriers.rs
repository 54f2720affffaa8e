//! Chapter 3: two members of a team and their mail, with all barriers and with one barrier left
//! out.

use std::ops::Range;

use common::Vec2;
use common::soft::{NoStatistics, Particle};
use oracle::{Columns, within};
use parking_lot::{Mutex, RwLock};
use solution1::advance;
use solution2::{Gather, Grid, SortedBins};
use solution3::{Barrier, Part, on_threads, own_rows, take_posted, take_steps};

use crate::eight::{grid, numbers, particles};

const MEMBERS: usize = 2;

/// The member that does each part late. By then the other member has done the part and waits, or
/// has gone on.
const LATE: usize = 1;

#[test]
fn barriers() {
    let table =
        within("3.10", 20, || record(|steps, part, barrier| take_steps(steps, part, barrier)));
    insta::assert_snapshot!(table);
}

#[test]
fn no_barrier_before_the_arrivals() {
    fn take_steps(steps: u64, mut part: impl FnMut(Part), barrier: &Barrier) {
        include!(concat!(env!("OUT_DIR"), "/no_barrier_before_the_arrivals.rs"));
    }
    let table =
        within("3.10", 20, || record(|steps, part, barrier| take_steps(steps, part, barrier)));
    insta::assert_snapshot!(table);
}

/// Records two steps of a team whose members run `take_steps`.
fn record(take_steps: fn(u64, &mut dyn FnMut(Part), &Barrier)) -> String {
    let team = Team::new();
    let barrier = Barrier::new(MEMBERS);
    on_threads(MEMBERS, |member| {
        let _membership = barrier.membership();
        let mut parts = 0;
        let mut part = |part: Part| {
            if member == LATE {
                barrier.be_last();
            }
            let doing = team.part(member, part);
            let waiting = (member == LATE).then_some(1 - LATE);
            team.note(format!("step {}: member {member} {doing}", parts / 3 + 1), waiting);
            parts += 1;
        };
        take_steps(2, &mut part, &barrier);
    });
    team.table.into_inner().to_string()
}

/// The bins and the mail of all members, as in the kit's team.
struct Team {
    grid: Grid,
    bins: [RwLock<SortedBins>; MEMBERS],
    accelerations: [Mutex<Vec<Vec2>>; MEMBERS],
    mail: Vec<Vec<Mutex<Vec<Particle>>>>,
    table: Mutex<Columns>,
}

impl Team {
    fn new() -> Self {
        let grid = grid();
        let bins = std::array::from_fn(|member| {
            let rows = rows(&grid, member);
            let mut bins = SortedBins::new(grid, rows.clone());
            bins.refill(particles().into_iter().filter(|p| rows.contains(&grid.row(p.y))));
            RwLock::new(bins)
        });
        let mail = (0..MEMBERS).map(|_| (0..MEMBERS).map(|_| Mutex::default()).collect()).collect();
        let heads = ["member 0", "member 1", "mail to 0", "mail to 1"].map(String::from);
        let table = Mutex::new(Columns::new(heads));
        let team = Self { grid, bins, accelerations: Default::default(), mail, table };
        team.note("rows of bins".into(), None);
        team
    }

    /// Does a part of a step, and returns its description.
    fn part(&self, member: usize, part: Part) -> &'static str {
        match part {
            Part::Forces => {
                let bins = self.bins.each_ref().map(RwLock::read);
                let mut gather = Gather::default();
                let acceleration = |particle: &Particle| {
                    let columns = self.grid.near(self.grid.column(particle.x));
                    let rows = self.grid.near(self.grid.row(particle.y));
                    let around = rows.map(|row| bins[self.owner(row)].bins(row, columns.clone()));
                    gather.acceleration(particle, around, &mut NoStatistics)
                };
                let summed = bins[member].particles().iter().map(acceleration).collect();
                *self.accelerations[member].lock() = summed;
                "sums forces"
            }
            Part::Moves => {
                let mut accelerations =
                    std::mem::take(&mut *self.accelerations[member].lock()).into_iter();
                self.bins[member].write().particles_mut().retain_mut(|particle| {
                    let a = accelerations.next().expect("one for each particle");
                    advance(particle, a, self.grid.size());
                    let owner = self.owner(self.grid.row(particle.y));
                    if owner != member {
                        self.mail[member][owner].lock().push(*particle);
                    }
                    owner == member
                });
                "moves"
            }
            Part::Arrivals => {
                take_posted(&mut self.bins[member].write(), member, &self.mail);
                "takes its mail"
            }
        }
    }

    /// Returns the member that owns a row.
    fn owner(&self, row: usize) -> usize {
        let owner = (0..MEMBERS).find(|member| rows(&self.grid, *member).contains(&row));
        owner.expect("every row has an owner")
    }

    /// Records the contents of all members' bins and mail, and which member waits.
    fn note(&self, what: String, waiting: Option<usize>) {
        let members = (0..MEMBERS).map(|member| {
            let bins = self.bins[member].read();
            let inside =
                |row| numbers(bins.particles().iter().filter(move |p| self.grid.row(p.y) == row));
            let inside: Vec<_> = rows(&self.grid, member).map(inside).collect();
            inside.join("|") + if waiting == Some(member) { " waits" } else { "" }
        });
        let mail = (0..MEMBERS).map(|to| {
            let posted = self.mail.iter().flat_map(|boxes| boxes[to].lock().clone());
            numbers(&posted.collect::<Vec<_>>())
        });
        self.table.lock().row(what, members.chain(mail));
    }
}

fn rows(grid: &Grid, member: usize) -> Range<usize> {
    own_rows(member, MEMBERS, grid.rows())
}
