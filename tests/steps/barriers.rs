//! Chapter 3: two members of a team and their mail, with all barriers and without one.

use common::Vec2;
use common::soft::Particle;
use oracle::{Columns, within};
use parking_lot::{Mutex, RwLock};
use solution1::advance;
use solution2::SortedBins;
use solution3::{Barrier, Part, on_threads, own_rows, take_posted, take_steps};

use crate::eight::{grid, numbers, particles};

const MEMBERS: usize = 2;

/// It does each part when the other has done it and waits, or has gone on without it.
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

/// Two steps of a team whose members run `take_steps`.
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
            let what = format!("step {}: member {member} {doing}", parts / 3 + 1);
            team.note(what, |other| member == LATE && other != LATE);
            parts += 1;
        };
        take_steps(2, &mut part, &barrier);
    });
    team.table.into_inner().to_string()
}

/// The bins and the mail of all members, as in the kit's team.
struct Team {
    bins: [RwLock<SortedBins>; MEMBERS],
    mail: Vec<Vec<Mutex<Vec<Particle>>>>,
    table: Mutex<Columns>,
}

impl Team {
    fn new() -> Self {
        let grid = grid();
        let bins = std::array::from_fn(|member| {
            let rows = own_rows(member, MEMBERS, grid.rows());
            let mut bins = SortedBins::new(grid, rows.clone());
            bins.refill(particles().into_iter().filter(|p| rows.contains(&grid.row(p.y))));
            RwLock::new(bins)
        });
        let heads = ["member", "mail to"];
        let heads =
            heads.into_iter().flat_map(|what| (0..MEMBERS).map(move |k| format!("{what} {k}")));
        let mail = (0..MEMBERS).map(|_| (0..MEMBERS).map(|_| Mutex::default()).collect()).collect();
        let team = Self { bins, mail, table: Mutex::new(Columns::new(heads)) };
        team.note("rows of bins".into(), |_| false);
        team
    }

    /// Does a part of a step, and says what that was.
    fn part(&self, member: usize, part: Part) -> &'static str {
        let grid = grid();
        match part {
            // All are further apart than the cutoff.
            Part::Forces => "sums forces",
            Part::Moves => {
                let rows = own_rows(member, MEMBERS, grid.rows());
                self.bins[member].write().particles_mut().retain_mut(|particle| {
                    advance(particle, Vec2::ZERO, grid.size());
                    let row = grid.row(particle.y);
                    let owner =
                        (0..MEMBERS).find(|k| own_rows(*k, MEMBERS, grid.rows()).contains(&row));
                    let owner = owner.expect("every row has an owner");
                    if owner != member {
                        self.mail[member][owner].lock().push(*particle);
                    }
                    rows.contains(&row)
                });
                "moves"
            }
            Part::Arrivals => {
                take_posted(&mut self.bins[member].write(), member, &self.mail);
                "takes its mail"
            }
        }
    }

    /// Writes down what all have now, and whether they wait.
    fn note(&self, what: String, waits: impl Fn(usize) -> bool) {
        let grid = grid();
        let members = (0..MEMBERS).map(|member| {
            let bins = self.bins[member].read();
            let row = |row| numbers(bins.particles().iter().filter(|p| grid.row(p.y) == row));
            let rows: Vec<_> = own_rows(member, MEMBERS, grid.rows()).map(row).collect();
            rows.join("|") + if waits(member) { " waits" } else { "" }
        });
        let mail = (0..MEMBERS).map(|to| {
            let posted: Vec<_> =
                self.mail.iter().flat_map(|boxes| boxes[to].lock().clone()).collect();
            numbers(&posted)
        });
        self.table.lock().row(what, members.chain(mail));
    }
}
