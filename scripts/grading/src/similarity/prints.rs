//! Fingerprints of a row of tokens, by winnowing.
//!
//! Schleimer, Wilkerson and Aiken, *Winnowing: Local Algorithms for Document Fingerprinting*
//! (SIGMOD 2003): of the hashes of all runs of [`RUN`] tokens, keep the least in every window of
//! [`WINDOW`]. Whatever two programs share over [`RUN`] + [`WINDOW`] − 1 tokens is then seen, and
//! nothing shorter than [`RUN`].

use std::collections::HashSet;

use super::tokens::Token;

/// So many tokens make a hash: less is how everybody writes Rust.
pub(super) const RUN: usize = 16;

/// Of so many hashes one is kept.
pub(super) const WINDOW: usize = 9;

/// A kept hash, and the index of its first token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Print {
    pub(super) hash: u64,
    pub(super) at: usize,
}

/// The hash of each run of [`RUN`] tokens.
pub(super) fn hashes(tokens: &[Token]) -> Vec<u64> {
    tokens.windows(RUN).map(hash).collect()
}

/// FNV-1a, over the codes' bytes.
fn hash(run: &[Token]) -> u64 {
    let bytes = run.iter().flat_map(|token| token.code.to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// The kept hashes: in each window the least, the last of equals, each once.
pub(super) fn winnow(hashes: &[u64]) -> Vec<Print> {
    let mut prints: Vec<Print> = Vec::new();
    let windows = hashes.len().saturating_sub(WINDOW - 1).max(usize::from(!hashes.is_empty()));
    for start in 0..windows {
        let end = (start + WINDOW).min(hashes.len());
        let at = (start..end).rev().min_by_key(|&at| hashes[at]);
        let Some(at) = at else { continue };
        if prints.last().is_none_or(|last| last.at != at) {
            prints.push(Print { hash: hashes[at], at });
        }
    }
    prints
}

/// Which tokens belong to a run that the starter has.
pub(super) fn given(hashes: &[u64], tokens: usize, starter: &HashSet<u64>) -> Vec<bool> {
    let mut given = vec![false; tokens];
    for (at, _) in hashes.iter().enumerate().filter(|(_, hash)| starter.contains(hash)) {
        given[at..at + RUN].fill(true);
    }
    given
}

#[cfg(test)]
mod tests {
    use super::{Print, RUN, WINDOW, hashes, winnow};
    use crate::similarity::tokens::Token;

    fn tokens(codes: impl Iterator<Item = u32>) -> Vec<Token> {
        codes.map(|code| Token { code, file: 0, line: 1 }).collect()
    }

    #[test]
    fn the_least_of_each_window_is_kept_once() {
        let hashes = [9, 1, 8, 7, 6, 5, 4, 3, 2, 9, 9, 9];
        let kept = [Print { hash: 1, at: 1 }, Print { hash: 2, at: 8 }];
        assert_eq!(winnow(&hashes), kept);
        assert_eq!(winnow(&[]), []);
        assert_eq!(winnow(&[5, 3]), [Print { hash: 3, at: 1 }]);
    }

    /// What winnowing promises: a common stretch of RUN + WINDOW - 1 tokens shares a print,
    /// wherever it stands.
    #[test]
    fn a_stretch_that_is_long_enough_is_never_missed() {
        let mut state = 1_u32;
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state >> 20
        };
        for _ in 0..50 {
            let shared: Vec<u32> = (0..RUN + WINDOW - 1).map(|_| random()).collect();
            let mut prints = |before: usize| {
                let mut codes: Vec<u32> = (0..before).map(|_| 5_000 + random()).collect();
                codes.extend(&shared);
                codes.extend((0..30).map(|_| 5_000 + random()));
                let hashes = hashes(&tokens(codes.into_iter()));
                winnow(&hashes).iter().map(|print| print.hash).collect::<Vec<_>>()
            };
            let (one, two) = (prints(7), prints(40));
            assert!(one.iter().any(|hash| two.contains(hash)));
        }
    }
}
