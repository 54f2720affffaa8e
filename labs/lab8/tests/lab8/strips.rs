//! Questions about strips: the strips that a box reaches, the rank that tests a pair, and the
//! receivers of ghosts.

use hard_disc_ranks::{DiscWire, Reach, Strips};
use lab8::{ghosts_for, looks_at, reached};
use oracle::{Ask, Random, beside, integers};
use solution6::Cuts;

use super::wires::{DISC, same_discs, wires};

/// Returns rows above some height, cut into strips for `ranks` ranks. Some strips are empty.
fn strips(random: &mut Random, ranks: usize, rows: usize) -> Strips {
    let mut starts: Vec<usize> = (1..ranks).map(|_| random.below(rows + 1)).collect();
    starts.extend([0, rows]);
    starts.sort_unstable();
    let height = random.magnitude(1e-9, 1e9).log2().round().exp2();
    Strips { bottom: random.below(100) as f64 * height, height, cuts: Cuts { starts } }
}

/// Returns the rank of a height. It is the number of edges at or below the height.
fn rank_of(strips: &Strips, y: f64) -> usize {
    let Strips { bottom, height, cuts: Cuts { starts } } = strips;
    let rows = starts[starts.len() - 1];
    let row = (1..rows).rev().find(|&row| y >= bottom + row as f64 * height).unwrap_or(0);
    (0..starts.len() - 1).find(|&rank| (starts[rank]..starts[rank + 1]).contains(&row)).unwrap_or(0)
}

/// Draws a disc in few or many strips. Its box ends within a strip, on an edge, slightly beside an
/// edge, or outside all strips.
fn flying(random: &mut Random, strips: &Strips, reach: f64, number: u64) -> DiscWire {
    let rows = *strips.cuts.starts.last().expect("the cuts include the end of the rows");
    let edge = |random: &mut Random| strips.bottom + random.below(rows + 1) as f64 * strips.height;
    let y = edge(random) + [0.25, 0.5][random.below(2)] * strips.height;
    let to = edge(random) + [reach, -reach, 0.25 * strips.height][random.below(3)];
    let vy = [0.0, beside(to - y)[random.below(3)], random.signed(1e-3, 30.0) * strips.height]
        [random.below(3)];
    DiscWire { y, vy, number, x: random.between(0.0, 1.0), vx: 0.5, ..DiscWire::default() }
}

/// Returns the ranks that the box of a disc reaches.
fn box_of(strips: &Strips, disc: &DiscWire, reach: f64) -> Reach {
    let (start, end) = (disc.y, disc.y + disc.vy);
    let first = rank_of(strips, start.min(end) - reach);
    Reach { first, last: rank_of(strips, start.max(end) + reach) }
}

/// Asks for the strips that a box reaches.
pub(crate) fn boxes(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..1500 {
        let many = case % 50 == 0;
        let ranks = if many { 300 } else { 1 + case % 5 };
        let strips = strips(random, ranks, if many { 700 } else { 10 });
        let reach = [0.125, 1.0, 2.5, 40.0][random.below(4)] * strips.height;
        let disc = flying(random, &strips, reach, 0);
        let Strips { bottom, height, cuts } = &strips;
        let question = format!(
            "a disc at y = {:?} with vy = {:?}. Its box extends {reach:?} beyond its path. Rows are {height:?} high \
             and begin at {bottom:?}, and the strips begin at the rows {:?}: first and last rank that the box reaches",
            disc.y, disc.vy, cuts.starts
        );
        let ends = |reach: Reach| integers([reach.first, reach.last]);
        ask.exact(
            &question,
            || ends(reached(&strips, &disc, reach)),
            || ends(box_of(&strips, &disc, reach)),
        );
    }
}

/// Asks for the rank that tests a pair.
pub(crate) fn lookers(_: &mut Random, ask: &mut impl Ask) {
    let all = || (0..5).flat_map(|first| (first..5).map(move |last| Reach { first, last }));
    for (a, b) in all().flat_map(|a| all().map(move |b| (a, b))) {
        ask.exact(
            &format!("a pair of discs whose boxes reach {a:?} and {b:?}: ranks that test the pair"),
            || integers((0..5).filter(|&rank| looks_at(rank, a, b))),
            || integers((0..5).filter(|&rank| a.contains(rank) && b.contains(rank)).take(1)),
        );
    }
}

/// Asks for the discs that partners receive: none, few and many discs, partners in any order, some
/// without discs.
pub(crate) fn ghosts(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(4097).into_iter().flat_map(|n| [n, n]).chain([70_000]) {
        let ranks = 2 + random.below(6);
        let strips = strips(random, ranks, 12);
        let reach = [0.125, 1.0][random.below(2)] * strips.height;
        let own: Vec<DiscWire> =
            (0..n as u64).map(|k| flying(random, &strips, reach, 3 * k)).collect();
        let mut partners: Vec<usize> = (0..ranks).filter(|_| random.below(3) > 0).collect();
        random.shuffle(&mut partners);
        let lists = ghosts_for(&partners, &own, &strips, reach);
        let name = format!("{n} own discs, {ranks} strips, partners {partners:?}");
        ask.exact(
            &format!("{name}: number of lists"),
            || integers([lists.len()]),
            || integers([partners.len()]),
        );
        for (k, partner) in partners.iter().enumerate() {
            let question = format!("{name}: {DISC} of each ghost for rank {partner}");
            ask.judge(
                &question,
                || lists.get(k).map_or_else(Vec::new, |list| wires(list)),
                |found| {
                    let reaches =
                        |disc: &&DiscWire| box_of(&strips, disc, reach).contains(*partner);
                    let right: Vec<DiscWire> = own.iter().filter(reaches).copied().collect();
                    same_discs(found, &right)
                },
            );
        }
    }
}
