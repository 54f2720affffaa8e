//! Questions about groups: the root of a number, and pairs that join groups.

use lab11::{join, root};
use oracle::{Ask, Random, within};

/// Returns the number of ancestors of number `k`.
fn links(parent: &[u32], mut k: usize) -> usize {
    let mut links = 0;
    while parent[k] as usize != k && links <= parent.len() {
        k = parent[k] as usize;
        links += 1;
    }
    links
}

/// Returns the root of each number. No parent may be greater than its child.
fn roots_of(parent: &[u32]) -> Vec<u32> {
    let mut roots = parent.to_vec();
    for k in 0..roots.len() {
        roots[k] = roots[roots[k] as usize];
    }
    roots
}

fn numbers(all: Vec<u32>) -> Vec<f64> {
    all.into_iter().map(f64::from).collect()
}

/// Returns the first number whose parent is greater, or -1.
fn first_greater(parent: &[u32]) -> f64 {
    let greater = parent.iter().zip(0..).position(|(parent, k)| *parent > k);
    greater.map_or(-1.0, |k| k as f64)
}

/// Draws numbers with their parents. They form two chains, or have parents anywhere before them
/// (some begin a group), or each number is alone.
fn drawn(random: &mut Random, n: usize, kind: usize) -> Vec<u32> {
    let mut parent: Vec<u32> = (0..n as u32).collect();
    for (k, parent) in parent.iter_mut().enumerate().skip(1) {
        let any = random.below(k);
        let begins = random.below(n.min(50)) == 0;
        *parent = match kind {
            0 if k != n - n / 14 => k as u32 - 1,
            1 if !begins => any as u32,
            _ => k as u32,
        };
    }
    parent
}

pub(crate) fn roots(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(65_537).into_iter().chain([70_000]).filter(|&n| n > 0) {
        for (kind, what) in ["in two chains", "in trees", "each alone"].iter().enumerate() {
            let parent = drawn(random, n, kind);
            let list = if n <= 9 { format!(", parents {parent:?}") } else { String::new() };
            let name = format!("{n} numbers {what}{list}");
            let mut own = parent.clone();
            for k in [n - 1, random.below(n)] {
                let before = links(&own, k);
                let found = f64::from(root(&mut own, k as u32));
                let found = vec![found, links(&own, k) as f64];
                let question = format!(
                    "{name}: (1) root of {k}, (2) number of parents above {k} after the call, which were {before} \
                     before the call"
                );
                ask.judge(
                    &question,
                    || found,
                    |found| match found {
                        [root, _] if *root != f64::from(roots_of(&parent)[k]) => {
                            Err(format!("the root is {root}, but must be {}", roots_of(&parent)[k]))
                        }
                        [_, after] if *after as usize > before / 2 + 1 => Err(format!(
                            "{after} parents are left above the number, but the path must be half as long as before \
                             the call"
                        )),
                        _ => Ok(()),
                    },
                );
            }
            let question = format!(
                "{name}: first number whose parent is greater than the number itself after the calls, or -1 if there is \
                 none"
            );
            ask.exact(&question, || vec![first_greater(&own)], || vec![-1.0]);
            let question = format!("{name}: root of each number after the calls");
            ask.exact(&question, || numbers(roots_of(&own)), || numbers(roots_of(&parent)));
        }
    }
}

pub(crate) fn long_chain(_: &mut Random, ask: &mut impl Ask) {
    ask.apart(|ask| {
        let found = || {
            let mut parent: Vec<u32> = (0..1_000_000).map(|k: u32| k.saturating_sub(1)).collect();
            vec![f64::from(root(&mut parent, 999_999))]
        };
        ask.exact("a chain of a million numbers: root of the last number", found, || vec![0.0]);
    });
}

/// Asks about many pairs. A program that goes through all numbers for each pair does not finish.
pub(crate) fn many_joins(_: &mut Random, ask: &mut impl Ask) {
    let root_of_the_last = || {
        let mut parent: Vec<u32> = (0..1_000_000).collect();
        (1..1_000_000).for_each(|k| join(&mut parent, k - 1, k));
        vec![f64::from(root(&mut parent, 999_999))]
    };
    let question = "a million numbers, each joined to the next: root of the last number";
    ask.exact(question, || within("11.3", 30, root_of_the_last), || vec![0.0]);
}

/// Returns the least number of each number's group, after these pairs are joined.
fn least_of_groups(n: usize, pairs: &[[usize; 2]]) -> Vec<f64> {
    let mut least: Vec<usize> = (0..n).collect();
    for &[a, b] in pairs {
        let [low, high] = [least[a].min(least[b]), least[a].max(least[b])];
        least.iter_mut().filter(|least| **least == high).for_each(|least| *least = low);
    }
    least.into_iter().map(|k| k as f64).collect()
}

/// Asks about pairs in any order, including pairs within a group and pairs of a number with itself.
pub(crate) fn joins(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(4097).into_iter().chain([70_000]).filter(|&n| n > 0) {
        let mut parent: Vec<u32> = (0..n as u32).collect();
        let mut pairs = Vec::new();
        for round in 0..20 {
            let any = [random.below(n), random.below(n)];
            let [a, b] = [any, [n - 1, any[0]], [any[0], n - 1]][round % 3];
            pairs.push([a, b]);
            join(&mut parent, a as u32, b as u32);
            let name = format!(
                "{n} numbers, {} pairs joined, of which the last is {a} and {b}",
                round + 1
            );
            let question = format!(
                "{name}: first number whose parent is greater than the number itself, or -1 if there is none"
            );
            ask.exact(&question, || vec![first_greater(&parent)], || vec![-1.0]);
            let question = format!("{name}: root of each number");
            let roots = || numbers(roots_of(&parent));
            ask.exact(&question, roots, || least_of_groups(n, &pairs));
        }
    }
}
