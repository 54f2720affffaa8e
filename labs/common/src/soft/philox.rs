//! Random numbers without a state: a function of a counter and a key.

/// Multipliers of the two halves.
const M: [u32; 2] = [0xD251_1F53, 0xCD9E_8D57];

/// Constants that are added to the key after each round.
const W: [u32; 2] = [0x9E37_79B9, 0xBB67_AE85];

const ROUNDS: usize = 10;

/// Philox4x32-10: returns four random 32-bit words for each counter of four words and key of two.
///
/// A generator like the Mersenne Twister makes its numbers one after the other, so the millionth
/// number costs a million calls. This function is a bijection of the counter that depends on the
/// key, and it stores nothing. Every process can compute any number, in any order.
///
/// Source: Salmon, Moraes, Dror and Shaw, *Parallel random numbers: as easy as 1, 2, 3*, SC11.
pub(crate) fn philox4x32(counter: [u32; 4], mut key: [u32; 2]) -> [u32; 4] {
    let mut c = counter;
    for _ in 0..ROUNDS {
        let (high0, low0) = wide_product(M[0], c[0]);
        let (high1, low1) = wide_product(M[1], c[2]);
        c = [high1 ^ c[1] ^ key[0], low1, high0 ^ c[3] ^ key[1], low0];
        key = [key[0].wrapping_add(W[0]), key[1].wrapping_add(W[1])];
    }
    c
}

/// Returns the high and the low word of a product.
fn wide_product(a: u32, b: u32) -> (u32, u32) {
    let product = u64::from(a) * u64::from(b);
    ((product >> 32) as u32, product as u32)
}

#[cfg(test)]
mod tests {
    use super::philox4x32;

    /// The known answers that the authors publish with their library Random123.
    #[test]
    fn the_published_answers() {
        for (counter, key, answer) in [
            ([0; 4], [0; 2], [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]),
            ([u32::MAX; 4], [u32::MAX; 2], [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]),
            (
                [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344],
                [0xa409_3822, 0x299f_31d0],
                [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1],
            ),
        ] {
            assert_eq!(philox4x32(counter, key), answer, "counter {counter:x?}, key {key:x?}");
        }
    }
}
