//! Regions of bins and their contents.

use common_threads::Lock;
use lab4::{Bin, Cut, Regions};
use oracle::ascending;

/// Returns regions of `bins_each` bins (fewer in the last region) that hold these particles.
pub(crate) fn regions_of(bins_each: usize, bins: &[Bin]) -> Regions {
    let numbered = bins.chunks(bins_each).enumerate();
    let locks = numbered.map(|(number, bins)| Lock::new(number, bins.to_vec())).collect();
    Regions { cut: Cut { bins_each }, locks }
}

/// Returns regions of `bins_each` bins with 30 particles in each bin: particles 30 b to 30 b + 29
/// in bin b.
pub(crate) fn filled(bins: usize, bins_each: usize) -> Regions {
    let bin = |bin: usize| (0..30).map(|k| (bin * 30 + k) as u32).collect();
    regions_of(bins_each, &(0..bins).map(bin).collect::<Vec<Bin>>())
}

/// Returns ten bins in two regions of five. Bins 3, 6 and 7 hold two particles each.
pub(crate) fn ten() -> Regions {
    let bin = |bin: u32| match bin {
        3 | 6 | 7 => vec![10 * bin, 10 * bin + 1],
        _ => Bin::new(),
    };
    regions_of(5, &(0..10).map(bin).collect::<Vec<Bin>>())
}

/// Returns particle and bin of each particle that the bins hold.
pub(crate) fn places(regions: &mut Regions) -> Vec<f64> {
    let bins = regions.parts_mut().flatten().enumerate();
    let of_bin = |(bin, inside): (usize, &mut Bin)| {
        let pairs = inside.iter().flat_map(|particle| [f64::from(*particle), bin as f64]);
        pairs.collect::<Vec<f64>>()
    };
    bins.flat_map(of_bin).collect()
}

/// Returns the particles in some bins, in ascending order.
pub(crate) fn inside<const N: usize>(regions: &mut Regions, bins: [usize; N]) -> [String; N] {
    let all: Vec<Bin> = regions.parts_mut().flatten().map(|bin| bin.clone()).collect();
    bins.map(|bin| ascending(all[bin].clone()))
}
