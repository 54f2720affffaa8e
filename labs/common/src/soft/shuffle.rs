//! A shuffle without a list: each image and each preimage is computed separately.

use super::philox::philox4x32;

/// Number of rounds of the network.
///
/// After three rounds the map looks random if only images are computed. After four rounds the map
/// looks random even if images and preimages are computed (Luby and Rackoff, 1988).
const ROUNDS: u32 = 4;

/// A random one-to-one map of the numbers 0 .. `n` to themselves that needs no memory.
///
/// A number is divided into two halves, `column` and `row` of a table of `columns` by `rows`
/// entries. Each round computes a random function of one half and adds it to the other half, modulo
/// the range of the other half. Subtracting the same function undoes the round, whatever the
/// function is: this is a *Feistel network*. The table may have a few entries more than `n`. A
/// number that is mapped to an entry beyond `n` is mapped again, until the result is below `n`
/// (*cycle walking*; Black and Rogaway, *Ciphers with arbitrary finite domains*, 2002).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shuffle {
    n: usize,
    columns: usize,
    rows: usize,
    seed: u32,
}

impl Shuffle {
    /// Makes a shuffle of `n` numbers with a table that has `columns · rows` ≥ `n` entries.
    pub(crate) fn new(n: usize, columns: usize, rows: usize, seed: u32) -> Self {
        assert!(n <= columns * rows, "a table has an entry for every number");
        Self { n, columns, rows, seed }
    }

    /// Returns the index that `number` is mapped to.
    pub(crate) fn forward(&self, number: usize) -> usize {
        self.walk(number, |(mut column, mut row)| {
            for round in 0..ROUNDS {
                if round % 2 == 0 {
                    column = (column + self.random(round, row, self.columns)) % self.columns;
                } else {
                    row = (row + self.random(round, column, self.rows)) % self.rows;
                }
            }
            (column, row)
        })
    }

    /// Returns the number that is mapped to `index`.
    pub(crate) fn backward(&self, index: usize) -> usize {
        self.walk(index, |(mut column, mut row)| {
            for round in (0..ROUNDS).rev() {
                if round % 2 == 0 {
                    let added = self.random(round, row, self.columns);
                    column = (column + self.columns - added) % self.columns;
                } else {
                    let added = self.random(round, column, self.rows);
                    row = (row + self.rows - added) % self.rows;
                }
            }
            (column, row)
        })
    }

    fn walk(&self, mut number: usize, step: impl Fn((usize, usize)) -> (usize, usize)) -> usize {
        loop {
            let (column, row) = step((number % self.columns, number / self.columns));
            number = row * self.columns + column;
            if number < self.n {
                return number;
            }
        }
    }

    /// Returns a random number below `range`, which fits into 32 bits.
    fn random(&self, round: u32, half: usize, range: usize) -> usize {
        let [word, ..] = philox4x32([half as u32, round, 0, 0], [self.seed, 0]);
        ((u64::from(word) * range as u64) >> 32) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::Shuffle;

    fn shuffle(n: usize, seed: u32) -> Shuffle {
        let columns = (n as f64).sqrt().ceil() as usize;
        Shuffle::new(n, columns, n.div_ceil(columns), seed)
    }

    #[test]
    fn every_number_has_an_index_and_the_index_leads_back() {
        for n in (1..130).chain([1000, 1023, 1024, 1025]) {
            for seed in [1, 2, u32::MAX] {
                let shuffle = shuffle(n, seed);
                let mut taken = vec![false; n];
                for number in 0..n {
                    let index = shuffle.forward(number);
                    assert!(!taken[index], "n = {n}: two numbers go to {index}");
                    taken[index] = true;
                    assert_eq!(shuffle.backward(index), number, "n = {n}");
                }
            }
        }
    }

    /// χ² with 99 degrees of freedom exceeds 149 in one of a thousand shuffles.
    #[test]
    fn no_index_is_preferred() {
        let n = 100;
        for number in [0, 1, 57, 99] {
            let mut hits = vec![0.0; n];
            for seed in 1..=10_000 {
                hits[shuffle(n, seed).forward(number)] += 1.0;
            }
            let chi: f64 = hits.iter().map(|hit| (hit - 100.0_f64).powi(2) / 100.0).sum();
            assert!(chi < 149.0, "the indices of {number} over 10,000 seeds: χ² = {chi}");
        }
    }

    #[test]
    fn numbers_in_a_row_are_strangers() {
        let shuffle = shuffle(10_000, 1);
        let indices: Vec<usize> = (0..10_000).map(|number| shuffle.forward(number)).collect();
        // An index is a hit with probability 9 / 10,000, so nine hits are expected.
        let in_a_row = indices.windows(2);
        let hits = in_a_row
            .filter(|pair| {
                (pair[0] % 100).abs_diff(pair[1] % 100) <= 1
                    && (pair[0] / 100).abs_diff(pair[1] / 100) <= 1
            })
            .count();
        assert!(hits < 25, "{hits} of 9,999 particles stand beside their successor");
    }
}
