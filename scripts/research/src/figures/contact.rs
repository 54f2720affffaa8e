//! One contact of two discs, by three ways to step.

use anyhow::Result;
use common::Vec2;
use common::soft::{CUTOFF, DT, MASS};
use oracle::{acceleration_of_pair, potential_of_pair};

use super::canvas::{BLUE, Canvas, GREY, ORANGE, Panel, Point, filled, outlined};

const PIXELS: f64 = 280.0;
const GAP: f64 = 24.0;
const TOP: f64 = 36.0;
/// Half of the side of a panel, in units of length.
const WIDE: f64 = 1.6 * CUTOFF;
/// Relative speed, and how far aside it is aimed.
const SPEED: f64 = 5.0;
const ASIDE: f64 = 0.2 * CUTOFF;
/// Official steps, until both are through.
const STEPS: usize = 9;

/// The second disc as seen from the first.
#[derive(Clone, Copy)]
struct Pair {
    d: Vec2,
    w: Vec2,
}

impl Pair {
    /// The pull of each on the other, as the pair's own acceleration.
    fn acceleration(self) -> Vec2 {
        -2.0 * acceleration_of_pair(self.d.x, self.d.y)
    }

    fn along(self, slope: Self, h: f64) -> Self {
        Self { d: self.d + h * slope.d, w: self.w + h * slope.w }
    }

    fn official(self, h: f64) -> Self {
        let w = self.w + h * self.acceleration();
        Self { d: self.d + h * w, w }
    }

    fn runge_kutta(self, h: f64) -> Self {
        let slope = |at: Self| Self { d: at.w, w: at.acceleration() };
        let one = slope(self);
        let two = slope(self.along(one, h / 2.0));
        let three = slope(self.along(two, h / 2.0));
        let four = slope(self.along(three, h));
        let ends = self.along(one, h / 6.0).along(four, h / 6.0);
        ends.along(two, h / 3.0).along(three, h / 3.0)
    }

    fn energy(self) -> f64 {
        MASS / 4.0 * self.w.norm_squared() + potential_of_pair(self.d.x, self.d.y)
    }
}

/// A step of a pair.
type Step = fn(Pair) -> Pair;

/// The same contact with the official step, ten small ones for it, and Runge-Kutta's method.
pub(super) fn three() -> Result<String> {
    let ways: [(&str, Step); 3] = [
        ("official step", |pair| pair.official(DT)),
        ("ten small steps for one", |pair| (0..10).fold(pair, |pair, _| pair.official(DT / 10.0))),
        ("Runge-Kutta, official step", |pair| pair.runge_kutta(DT)),
    ];
    let title = "Two discs that meet, by three ways to step: what is left of their energy";
    let mut canvas = Canvas::new(title, 3.0 * PIXELS + 4.0 * GAP, PIXELS + TOP + 60.0);
    for (panel, (name, advance)) in ways.into_iter().enumerate() {
        let left = GAP + panel as f64 * (PIXELS + GAP);
        let panel = Panel { left, top: TOP, pixels: PIXELS, side: 2.0 * WIDE };
        let start = Pair { d: Vec2::new(1.3 * CUTOFF, ASIDE), w: Vec2::new(-SPEED, 0.0) };
        let mut states = vec![start];
        for step in 0..STEPS {
            states.push(advance(states[step]));
        }
        // The centre of the two stays where it is.
        let position = |pair: &Pair, sign: f64| -> Point {
            panel.at((WIDE + sign * pair.d.x / 2.0, WIDE + sign * pair.d.y / 2.0))
        };
        for (sign, colour) in [(-1.0, BLUE), (1.0, ORANGE)] {
            let dots: Vec<Point> = states.iter().map(|pair| position(pair, sign)).collect();
            for part in dots.windows(2) {
                canvas.line(part[0], part[1], outlined(colour, 1.5));
            }
            for end in [dots[0], dots[STEPS]] {
                canvas.circle(end, panel.long(CUTOFF / 2.0), outlined(colour, 1.5));
            }
            for dot in dots {
                canvas.circle(dot, 3.5, filled(colour));
            }
        }
        let change = 100.0 * (states[STEPS].energy() / start.energy() - 1.0);
        let sign = if change < 0.0 { '−' } else { '+' };
        let said = format!("energy {sign}{:.2} %", change.abs());
        panel.frame(&mut canvas, outlined(GREY, 1.5));
        panel.text(&mut canvas, -12.0, 19.0, name);
        panel.text(&mut canvas, PIXELS + 28.0, 16.0, &said);
    }
    Ok(canvas.svg())
}
