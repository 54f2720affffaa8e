//! Frames of a run, small enough for a page.

use anyhow::{Context, Result, bail};
use common::soft::{CUTOFF, MASS, Particle};
use oracle::potential_of_pair;

/// Largest encoded number.
///
/// Positions are integers from 0 to this number across the box. For velocities, half of this number
/// means 0, and the whole number means the largest component in all frames.
const WHOLE: f64 = 65_534.0;

/// A run in the form that a page needs.
#[derive(Debug)]
pub(super) struct Movie {
    /// Number of discs.
    pub(super) n: usize,
    /// Side of the box.
    pub(super) size: f64,
    /// Largest component of a velocity in any frame.
    pub(super) fastest: f64,
    /// Encoded x, y, vx and vy of each disc, frame by frame.
    pub(super) numbers: Vec<u16>,
    /// Energy of each frame.
    pub(super) energy: Vec<f64>,
    /// Number of pairs within the cutoff in each frame; empty for hard discs.
    pub(super) touching: Vec<usize>,
    /// Discs of the last frame, and whether each is within the cutoff of another.
    pub(super) still: Vec<(Particle, bool)>,
}

/// Reads the output of a lab of soft discs with `--full`.
///
/// The first line is `n size`. Lines `x y vx vy` follow, with an empty line between frames.
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
    let mut movie = Movie::of(size, &frames)?;
    for (k, frame) in frames.iter().enumerate() {
        let pairs = pairs(frame);
        if k + 1 == frames.len() {
            pairs.iter().flat_map(|(ids, _)| ids).for_each(|id| movie.still[*id as usize].1 = true);
        }
        movie.touching.push(pairs.len());
        let potential: f64 = pairs.iter().map(|(_, energy)| energy).sum();
        movie.energy.push(kinetic(frame, MASS) + potential);
    }
    Ok(movie)
}

/// Reads the output of a lab of hard discs in a square of side `size`. Keeps one of `every` steps.
///
/// The output consists of lines `t i x y vx vy`, and at the end of lines with counts.
pub(super) fn hard(text: &str, size: f64, every: u32) -> Result<Movie> {
    let mut frames: Vec<Vec<Particle>> = Vec::new();
    for (at, line) in text.lines().enumerate() {
        let [step, id, x, y, vx, vy] = match numbers(line)[..] {
            [step, id, x, y, vx, vy] => [step, id, x, y, vx, vy],
            // These lines repeat the positions of the last step.
            [_, _, _, _, _, _, _, _] => continue,
            _ => bail!("line {} is not 't i x y vx vy'", at + 1),
        };
        if !(step as u32).is_multiple_of(every) {
            continue;
        }
        if step as usize / every as usize >= frames.len() {
            frames.push(Vec::new());
        }
        let frame = frames.last_mut().context("no step 0")?;
        frame.push(Particle { x, y, vx, vy, id: id as u32 });
    }
    let mut movie = Movie::of(size, &frames)?;
    movie.energy = frames.iter().map(|frame| kinetic(frame, 1.0)).collect();
    Ok(movie)
}

fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

impl Movie {
    fn of(size: f64, frames: &[Vec<Particle>]) -> Result<Self> {
        let last = frames.last().context("the lab wrote no frame")?;
        let speeds = frames.iter().flatten().flat_map(|p| [p.vx.abs(), p.vy.abs()]);
        let fastest = speeds.fold(f64::MIN_POSITIVE, f64::max);
        let mut numbers = Vec::new();
        for p in frames.iter().flatten() {
            let [vx, vy] = [p.vx, p.vy].map(|v| (v / fastest + 1.0) / 2.0);
            let shares = [p.x / size, p.y / size, vx, vy];
            numbers.extend(shares.map(|share| (share * WHOLE).round() as u16));
        }
        Ok(Self {
            n: last.len(),
            size,
            fastest,
            numbers,
            energy: Vec::new(),
            touching: Vec::new(),
            still: last.iter().map(|disc| (*disc, false)).collect(),
        })
    }

