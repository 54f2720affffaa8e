//! Questions about the rank that moves a disc.

use common::hard::Disc;
use hard_disc_ranks::{Decisions, DiscWire};
use lab8::move_on;
use oracle::{Ask, Random};
use solution7::{Candidate, Hit, Square, resolve};

use super::candidates::{Found, discs_of};
use super::wires::{DISC, same_discs, wires};

/// Discs of a rank after all decisions of a step.
struct Case {
    here: Vec<Disc>,
    owns: Vec<bool>,
    decisions: Decisions,
}

const SQUARE: Square = Square { side: 1e5, radius: 1.0 };

/// Asks about a rank's discs and ghosts that are free, that this rank took, or that another rank
/// took.
pub(crate) fn moves(random: &mut Random, ask: &mut impl Ask) {
    for (number, discs) in [1, 2, 9, 33, 300, 4097].into_iter().cycle().take(90).enumerate() {
        let case = Case::drawn(random, discs + 2);
        let question = format!(
            "case {number}, a rank with {} discs, of which {} are its own, and {} collisions that the rank has taken: \
             {DISC} after the step, for each disc that the rank moves",
            case.here.len(),
            case.owns.iter().filter(|owns| **owns).count(),
            case.decisions.taken.len()
        );
        ask.judge(
            &question,
            || wires(&move_on(&mut case.here.clone(), &case.owns, &case.decisions, SQUARE)),
            |found| same_discs(found, &case.right()),
        );
    }
}

impl Case {
    fn drawn(random: &mut Random, discs: u32) -> Self {
        let mut decisions = Found::drawn(random, discs).decisions();
        let count = decisions.numbers.len();
        let here = (0..count).map(|slot| side_by_side(random, slot)).collect();
        let owns = (0..count).map(|_| random.below(2) == 0).collect();
        for slot in (0..count.saturating_sub(1)).step_by(2) {
            let [a, b] = [decisions.numbers[slot], decisions.numbers[slot + 1]];
            let pair = Hit::Pair(a, b);
            let hit = [Some(pair), Some(pair), Some(Hit::WallY(a)), None, None][random.below(5)];
            // A disc without a collision on this rank is free, or another rank took it.
            decisions.free[slot] = hit.is_none() && random.below(2) == 0;
            decisions.free[slot + 1] = hit != Some(pair);
            decisions.taken.extend(hit.map(|hit| Candidate { time: 0.4, hit }));
        }
        Self { here, owns, decisions }
    }

    /// Returns the discs that this rank moves. Each disc is considered separately.
    fn right(&self) -> Vec<DiscWire> {
        let Self { here, owns, decisions } = self;
        let mut right = Vec::new();
        for (slot, &number) in decisions.numbers.iter().enumerate() {
            let disc = here[slot];
            let taken = decisions.taken.iter().find(|c| discs_of(c).any(|disc| disc == number));
            let after = match taken {
                Some(taken) => Some(self.collided(taken, number)),
                None if decisions.free[slot] && owns[slot] => {
                    Some(Disc { x: disc.x + disc.vx, y: disc.y + disc.vy, ..disc })
                }
                None => None,
            };
            right.extend(after.map(|disc| DiscWire::new(number as usize, &disc)));
        }
        right
    }

    /// Returns a disc after a collision, with only the discs of the collision in the scene.
    fn collided(&self, taken: &Candidate, number: u32) -> Disc {
        let Decisions { numbers, .. } = &self.decisions;
        let slots = discs_of(taken).map(|disc| numbers.iter().position(|n| *n == disc));
        let mut alone: Vec<Disc> = slots.flatten().map(|slot| self.here[slot]).collect();
        let hit = if alone.len() == 2 { Hit::Pair(0, 1) } else { Hit::WallY(0) };
        resolve(&[Candidate { hit, ..*taken }], &mut alone, SQUARE);
        alone[usize::from(number != taken.hit.first())]
    }
}

/// Draws discs that are placed side by side in pairs, and may collide.
fn side_by_side(random: &mut Random, slot: usize) -> Disc {
    let x = 20.0 + 12.0 * (slot / 2) as f64 + 4.0 * (slot % 2) as f64;
    let vx = if slot.is_multiple_of(2) { 2.5 } else { -2.5 };
    Disc::new(x, 50.0 + random.between(-0.3, 0.3), vx, random.between(-1.0, 1.0))
}
