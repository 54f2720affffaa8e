//! Writes discs in the assignment's format: `%10.8f` numbers, one disc per line.

use std::io::{self, Write};

use super::Disc;

/// Writes the lines `t i x y vx vy` of the discs `first ..` after step `t`.
///
/// # Errors
/// Writing to `out` fails.
pub fn write_step(out: &mut dyn Write, t: u64, first: usize, discs: &[Disc]) -> io::Result<()> {
    for (i, disc) in (first..).zip(discs) {
        let Disc { x, y, vx, vy, .. } = disc;
        writeln!(out, "{t} {i} {x:10.8} {y:10.8} {vx:10.8} {vy:10.8}")?;
    }
    Ok(())
}

/// Writes the lines `S i x y vx vy pcollisions wcollisions` of the discs `first ..` at the end of a
/// run.
///
/// `steps` is S, the number of steps.
///
/// # Errors
/// Writing to `out` fails.
pub fn write_end(out: &mut dyn Write, steps: u64, first: usize, discs: &[Disc]) -> io::Result<()> {
    for (i, disc) in (first..).zip(discs) {
        let Disc { x, y, vx, vy, pair_collisions, wall_collisions } = disc;
        writeln!(
            out,
            "{steps} {i} {x:10.8} {y:10.8} {vx:10.8} {vy:10.8} {pair_collisions} {wall_collisions}"
        )?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_the_assignments() {
        let mut disc = Disc::new(1.0, 2.5, -1.0 / 3.0, 12_345.678_901_234);
        disc.pair_collisions = 4;
        disc.wall_collisions = 1;
        let mut out = Vec::new();
        write_step(&mut out, 3, 7, &[disc]).unwrap();
        write_end(&mut out, 5, 7, &[disc]).unwrap();
        let expected = "3 7 1.00000000 2.50000000 -0.33333333 12345.67890123\n\
                        5 7 1.00000000 2.50000000 -0.33333333 12345.67890123 4 1\n";
        assert_eq!(String::from_utf8(out).unwrap(), expected);
    }
}
