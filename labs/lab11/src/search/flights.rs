//! The free flights of a window in 32 bits: which particles could meet, eight at a time.
//!
//! Which particles could meet need not be known exactly: a pair too many is computed for nothing, and
//! changes no bit. So single precision will do, if its error is added to the distance asked for.
//! Places are whole numbers of a small length, counted round and round: only their differences
//! matter, and for two that are near each other these are right however wide the box is.

use std::ops::Range;

use common::soft::CUTOFF;
use pulp::{Arch, NullaryFnOnce};
use solution10::kernels::EIGHT;
use solution10::threads::cut;
use solution10::{Bodies, Workers};

use super::layout::Layout;
use super::meeting::View;

/// Where all particles are halfway through the window, and half of the displacement of each.
///
/// Special particles are put on the far side, where they are near none that is not special.
#[derive(Default)]
pub(crate) struct Flights {
    /// Halfway from the first forces to the last, in units of `1 / scale`.
    x: Vec<i32>,
    y: Vec<i32>,
    /// From there to the last forces.
    half_x: Vec<f32>,
    half_y: Vec<f32>,
    scale: f64,
    /// By how much, in length, two flights may come closer than these say.
    lost: f64,
}

/// The flights of a piece of the particles.
struct Fill<'a> {
    x: &'a mut [i32],
    y: &'a mut [i32],
    half_x: &'a mut [f32],
    half_y: &'a mut [f32],
    bodies: &'a Bodies,
    particles: Range<usize>,
    layout: &'a Layout,
    scale: f64,
    special: &'a mut Vec<u32>,
}

impl NullaryFnOnce for Fill<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { x, y, half_x, half_y, bodies, particles, layout, scale, special } = self;
        halves(
            x,
            half_x,
            &bodies.x[particles.clone()],
            &bodies.vx[particles.clone()],
            layout,
            scale,
        );
        halves(
            y,
            half_y,
            &bodies.y[particles.clone()],
            &bodies.vy[particles.clone()],
            layout,
            scale,
        );
        special.clear();
        for first in particles.clone().step_by(EIGHT) {
            let eight = first..(first + EIGHT).min(particles.end);
            let mut any = false;
            for i in eight.clone() {
                any |= layout.is_special(bodies, i);
            }
            if any {
                special.extend(eight.filter(|&i| layout.is_special(bodies, i)).map(|i| i as u32));
            }
        }
        if layout.span.steps > 1 {
            for &i in special.iter() {
                let x = &mut x[i as usize - particles.start];
                *x = x.wrapping_add(i32::MIN);
            }
        }
    }
}

/// The halfway places and half displacements along one axis.
#[inline(always)]
fn halves(place: &mut [i32], half: &mut [f32], x: &[f64], v: &[f64], layout: &Layout, scale: f64) {
    // Numbers near this one are 1 apart: the sum's last 32 bits are a whole number, rounded.
    const WHOLE: f64 = 1.5 * (1_u64 << 52) as f64;
    let time = layout.halfway();
    for (((place, half), x), v) in place.iter_mut().zip(half).zip(x).zip(v) {
        let displacement = v * time;
        *place = ((x + displacement) * scale + WHOLE).to_bits() as u32 as i32;
        *half = (displacement * scale) as f32;
    }
}

impl Flights {
    /// Writes down the flights of all particles, piece by piece up to `ends`; `special` takes the
    /// special ones of each piece. Cells have sides of length `side`.
    pub(crate) fn fill<'a>(
        &mut self,
        bodies: &Bodies,
        layout: &Layout,
        side: f64,
        pieces: impl Iterator<Item = (Range<usize>, &'a mut Vec<u32>)>,
        workers: &Workers,
    ) {
        let size = layout.span.size;
        // Fine enough for the cutoff, coarse enough for the box (52 bits) and for cells (32).
        let unit = (CUTOFF * 2.0_f64.powi(-18))
            .max(size * 2.0_f64.powi(-50))
            .max((side + layout.reach) * 2.0_f64.powi(-28));
        self.scale = 1.0 / unit;
        self.lost = 2.0 * unit + layout.reach * 2.0_f64.powi(-22);
        let room = bodies.len() + EIGHT;
        self.x.resize(room, 0);
        self.y.resize(room, 0);
        self.half_x.resize(room, 0.0);
        self.half_y.resize(room, 0.0);
        let (ranges, specials): (Vec<_>, Vec<_>) = pieces.unzip();
        let ends = || ranges.iter().map(|range: &Range<usize>| range.end);
        let (arch, scale) = (Arch::new(), self.scale);
        let halves = cut(&mut self.half_x, ends()).into_iter().zip(cut(&mut self.half_y, ends()));
        let places = cut(&mut self.x, ends()).into_iter().zip(cut(&mut self.y, ends()));
        let work = places.zip(halves).zip(ranges.iter().cloned().zip(specials)).collect();
        workers.map(work, |(((x, y), (half_x, half_y)), (particles, special))| {
            arch.dispatch(Fill { x, y, half_x, half_y, bodies, particles, layout, scale, special });
        });
    }

    /// The distance `near` as these flights know it.
    pub(crate) fn limit(&self, near: f64) -> f32 {
        ((near + self.lost) * self.scale * (1.0 + 1e-6)) as f32
    }

    /// The flights as slices of one length.
    pub(crate) fn view(&self) -> View<'_> {
        let n = self.x.len();
        View {
            x: &self.x[..n],
            y: &self.y[..n],
            half_x: &self.half_x[..n],
            half_y: &self.half_y[..n],
            scale: self.scale as f32,
        }
    }
}
