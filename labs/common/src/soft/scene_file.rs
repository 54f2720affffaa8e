//! Reads a scene from a text file.

use std::io::{self, BufRead};

use thiserror::Error;

use super::{Particle, Scene, SceneError};

/// The reason why a file does not contain a scene.
#[derive(Debug, Error)]
pub enum SceneFileError {
    /// The file cannot be read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The file ends too early, or a line has the wrong form.
    #[error("{0}")]
    Text(String),
    /// The numbers do not make a valid scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
}

/// Reads a scene: a line `n size`, then n lines `x y vx vy`. Later lines are ignored.
///
/// So a file of full frames (`--full`) is a scene: its first frame.
///
/// # Errors
/// A [`SceneFileError`], which names the line.
pub fn read_scene(input: impl BufRead) -> Result<Scene, SceneFileError> {
    let mut lines = input.lines();
    let first = lines.next().transpose()?.unwrap_or_default();
    let (n, size) = header(&first).ok_or_else(|| bad(1, "'n size'", &first))?;
    Scene::check_count(n)?;

    // The list grows particle by particle, because a file may claim a billion particles and contain
    // three.
    let mut particles = Vec::new();
    for line in 2.. {
        if particles.len() as u64 == n {
            break;
        }
        let Some(text) = lines.next().transpose()? else {
            let found = particles.len();
            let what = format!("the file ends after {found} of {n} particles");
            return Err(SceneFileError::Text(what));
        };
        let [x, y, vx, vy] = numbers(&text).ok_or_else(|| bad(line, "'x y vx vy'", &text))?;
        particles.push(Particle { x, y, vx, vy, id: 0 });
    }
    Ok(Scene::new(size, particles)?)
}

fn header(text: &str) -> Option<(u64, f64)> {
    let (n, size) = text.trim().split_once(char::is_whitespace)?;
    Some((n.parse().ok()?, size.trim().parse().ok()?))
}

fn numbers<const K: usize>(text: &str) -> Option<[f64; K]> {
    let numbers: Vec<f64> =
        text.split_whitespace().map(str::parse).collect::<Result<_, _>>().ok()?;
    numbers.try_into().ok()
}

fn bad(line: usize, expected: &'static str, found: &str) -> SceneFileError {
    let found = if found.trim().is_empty() {
        "an empty line".to_owned()
    } else {
        format!("'{}'", found.chars().take(60).collect::<String>())
    };
    SceneFileError::Text(format!("line {line}: expected {expected}, found {found}"))
}
