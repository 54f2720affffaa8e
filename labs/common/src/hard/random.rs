//! Random scenes, which a seed determines.

use rand_mt::Mt;

use super::{Disc, Scene, SceneError};
use crate::room::room_for;

/// The parameters of a random scene.
///
/// A disc gets its four values in the order x, y, vx, vy. Each is computed from a number u
/// in 0 .. 1 that consists of 53 random bits from the Mersenne Twister MT19937. A coordinate is
/// linear in u. For a velocity component let s = 2 u − 1: the component has the sign of s, and its
/// magnitude is linear in |s|.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RandomScene {
    /// Number of discs.
    pub n: u64,
    /// Side L of the square.
    pub side: f64,
    /// Radius r of a disc.
    pub radius: f64,
    /// Seed of the generator.
    pub seed: u32,
    /// Least and greatest magnitude of a velocity component.
    pub speeds: (f64, f64),
    /// Side of the central square that contains the discs' centres.
    pub within: f64,
}

impl RandomScene {
    /// Returns the assignment's scene. The centres are in the whole square, and the velocity
    /// components have magnitudes from L/(8 r) to L/4.
    pub fn new(n: u64, side: f64, radius: f64, seed: u32) -> Self {
        let speeds = (side / (8.0 * radius), side / 4.0);
        Self { n, side, radius, seed, speeds, within: side - 2.0 * radius }
    }

    /// Sets the least and the greatest magnitude of a velocity component.
    #[must_use]
    pub fn with_speeds(self, least: f64, greatest: f64) -> Self {
        Self { speeds: (least, greatest), ..self }
    }

    /// Restricts the discs' centres to a central square of side `within`.
    #[must_use]
    pub fn with_blob(self, within: f64) -> Self {
        Self { within: within.min(self.side - 2.0 * self.radius), ..self }
    }

    /// Generates the scene.
    ///
    /// # Errors
    /// The numbers do not make a valid scene ([`SceneError`]), or the machine has too little memory
    /// for the discs.
    pub fn draw(&self) -> Result<Scene, SceneError> {
        let Self { n, side, radius, seed, .. } = *self;
        Scene::check_square(side, radius)?;
        let count = Scene::check_count(n)?;
        let mut discs = room_for(count).ok_or(SceneError::Memory("disc", n))?;

        let mut twister = Mt::new(seed);
        for _ in 0..count {
            let x = self.coordinate(unit(&mut twister));
            let y = self.coordinate(unit(&mut twister));
            let vx = self.component(unit(&mut twister));
            let vy = self.component(unit(&mut twister));
            discs.push(Disc::new(x, y, vx, vy));
        }
        Scene::new(side, radius, discs)
    }

    /// Returns a coordinate of a centre, for a number `u` in 0 .. 1.
    fn coordinate(&self, u: f64) -> f64 {
        let Self { side, radius, within, .. } = *self;
        // Rounding must not push a disc that touches a wall through the wall.
        ((side - within) / 2.0 + within * u).clamp(radius, side - radius)
    }

    /// Returns a component of a velocity, for a number `u` in 0 .. 1.
    fn component(&self, u: f64) -> f64 {
        let (least, greatest) = self.speeds;
        let s = 2.0 * u - 1.0;
        (least + (greatest - least) * s.abs()).copysign(s)
    }
}

/// Returns a number in 0 .. 1 with 53 random bits: the generator authors' `genrand_res53`.
fn unit(twister: &mut Mt) -> f64 {
    let high = f64::from(twister.next_u32() >> 5);
    let low = f64::from(twister.next_u32() >> 6);
    (high * 67_108_864.0 + low) / 9_007_199_254_740_992.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_53_bits_of_the_twister() {
        // The first two words of MT19937(5489) are 3499211612 and 581869302.
        let words = (f64::from(3_499_211_612_u32 >> 5), f64::from(581_869_302_u32 >> 6));
        assert_eq!(unit(&mut Mt::new(5489)), (words.0 * 2f64.powi(26) + words.1) / 2f64.powi(53));
    }

    #[test]
    fn the_assignments_scene_keeps_its_ranges() {
        let scene = RandomScene::new(1000, 200.0, 2.0, 3).draw().unwrap();
        for disc in scene.discs() {
            assert!(
                (12.5..=50.0).contains(&disc.vx.abs()) && (12.5..=50.0).contains(&disc.vy.abs())
            );
        }
        let right = scene.discs().iter().filter(|disc| disc.vx > 0.0).count();
        assert!((450..550).contains(&right), "{right} of 1000 move to the right");
    }

    #[test]
    fn a_disc_as_wide_as_the_square_stands_in_the_middle() {
        let scene = RandomScene::new(2, 3.0, 1.5, 1).draw().unwrap();
        assert_eq!((scene.discs()[1].x, scene.discs()[1].y), (1.5, 1.5));
    }
}
