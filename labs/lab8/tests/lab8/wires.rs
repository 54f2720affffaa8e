//! Discs in messages, as numbers and in words.

use common::hard::Disc;
use hard_disc_ranks::DiscWire;
use oracle::Random;

/// Count of numbers per disc in an answer.
const NUMBERS: usize = 7;

/// Description of these numbers for questions.
pub(crate) const DISC: &str = "number, x y vx vy, collisions with discs and with walls";

/// Returns the numbers of a disc.
pub(crate) fn wire(wire: &DiscWire) -> [f64; NUMBERS] {
    let counts = [wire.pair_collisions, wire.wall_collisions].map(f64::from);
    [wire.number as f64, wire.x, wire.y, wire.vx, wire.vy, counts[0], counts[1]]
}

/// Returns the numbers of all discs of a list.
pub(crate) fn wires(all: &[DiscWire]) -> Vec<f64> {
    all.iter().flat_map(wire).collect()
}

/// Compares a list of discs with the correct list, in order, and names the first wrong disc.
pub(crate) fn same_discs(found: &[f64], right: &[DiscWire]) -> Result<(), String> {
    if !found.len().is_multiple_of(NUMBERS) {
        return Err("the list is not complete".into());
    }
    let found: Vec<&[f64]> = found.chunks(NUMBERS).collect();
    let right = wires(right);
    let right: Vec<&[f64]> = right.chunks(NUMBERS).collect();
    let most = found.len().max(right.len());
    let Some(first) = (0..most).find(|&k| found.get(k) != right.get(k)) else { return Ok(()) };
    let has = |list: &[&[f64]], disc: &[f64]| list.iter().any(|other| other[0] == disc[0]);
    Err(match (found.get(first), right.get(first)) {
        (Some(found), Some(right)) if found[0] == right[0] => {
            format!("disc {} is {}, but must be {}", right[0], state(found), state(right))
        }
        (_, Some(right)) if !has(&found, right) => format!("disc {} is missing", right[0]),
        (Some(extra), _) if !has(&right, extra) => {
            format!("disc {} must not be in the list", extra[0])
        }
        (Some(found), Some(right)) => {
            format!("disc {} is at the place in the list where disc {} must be", found[0], right[0])
        }
        (found, right) => {
            let disc = found.or(right).map_or(f64::NAN, |disc| disc[0]);
            format!("disc {disc} is in the list more than once")
        }
    })
}

/// Describes a disc's numbers in words.
fn state(disc: &[f64]) -> String {
    let [x, y, vx, vy] = [disc[1], disc[2], disc[3], disc[4]];
    format!(
        "at ({x:?}, {y:?}) with velocity ({vx:?}, {vy:?}), {} collisions with discs and {} with walls",
        disc[5], disc[6]
    )
}

/// Draws a disc that has collided before.
pub(crate) fn disc(random: &mut Random) -> Disc {
    let mut number = || random.signed(1e-3, 1e3);
    let disc = Disc::new(number(), number(), number(), number());
    let counts = [0, 255, 65_535, 1 << 24];
    let pair_collisions = counts[random.below(4)];
    Disc { pair_collisions, wall_collisions: counts[random.below(4)], ..disc }
}
