//! Points beside each other.

use super::{Record, Verdict};

/// The points that all of a class are marked out of, those among them that are open.
pub(crate) fn scale(records: &[Record]) -> f64 {
    let asked = |record: &Record| record.worth(|measure| measure.verdict != Verdict::NotTimed);
    let most = records.iter().map(asked).fold(0.0, f64::max);
    if most > 0.0 { most } else { 1.0 }
}

/// Points as people write them: 15, 7.5, 12.36.
pub(crate) fn points(points: f64) -> String {
    let text = format!("{points:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
