//! Scenes and states in files, with all digits.

use std::fs;
use std::io;
use std::path::Path;

use common::soft::{FrameFormat, FrameWriter, Particle, Scene};
use common::write_whole;

/// Writes a scene in the format that the labs read.
///
/// # Errors
/// If the file cannot be written.
pub fn write_scene(path: &Path, scene: &Scene) -> io::Result<()> {
    write_whole(path, |out| {
        let mut writer = FrameWriter::new(out, FrameFormat::Full, scene.len(), scene.size())?;
        writer.particles(scene.particles())
    })
}

/// Reads the states of a file of full frames, each of `n` particles. The file may have an extra
/// first line.
///
/// # Errors
/// If the file cannot be read, or does not contain such states.
pub fn read_frames(path: &Path, n: usize) -> io::Result<Vec<Vec<Particle>>> {
    let text = fs::read_to_string(path)?;
    let lines = text.lines().filter(|line| !line.is_empty()).enumerate();
    let lines = lines.filter(|(at, line)| *at > 0 || line.split(' ').count() == 4);
    let particle = |(at, (_, line)): (usize, (usize, &str))| {
        let numbers: Option<Vec<f64>> = line.split(' ').map(|number| number.parse().ok()).collect();
        let [x, y, vx, vy] = numbers?[..] else { return None };
        Some(Particle { x, y, vx, vy, id: (at % n) as u32 })
    };
    let all: Option<Vec<Particle>> = lines.enumerate().map(particle).collect();
    let frames = all.filter(|all| all.len().is_multiple_of(n));
    let frames = frames.ok_or_else(|| {
        let what = format!("these are not frames of {n} lines 'x y vx vy' each");
        io::Error::new(io::ErrorKind::InvalidData, what)
    })?;
    Ok(frames.chunks(n).map(<[_]>::to_vec).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_is_read_back_to_the_bit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.txt");
        let scene = Scene::official(5, 1).unwrap();
        write_scene(&path, &scene).unwrap();
        assert_eq!(read_frames(&path, 5).unwrap(), [scene.particles().to_vec()]);
        assert!(read_frames(&path, 3).is_err());
    }
}
