//! Questions about the greedy choice on the device.

use device::Gpu;
use device_discs::hard::Chooser;
use lab9::Lab9;
use oracle::{Ask, Random};
use solution7::{Candidate, take_in_order};

use super::adapter::adapter;
use super::launched::rivals;
use super::lists::sorted;

/// Returns a chooser with workgroups of 64.
pub(super) fn chooser(gpu: &'static Gpu) -> Chooser<Lab9> {
    Chooser::new(gpu, 64, None).unwrap_or_else(|error| panic!("{error}"))
}

/// Asks for the choice among few and many candidates, many of them at the same time.
pub(crate) fn choices(random: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.5") else { return };
    let mut chooser = chooser(gpu);
    for count in [1, 40, 300, 3000, 200, 5000, 1 + random.below(4000)] {
        let candidates = rivals(count, |most| random.below(most));
        let question = format!(
            "{count} candidates among 300 discs: kind (0 corner, 1 and 2 walls, 3 pair), discs and time of each \
             candidate that is chosen"
        );
        let found = || {
            let flags = chooser.choose(&candidates, 300);
            let flags = flags.unwrap_or_else(|error| panic!("{error}"));
            let all = candidates.iter().zip(&flags);
            let chosen: Vec<Candidate> =
                all.filter(|(_, flag)| **flag == 1).map(|(candidate, _)| *candidate).collect();
            sorted(&chosen)
        };
        ask.exact(&question, found, || {
            let mut taken = Vec::new();
            take_in_order(&mut candidates.clone(), &mut [true; 300], &mut taken);
            sorted(&taken)
        });
    }
}
