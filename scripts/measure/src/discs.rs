//! The scene of a measurement, as the command line describes it.

use anyhow::{Result, ensure};
use clap::Args;

use super::job::{Random, Scene};

/// What a scene is like, besides the number of discs.
#[derive(Args)]
pub struct Discs {
    /// Side of the square of hard discs [default: 20000]
    #[arg(long, value_name = "L", value_parser = positive)]
    length: Option<f64>,
    /// Radius of hard discs [default: 1]
    #[arg(long, value_name = "R", value_parser = positive)]
    radius: Option<f64>,
    /// Least and greatest velocity component of hard discs [default: L/(8r),L/4]
    #[arg(long, value_name = "LEAST,GREATEST", value_parser = two_numbers)]
    speeds: Option<(f64, f64)>,
    /// Hard discs begin in a square of this side in the middle [default: anywhere]
    #[arg(long, value_name = "SIDE", value_parser = positive)]
    blob: Option<f64>,
    /// Soft discs in the area of a cutoff disc: the official scene, spread or pressed together
    /// until they are so many [default: the official 0.63]
    #[arg(long, value_name = "X", value_parser = positive)]
    neighbours: Option<f64>,
}

impl Discs {
    /// The scene of so many discs, or of as many as fit the problem.
    ///
    /// # Errors
    /// Something is said of discs of the other kind.
    pub fn scene(&self, n: Option<usize>, hard: bool) -> Result<Scene> {
        let Self { length, radius, speeds, blob, neighbours } = *self;
        if !hard {
            ensure!(
                length.or(radius).or(blob).is_none() && speeds.is_none(),
                "soft discs have no --length, --radius, --speeds and --blob"
            );
            let Some(neighbours) = neighbours else { return Ok(Scene::soft(n)) };
            return Ok(Scene::Spread { n: Scene::soft(n).n(), neighbours });
        }
        ensure!(neighbours.is_none(), "hard discs have no --neighbours");
        let mut scene = Scene::hard(n);
        if let Scene::Hard { side: usual_side, radius: usual_radius, random, .. } = &mut scene {
            *usual_side = length.unwrap_or(*usual_side);
            *usual_radius = radius.unwrap_or(*usual_radius);
            *random = Random { speeds, blob };
        }
        Ok(scene)
    }
}

fn positive(text: &str) -> Result<f64, String> {
    let value = text.parse().ok().filter(|v: &f64| v.is_finite() && *v > 0.0);
    value.ok_or_else(|| format!("'{text}' is no positive number"))
}

fn two_numbers(text: &str) -> Result<(f64, f64), String> {
    let number = |text: &str| text.trim().parse().ok().filter(|v: &f64| v.is_finite());
    text.split_once(',')
        .and_then(|(least, greatest)| Some((number(least)?, number(greatest)?)))
        .ok_or_else(|| "expected two numbers, LEAST,GREATEST".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: Discs =
        Discs { length: None, radius: None, speeds: None, blob: None, neighbours: None };

    #[test]
    fn hard_discs_are_what_the_command_line_says() {
        assert_eq!(NONE.scene(None, true).unwrap(), Scene::hard(None));
        let discs = Discs { length: Some(1e7), speeds: Some((2.0, 5.0)), ..NONE };
        let random = Random { speeds: Some((2.0, 5.0)), blob: None };
        let expected = Scene::Hard { n: 7, side: 1e7, radius: 1.0, random };
        assert_eq!(discs.scene(Some(7), true).unwrap(), expected);
        assert!(positive("inf").is_err() && positive("0").is_err());
        assert_eq!(two_numbers("2, 5"), Ok((2.0, 5.0)));
        assert!(two_numbers("2").is_err() && two_numbers("2,nan").is_err());
    }

    #[test]
    fn soft_discs_have_nothing_of_it() {
        assert_eq!(NONE.scene(None, false).unwrap(), Scene::soft(None));
        assert!(Discs { blob: Some(1.0), ..NONE }.scene(None, false).is_err());
    }

    #[test]
    fn neighbours_are_those_of_soft_discs() {
        let discs = Discs { neighbours: Some(4.7), ..NONE };
        let expected = Scene::Spread { n: 500, neighbours: 4.7 };
        assert_eq!(discs.scene(Some(500), false).unwrap(), expected);
        assert!(discs.scene(Some(500), true).is_err());
    }
}
