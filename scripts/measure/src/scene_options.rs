//! Options that describe a scene.

use anyhow::{Result, ensure};
use clap::Args;

use super::scene::Scene;

/// Options of a scene without the number of discs.
#[derive(Args)]
pub(crate) struct DiscOptions {
    /// Side of the square of hard discs [default: 20000]
    #[arg(long, value_name = "L", value_parser = positive)]
    length: Option<f64>,
    /// Radius of hard discs [default: 1]
    #[arg(long, value_name = "R", value_parser = positive)]
    radius: Option<f64>,
    /// Least and greatest velocity component of hard discs [default: L/(8r),L/4]
    #[arg(long, value_name = "LEAST,GREATEST", value_parser = two_numbers)]
    speeds: Option<(f64, f64)>,
    /// Place hard discs in a square of this side in the middle [default: anywhere]
    #[arg(long, value_name = "SIDE", value_parser = positive)]
    blob: Option<f64>,
    /// Mean number of soft discs in the area of a cutoff disc: the box of the official scene
    /// becomes larger or smaller [default: the official 0.63]
    #[arg(long, value_name = "X", value_parser = positive)]
    neighbours: Option<f64>,
}

/// The options of a scene that all programs share.
#[derive(Args)]
pub(crate) struct OneScene {
    /// Number of particles [default: 100000; 10000 hard discs]
    #[arg(short, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) n: Option<u32>,
    #[command(flatten)]
    discs: DiscOptions,
}

impl OneScene {
    /// Makes the scene of soft or of hard discs.
    pub(crate) fn scene(&self, hard: bool) -> Result<Scene> {
        self.discs.scene(self.n.map(|n| n as usize), hard)
    }
}

impl DiscOptions {
    /// Makes the scene of `n` discs, or of the usual number.
    pub(crate) fn scene(&self, n: Option<usize>, hard: bool) -> Result<Scene> {
        let Self { length, radius, speeds, blob, neighbours } = *self;
        let usual = Scene::usual(n, hard);
        if let Scene::Hard { n, side, radius: usual_radius, .. } = usual {
            ensure!(neighbours.is_none(), "hard discs have no --neighbours");
            let side = length.unwrap_or(side);
            let radius = radius.unwrap_or(usual_radius);
            return Ok(Scene::Hard { n, side, radius, speeds, blob });
        }
        ensure!(
            length.or(radius).or(blob).is_none() && speeds.is_none(),
            "soft discs have no --length, --radius, --speeds and --blob"
        );
        let n = usual.n();
        Ok(neighbours.map_or(usual, |neighbours| Scene::Spread { n, neighbours }))
    }
}

fn positive(text: &str) -> Result<f64, String> {
    let value = text.parse().ok().filter(|v: &f64| v.is_finite() && *v > 0.0);
    value.ok_or_else(|| format!("'{text}' is no positive number"))
}

fn two_numbers(text: &str) -> Result<(f64, f64), String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|text| text.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[least, greatest]) if least.is_finite() && greatest.is_finite() => {
            Ok((least, greatest))
        }
        _ => Err("expected two numbers, LEAST,GREATEST".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: DiscOptions =
        DiscOptions { length: None, radius: None, speeds: None, blob: None, neighbours: None };

    #[test]
    fn a_scene_is_what_the_command_line_says_of_its_kind_of_discs() {
        assert_eq!(NONE.scene(None, true).unwrap(), Scene::usual(None, true));
        assert_eq!(NONE.scene(None, false).unwrap(), Scene::usual(None, false));
        let discs = DiscOptions { length: Some(1e7), speeds: Some((2.0, 5.0)), ..NONE };
        let speeds = Some((2.0, 5.0));
        let expected = Scene::Hard { n: 7, side: 1e7, radius: 1.0, speeds, blob: None };
        assert_eq!(discs.scene(Some(7), true).unwrap(), expected);
        assert!(discs.scene(Some(7), false).is_err());
        let discs = DiscOptions { neighbours: Some(4.7), ..NONE };
        let expected = Scene::Spread { n: 500, neighbours: 4.7 };
        assert_eq!(discs.scene(Some(500), false).unwrap(), expected);
        assert!(discs.scene(Some(500), true).is_err());
        assert!(positive("inf").is_err() && positive("0").is_err());
        assert_eq!(two_numbers("2, 5"), Ok((2.0, 5.0)));
        assert!(two_numbers("2").is_err() && two_numbers("2,nan").is_err());
    }
}
