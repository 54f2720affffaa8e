//! The frames of a run, small enough for a page.

use anyhow::{Context, Result, bail};

/// Positions are whole numbers from 0 to this, across the box.
pub(super) const GRID: f64 = 10_000.0;

/// Speeds are whole numbers from 0 to this, the fastest particle of all frames.
const SHADES: f64 = 255.0;

/// A run as a page needs it.
#[derive(Debug)]
pub(super) struct Movie {
    /// Side of the box.
    pub(super) size: f64,
    /// The greatest speed in any frame.
    pub(super) fastest: f64,
    /// For each frame x, y and speed of one particle after the other.
    pub(super) frames: Vec<Vec<u16>>,
}

/// Reads what a lab writes with `--full`: `n size`, then `x y vx vy` lines, frames apart by an
/// empty line.
pub(super) fn read(text: &str) -> Result<Movie> {
    let mut lines = text.lines();
    let header = lines.next().and_then(|line| line.split_once(' '));
    let size: f64 = header.and_then(|(_, size)| size.parse().ok()).context("no size in line 1")?;
    let mut frames: Vec<Vec<(f64, f64, f64)>> = Vec::new();
    let mut frame = Vec::new();
    for (at, line) in lines.enumerate() {
        if line.is_empty() {
            frames.push(std::mem::take(&mut frame));
            continue;
        }
        let numbers: Vec<f64> = line.split(' ').filter_map(|word| word.parse().ok()).collect();
        let [x, y, vx, vy] = numbers[..] else { bail!("line {} is not 'x y vx vy'", at + 2) };
        frame.push((x / size, y / size, vx.hypot(vy)));
    }
    let fastest = frames.iter().flatten().map(|p| p.2).fold(0.0, f64::max);
    let shade = SHADES / f64::max(fastest, f64::MIN_POSITIVE);
    let whole = |(x, y, speed): &(f64, f64, f64)| {
        [(x * GRID).round() as u16, (y * GRID).round() as u16, (speed * shade).round() as u16]
    };
    let frames = frames.iter().map(|frame| frame.iter().flat_map(whole).collect()).collect();
    Ok(Movie { size, fastest, frames })
}

#[cfg(test)]
mod tests {
    use super::read;

    #[test]
    fn frames_become_whole_numbers() {
        let movie =
            read("2 0.5\n0.25 0.5 3.0 4.0\n0.0 0.125 0.0 0.0\n\n0.5 0.5 0.0 2.5\n\n").unwrap();
        assert_eq!((movie.size, movie.fastest), (0.5, 5.0));
        assert_eq!(movie.frames, [vec![5000, 10_000, 255, 0, 2500, 0], vec![10_000, 10_000, 128]]);
        assert!(read("").is_err());
        assert!(read("1 0.5\n0.25 0.5\n\n").unwrap_err().to_string().contains("line 2"));
    }
}
