//! Reads a scene from a text file.

use std::io::{self, BufRead, Read};

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

/// The longest line of a scene file, in bytes. Without this limit, the first line of `/dev/zero`
/// would never end.
const LONGEST: u64 = 2000;

/// Reads a scene: a line `n size`, then n lines `x y vx vy`. Lines after an empty line are ignored.
///
/// So a file of full frames (`--full`) can be read as a scene, which is its first frame.
///
/// # Errors
/// A [`SceneFileError`], which names the line.
pub fn read_scene(mut input: impl BufRead) -> Result<Scene, SceneFileError> {
    let first = line_of(&mut input, 1)?.unwrap_or_default();
    let (n, size) = header(&first).ok_or_else(|| bad(1, "'n size'", &first))?;
    Scene::check_count(n)?;

    // The list grows particle by particle, because a file may claim a billion particles and contain
    // three.
    let mut particles = Vec::new();
    for line in 2.. {
        let text = line_of(&mut input, line)?;
        if particles.len() as u64 == n {
            if text.is_some_and(|text| !text.trim().is_empty()) {
                let what = format!("line {line}: there are more than the {n} particles of line 1");
                return Err(SceneFileError::Text(what));
            }
            break;
        }
        let Some(text) = text else {
            let found = particles.len();
            let what = format!("the file ends after {found} of {n} particles");
            return Err(SceneFileError::Text(what));
        };
        let [x, y, vx, vy] = numbers(&text).ok_or_else(|| bad(line, "'x y vx vy'", &text))?;
        particles.push(Particle { x, y, vx, vy, id: 0 });
    }
    Ok(Scene::new(size, particles)?)
}

/// Returns the next line; `None` at the end of the file.
fn line_of(input: &mut impl BufRead, number: usize) -> Result<Option<String>, SceneFileError> {
    let mut text = String::new();
    let read = input.take(LONGEST).read_line(&mut text)?;
    if read as u64 == LONGEST {
        let what = format!("line {number}: it is longer than {LONGEST} bytes: not a scene file");
        return Err(SceneFileError::Text(what));
    }
    Ok((read > 0).then_some(text))
}

fn header(text: &str) -> Option<(u64, f64)> {
    // Some editors on Windows begin a file with an invisible mark.
    let text = text.trim_start_matches('\u{feff}').trim();
    let (n, size) = text.split_once(char::is_whitespace)?;
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
        format!("'{}'", found.trim_end().chars().take(60).collect::<String>())
    };
    SceneFileError::Text(format!("line {line}: expected {expected}, found {found}"))
}

#[cfg(test)]
mod tests {
    use std::io::{BufReader, repeat};

    use super::read_scene;

    #[test]
    fn a_scene_is_as_long_as_its_first_line_says() {
        assert_eq!(read_scene(&b"1 2\n1 1 0 0"[..]).unwrap().len(), 1);
        assert_eq!(read_scene(&b"1 2\n1 1 0 0\n\n1 1 0 0\n"[..]).unwrap().len(), 1, "two frames");
        for (text, what) in [
            ("1 2\n1 1 0 0\n1 1 0 0\n", "line 3: there are more than the 1 particles of line 1"),
            ("2 2\n1 1 0 0\n", "the file ends after 1 of 2 particles"),
            ("2 2\n1 1 0\n", "line 2: expected 'x y vx vy', found '1 1 0'"),
        ] {
            assert_eq!(read_scene(text.as_bytes()).unwrap_err().to_string(), what);
        }
    }

    #[test]
    fn a_file_without_end_is_no_scene() {
        let error = read_scene(BufReader::new(repeat(0))).unwrap_err().to_string();
        assert_eq!(error, "line 1: it is longer than 2000 bytes: not a scene file");
    }
}
