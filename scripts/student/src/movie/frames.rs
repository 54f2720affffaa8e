//! The frames of a run, small enough for a page.

use anyhow::{Context, Result, bail};
use common::soft::{CUTOFF, MASS, Particle};
use oracle::potential_of_pair;

/// Positions are whole numbers from 0 to this across the box, velocities from minus this to this,
/// the greatest component of all frames.
pub(super) const GRID: f64 = 10_000.0;

/// A run as a page needs it.
#[derive(Debug)]
pub(super) struct Movie {
    /// Side of the box.
    pub(super) size: f64,
    /// The greatest component of a velocity in any frame.
    pub(super) fastest: f64,
    /// For each frame x, y, vx and vy of one disc after the other.
    pub(super) frames: Vec<Vec<i16>>,
    /// The energy of each frame.
    pub(super) energy: Vec<f64>,
    /// For each frame how many pairs are within the cutoff; none of hard discs.
    pub(super) touching: Vec<usize>,
}

/// Reads what a lab of soft discs writes with `--full`: `n size`, then `x y vx vy` lines, frames
/// apart by an empty line.
pub(super) fn soft(text: &str) -> Result<Movie> {
    let mut lines = text.lines();
    let header = lines.next().and_then(|line| line.split_once(' '));
    let size: f64 = header.and_then(|(_, size)| size.parse().ok()).context("no size in line 1")?;
    let mut frames: Vec<Vec<Particle>> = Vec::new();
    let mut frame = Vec::new();
    for (at, line) in lines.enumerate() {
        if line.is_empty() {
            frames.push(std::mem::take(&mut frame));
            continue;
        }
        let [x, y, vx, vy] = numbers(line)[..] else { bail!("line {} is not 'x y vx vy'", at + 2) };
        frame.push(Particle { x, y, vx, vy, id: frame.len() as u32 });
    }
    let mut movie = Movie::of(size, &frames);
    for frame in &frames {
        let pairs = pairs(frame);
        movie.touching.push(pairs.len());
        movie.energy.push(kinetic(frame, MASS) + pairs.into_iter().sum::<f64>());
    }
    Ok(movie)
}

/// Reads what a lab of hard discs prints in a square of side `size`: `t i x y vx vy` lines, and at
/// the end lines with counts.
pub(super) fn hard(text: &str, size: f64) -> Result<Movie> {
    let mut frames: Vec<Vec<Particle>> = Vec::new();
    for (at, line) in text.lines().enumerate() {
        let [step, id, x, y, vx, vy] = match numbers(line)[..] {
            [step, id, x, y, vx, vy] => [step, id, x, y, vx, vy],
            // The places of the last step once more.
            [_, _, _, _, _, _, _, _] => continue,
            _ => bail!("line {} is not 't i x y vx vy'", at + 1),
        };
        if step as usize >= frames.len() {
            frames.push(Vec::new());
        }
        let frame = frames.last_mut().context("no step 0")?;
        frame.push(Particle { x, y, vx, vy, id: id as u32 });
    }
    let mut movie = Movie::of(size, &frames);
    movie.energy = frames.iter().map(|frame| kinetic(frame, 1.0)).collect();
    Ok(movie)
}

fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

impl Movie {
    fn of(size: f64, frames: &[Vec<Particle>]) -> Self {
        let speeds = frames.iter().flatten().flat_map(|p| [p.vx.abs(), p.vy.abs()]);
        let fastest = speeds.fold(f64::MIN_POSITIVE, f64::max);
        let whole = |p: &Particle| {
            [p.x / size, p.y / size, p.vx / fastest, p.vy / fastest]
                .map(|share| (share * GRID).round() as i16)
        };
        let frames = frames.iter().map(|frame| frame.iter().flat_map(whole).collect()).collect();
        Self { size, fastest, frames, energy: Vec::new(), touching: Vec::new() }
    }
}

fn kinetic(frame: &[Particle], mass: f64) -> f64 {
    frame.iter().map(|p| mass * (p.vx * p.vx + p.vy * p.vy) / 2.0).sum()
}

/// The potentials of all pairs within the cutoff. In ascending x only a few come next.
fn pairs(frame: &[Particle]) -> Vec<f64> {
    let mut sorted = frame.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x));
    let mut found = Vec::new();
    for (k, a) in sorted.iter().enumerate() {
        for b in sorted[k + 1..].iter().take_while(|b| b.x - a.x <= CUTOFF) {
            let d = a.to(b);
            if d.norm_squared() <= CUTOFF * CUTOFF {
                found.push(potential_of_pair(d.x, d.y));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{hard, soft};

    #[test]
    fn frames_become_whole_numbers() {
        let movie =
            soft("2 0.5\n0.25 0.5 3.0 4.0\n0.0 0.125 0.0 0.0\n\n0.5 0.5 0.0 -2.0\n\n").unwrap();
        assert_eq!((movie.size, movie.fastest), (0.5, 4.0));
        let first = vec![5000, 10_000, 7500, 10_000, 0, 2500, 0, 0];
        assert_eq!(movie.frames, [first, vec![10_000, 10_000, 0, -5000]]);
        assert_eq!((movie.energy, movie.touching), (vec![0.125, 0.02], vec![0, 0]));
        assert!(soft("").is_err());
        assert!(soft("1 0.5\n0.25 0.5\n\n").unwrap_err().to_string().contains("line 2"));
    }

    #[test]
    fn touching_pairs_count_and_store_energy() {
        let movie = soft("2 0.5\n0.1 0.1 0 0\n0.105 0.1 0 0\n\n").unwrap();
        assert_eq!(movie.touching, [1]);
        assert!((movie.energy[0] - (1.0 - 2.0_f64.ln())).abs() < 1e-12, "{:?}", movie.energy);
    }

    #[test]
    fn hard_discs_too() {
        let text = "0 0 1 2 3 0\n0 1 4 4 0 0\n1 0 4 2 3 0\n1 1 4 4 0 0\n1 0 4 2 3 0 0 0\n";
        let movie = hard(text, 8.0).unwrap();
        assert_eq!(movie.frames.len(), 2);
        assert_eq!(movie.frames[1][..4], [5000, 2500, 10_000, 0]);
        assert_eq!(movie.energy, [4.5, 4.5]);
    }
}