    /// Encodes all numbers in base 64, low bytes first.
    pub(super) fn frames(&self) -> String {
        const LETTERS: &[u8; 64] =
            b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        let bytes: Vec<u8> = self.numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
        for three in bytes.chunks(3) {
            let mut word = [0; 4];
            word[1..=three.len()].copy_from_slice(three);
            let word = u32::from_be_bytes(word);
            for k in 0..4 {
                let letter = char::from(LETTERS[(word >> (18 - 6 * k)) as usize & 63]);
                text.push(if k > three.len() { '=' } else { letter });
            }
        }
        text
    }
}

fn kinetic(frame: &[Particle], mass: f64) -> f64 {
    frame.iter().map(|p| mass * (p.vx * p.vx + p.vy * p.vy) / 2.0).sum()
}

/// Returns all pairs within the cutoff, with their potentials. Sorting by x makes the search short.
fn pairs(frame: &[Particle]) -> Vec<([u32; 2], f64)> {
    let mut sorted = frame.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x));
    let mut found = Vec::new();
    for (k, a) in sorted.iter().enumerate() {
        for b in sorted[k + 1..].iter().take_while(|b| b.x - a.x <= CUTOFF) {
            let d = a.to(b);
            if d.norm_squared() <= CUTOFF * CUTOFF {
                found.push(([a.id, b.id], potential_of_pair(d.x, d.y)));
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
            soft("2 0.5\n0.25 0.5 3.0 4.0\n0.0 0.125 0.0 0.0\n\n0.5 0.5 0.0 -4.0\n0 0 0 0\n\n")
                .unwrap();
        assert_eq!((movie.n, movie.size, movie.fastest), (2, 0.5, 4.0));
        let first = [32_767, 65_534, 57_342, 65_534, 0, 16_384, 32_767, 32_767];
        assert_eq!(movie.numbers[..8], first);
        assert_eq!(movie.numbers[8..12], [65_534, 65_534, 32_767, 0]);
        assert_eq!((&movie.energy[..], &movie.touching[..]), (&[0.125, 0.08][..], &[0, 0][..]));
        assert!(soft("").is_err());
        assert!(soft("1 0.5\n").is_err());
        assert!(soft("1 0.5\n0.25 0.5\n\n").unwrap_err().to_string().contains("line 2"));
    }

    #[test]
    fn numbers_are_letters_of_base_64() {
        let mut movie = soft("1 1\n0 0 0 0\n\n").unwrap();
        movie.numbers = vec![0x6143, 0x2174];
        assert_eq!(movie.frames(), "Q2F0IQ==");
        movie.numbers = vec![0, 0xffff, 1];
        assert_eq!(movie.frames(), "AAD//wEA");
    }

    #[test]
    fn touching_pairs_count_and_store_energy() {
        let movie = soft("3 0.5\n0.105 0.1 0 0\n0.4 0.4 0 0\n0.1 0.1 0 0\n\n").unwrap();
        assert_eq!(movie.touching, [1]);
        assert!((movie.energy[0] - (1.0 - 2.0_f64.ln())).abs() < 1e-12, "{:?}", movie.energy);
        assert!(movie.still.iter().map(|(_, touches)| *touches).eq([true, false, true]));
    }

    #[test]
    fn hard_discs_too() {
        let text = "0 0 1 2 3 0\n0 1 4 4 0 0\n1 0 4 2 3 0\n1 1 4 4 0 0\n2 0 7 2 3 0\n2 1 4 4 0 0\n\
                    2 0 7 2 3 0 0 0\n2 1 4 4 0 0 0 0\n";
        let movie = hard(text, 8.0, 1).unwrap();
        assert_eq!(movie.numbers.len(), 3 * 2 * 4);
        assert_eq!(movie.numbers[8..12], [32_767, 16_384, 65_534, 32_767]);
        assert_eq!(movie.energy, [4.5, 4.5, 4.5]);
        let thinned = hard(text, 8.0, 2).unwrap();
        assert_eq!(thinned.numbers[8..10], [57_342, 16_384]);
        assert_eq!(thinned.energy.len(), 2);
    }
}
