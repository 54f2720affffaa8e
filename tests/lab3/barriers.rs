//! Questions about a member's parts and its barriers.

use std::thread;
use std::time::{Duration, Instant};

use lab3::{Barrier, Part, take_steps};
use oracle::{Ask, Random, integers};
use parking_lot::Mutex;

const MEMBERS: usize = 3;
const PARTS: [Part; 3] = [Part::Forces, Part::Moves, Part::Arrivals];

/// Time that a member is held back for others that may never come.
const PATIENCE: Duration = Duration::from_secs(5);

/// Actions of a team's members in each part of all steps.
struct Rehearsal {
    /// For each part, the number of members that began it.
    begun: Vec<usize>,
    /// For each part, the number of members that ended it.
    ended: Vec<usize>,
    /// For each part and member, the number of members that had ended the previous part.
    before: Vec<[usize; MEMBERS]>,
    /// Number of times that the others did not wait at the barrier for a delayed member.
    alone: usize,
    /// Number of members that began a part too early.
    early: usize,
}

impl Rehearsal {
    fn new(turns: usize) -> Self {
        let none = vec![0; turns];
        let before = vec![[MEMBERS; MEMBERS]; turns];
        Self { begun: none.clone(), ended: none, before, alone: 0, early: 0 }
    }

    fn begin(&mut self, turn: usize, member: usize) {
        self.begun[turn] += 1;
        if turn > 0 {
            self.before[turn][member] = self.ended[turn - 1];
        }
        self.early += usize::from(self.before[turn][member] < MEMBERS);
    }

    fn is_sound(&self) -> bool {
        self.early + self.alone == 0
    }
}

/// Does a member's part number `turn`. In each part one member is delayed until the others wait at
/// the barrier, or until a member has begun too early. Elapsed time alone does not release the
/// member.
fn rehearse(turn: usize, member: usize, barrier: &Barrier, notes: &Mutex<Rehearsal>) {
    notes.lock().begin(turn, member);
    if turn % 4 == member && notes.lock().is_sound() {
        let until = Instant::now() + PATIENCE;
        while !barrier.others_wait() && notes.lock().is_sound() && Instant::now() < until {
            thread::yield_now();
        }
        notes.lock().alone += usize::from(!barrier.others_wait());
    }
    notes.lock().ended[turn] += 1;
}

/// Returns the rehearsal of three members that take some steps.
fn rehearsal(steps: usize) -> Rehearsal {
    let turns = PARTS.len() * steps;
    let barrier = Barrier::new(MEMBERS);
    let notes = Mutex::new(Rehearsal::new(turns));
    thread::scope(|scope| {
        for member in 0..MEMBERS {
            let barrier = &barrier;
            let notes = &notes;
            scope.spawn(move || {
                let _membership = barrier.membership();
                let mut turn = 0;
                let part = |part: Part| {
                    assert!(turn < turns, "member {member} takes more than {steps} steps");
                    assert_eq!(part, PARTS[turn % 3], "part {} of a step", turn % 3 + 1);
                    rehearse(turn, member, barrier, notes);
                    turn += 1;
                };
                take_steps(steps as u64, part, barrier);
            });
        }
    });
    notes.into_inner()
}

/// Asks for the actions of three members in each part of some steps.
pub(crate) fn rehearsals(random: &mut Random, ask: &mut impl Ask) {
    let steps = 4 + random.below(9);
    let found = rehearsal(steps);
    for (turn, before) in found.before.iter().enumerate() {
        let part = ["forces", "moves", "arrivals"][turn % 3];
        let name = format!("step {} of {steps}, {part}", turn / 3);
        let question = format!(
            "{name}: number of members that have ended the previous part, (1) when member 0 begins this part, (2) \
             when member 1 begins it, (3) when member 2 begins it. A number below 3 means that a barrier is missing"
        );
        ask.exact(&question, || integers(*before), || integers([MEMBERS; MEMBERS]));
        let question = format!(
            "{name}: (1) number of members that begin this part, (2) number of members that end it"
        );
        let counts = || integers([found.begun[turn], found.ended[turn]]);
        ask.exact(&question, counts, || integers([MEMBERS; 2]));
    }
    let question = format!(
        "{steps} steps, in which one member is delayed in each part: number of parts after which the other members do \
         not wait for it at a barrier"
    );
    ask.exact(&question, || integers([found.alone]), || integers([0]));
}

/// Asks for the parts and barriers of one member in few and many steps.
pub(crate) fn meetings(_: &mut Random, ask: &mut impl Ask) {
    for steps in [0_usize, 1, 3, 70_000] {
        let barrier = Barrier::new(1);
        let mut parts = 0;
        take_steps(steps as u64, |_| parts += 1, &barrier);
        let question = format!(
            "{steps} steps of one member: (1) number of parts, three in each step, (2) number of barriers, three in \
             each step"
        );
        let found = || integers([parts, barrier.meetings() as usize]);
        ask.judge(&question, found, |found| {
            let right = 3 * steps;
            // No member needs to wait after the last part.
            if [right, right.saturating_sub(1)]
                .iter()
                .any(|least| found == integers([right, *least]))
            {
                return Ok(());
            }
            Err(format!("     found: {found:?}\n  expected: {:?}", integers([right; 2])))
        });
    }
}
