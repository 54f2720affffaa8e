//! Sorting many entries by a whole number.

/// A digit has at most so many bits: its counts should stay in the nearest cache.
const MOST_BITS: u32 = 12;

/// Below this length the counts cost more than they save.
const FEW: usize = 128;

/// Something that is sorted by a key.
pub(crate) trait Keyed: Copy {
    /// The key.
    fn key(&self) -> u64;
}

/// Sorts `items`, whose keys are all below `limit`, by key. `spare` and `counts` are memory that
/// is kept from call to call.
///
/// This is a counting sort digit by digit, the lowest first, with as few digits as the limit
/// allows. It reads and writes each item once a digit, in time linear in their number; a sort
/// by comparison would also have to do log₂ n comparisons each, half of them mispredicted.
pub(crate) fn sort_by_key<T: Keyed>(
    items: &mut Vec<T>,
    limit: u64,
    spare: &mut Vec<T>,
    counts: &mut Vec<u32>,
) {
    let Some(&filler) = items.first() else { return };
    if items.len() < FEW {
        items.sort_unstable_by_key(Keyed::key);
        return;
    }
    let bits = (u64::BITS - limit.leading_zeros()).max(1);
    let digits = bits.div_ceil(MOST_BITS);
    let width = bits.div_ceil(digits);
    spare.resize(items.len(), filler);
    for digit in 0..digits {
        let shift = digit * width;
        let digit = |item: &T| (item.key() >> shift) as usize & ((1 << width) - 1);
        counts.clear();
        counts.resize(1 << width, 0);
        for item in items.iter() {
            counts[digit(item)] += 1;
        }
        let mut sum = 0;
        for count in counts.iter_mut() {
            sum += std::mem::replace(count, sum);
        }
        for item in items.iter() {
            let place = &mut counts[digit(item)];
            spare[*place as usize] = *item;
            *place += 1;
        }
        std::mem::swap(items, spare);
    }
}
