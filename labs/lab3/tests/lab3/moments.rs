//! The worked examples of the actions of threads, moment by moment. Threads are delayed so that the
//! moments have the same order in every run.

use std::thread;
use std::time::{Duration, Instant};

use lab3::{Barrier, Part, on_threads, take_steps};
use oracle::{Ask, Random, Table};
use parking_lot::Mutex;

use super::threads::panics_with;

/// A member that does each part when the other member waits at a barrier, or has continued without
/// waiting.
const LATE: usize = 1;

/// Progress of two members.
struct Team {
    /// Number of parts that each member has ended.
    ended: [usize; 2],
    table: Table,
}

/// Does one part of a member.
fn do_part(member: usize, part: Part, barrier: &Barrier, team: &Mutex<Team>) {
    if member == LATE {
        barrier.be_last();
    }
    let mut team = team.lock();
    let [by_0, by_1] = team.ended;
    let waits = if member == LATE && barrier.others_wait() { "yes" } else { "-" };
    let step = team.ended[member] / 3 + 1;
    let part = format!("{part:?}").to_lowercase();
    team.table.row([&member, &step, &part, &by_0, &by_1, &waits]);
    team.ended[member] += 1;
}

/// Shows two members that take two steps. Member 1 is late in each part.
pub(crate) fn barriers(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let headings =
            ["member", "step", "begins its", "parts ended by 0", "parts ended by 1", "0 waits"];
        let team = Mutex::new(Team { ended: [0; 2], table: Table::new(headings) });
        let barrier = Barrier::new(2);
        thread::scope(|scope| {
            for member in 0..2 {
                let barrier = &barrier;
                let team = &team;
                scope.spawn(move || {
                    let _membership = barrier.membership();
                    take_steps(2, |part| do_part(member, part, barrier, team), barrier);
                });
            }
        });
        team.into_inner().table.to_string()
    });
}

/// Time that a thread waits for others that may never come.
const PATIENCE: Duration = Duration::from_secs(2);

/// Actions of three threads.
struct Moments {
    begun: usize,
    ended: usize,
    table: Table,
}

impl Moments {
    fn note(&mut self, what: &str) {
        self.table.row([&what, &(self.begun - self.ended)]);
    }
}

/// Returns when `reached` is true, or when it is clear that it never will be.
fn until(moments: &Mutex<Moments>, reached: impl Fn(&Moments) -> bool) {
    let end = Instant::now() + PATIENCE;
    while !reached(&moments.lock()) && Instant::now() < end {
        thread::yield_now();
    }
}

/// Shows three threads that begin in the order of their numbers and end in the opposite order.
pub(crate) fn threads(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let table = Table::new(["", "threads at work"]);
        let moments = Mutex::new(Moments { begun: 0, ended: 0, table });
        let caller = thread::current().id();
        on_threads(3, |number| {
            until(&moments, |moments| moments.begun == number);
            let is_new = thread::current().id() != caller;
            let kind = if is_new { "a new thread" } else { "the thread that calls" };
            let mut now = moments.lock();
            now.begun += 1;
            now.note(&format!("{kind} begins with number {number}"));
            drop(now);
            until(&moments, |moments| moments.begun == 3 && moments.ended == 2 - number);
            let mut now = moments.lock();
            now.ended += 1;
            now.note(&format!("the thread with number {number} ends"));
        });
        let mut moments = moments.into_inner();
        moments.note("the call returns");
        let mut panics = Table::new(["thread 1 of 3 panics with", "the call panics with"]);
        panics.row([&17, &panics_with(17)]);
        format!("{}\n{panics}", moments.table)
    });
}
