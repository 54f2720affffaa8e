//! Bitwise comparison of programs.

use std::fmt::Write;

use common::soft::Particle;

/// Describes where two states differ in any bit. `None` if they are equal.
pub fn difference(found: &[Particle], expected: &[Particle]) -> Option<String> {
    let fields = |p: &Particle| [("x", p.x), ("y", p.y), ("vx", p.vx), ("vy", p.vy)];
    let mut words = String::new();
    let (mut count, mut only_last_digits) = (0, true);
    for (id, (f, e)) in found.iter().zip(expected).enumerate() {
        let mut differs = f.id != e.id;
        for ((name, f), (_, e)) in fields(f).into_iter().zip(fields(e)) {
            if f.to_bits() != e.to_bits() {
                differs = true;
                only_last_digits &= (f - e).abs() <= 1e-9 * e.abs();
                if words.is_empty() {
                    write!(words, "particle {id}: {name} is {f:?}, not {e:?}")
                        .expect("a string can grow");
                }
            }
        }
        if differs && words.is_empty() {
            write!(words, "the particle with index {id} has the id {}", f.id)
                .expect("a string can grow");
        }
        only_last_digits &= f.id == e.id;
        count += usize::from(differs);
    }
    let how = if only_last_digits { ", in the last digits only" } else { "" };
    (count > 0).then(|| format!("{words} ({count} of {} particles differ{how})", expected.len()))
}
