//! Particles in their box.

use anyhow::Result;
use common::soft::{CUTOFF, Particle, Scene};
use oracle::{Model, scenes};

use super::canvas::{BLUE, Canvas, GREY, INK, ORANGE, Panel, Style, filled, outlined};

/// Blank paper around a box, in pixels.
const MARGIN: f64 = 10.0;

/// The official scene of `n` particles after some steps.
pub(super) fn after(steps: usize, n: u64, seed: u32) -> Result<Model> {
    let mut model = Model::new(&Scene::official(n, seed)?);
    (0..steps).for_each(|_| model.step());
    Ok(model)
}

/// The official scene, 500 particles after 200 steps.
pub(super) fn official() -> Result<String> {
    let model = after(200, 500, 1)?;
    Ok(box_of(
        "The official scene: 500 particles in their box, most of them alone",
        &model.particles,
        model.size,
        640.0,
        |neighbours| filled(if neighbours > 0 { ORANGE } else { GREY }),
    ))
}

/// A crowd as the graders use it.
pub(super) fn crowd() -> Result<String> {
    let scene = scenes::crowd(1);
    Ok(box_of(
        "A crowd: 200 particles on top of each other in a box of 2.55 cutoffs",
        scene.particles(),
        scene.size(),
        360.0,
        // Each adds its tint: the darker a point, the more particles reach it.
        |_| filled(ORANGE).faint(0.06),
    ))
}

/// Every particle as a disc whose diameter is the cutoff: discs that overlap repel each other.
fn box_of(
    title: &str,
    particles: &[Particle],
    size: f64,
    pixels: f64,
    style: impl Fn(usize) -> Style,
) -> String {
    let panel = Panel { left: MARGIN, top: MARGIN, pixels, side: size };
    let mut canvas = Canvas::new(title, pixels + 2.0 * MARGIN, pixels + 2.0 * MARGIN);
    for particle in particles {
        let style = style(neighbours(particle, particles));
        canvas.circle(panel.at((particle.x, particle.y)), panel.long(CUTOFF / 2.0), style);
    }
    for particle in particles {
        canvas.circle(panel.at((particle.x, particle.y)), 1.5, filled(INK));
    }
    panel.frame(&mut canvas, outlined(BLUE, 2.0));
    canvas.svg()
}

/// How many others `particle` feels.
pub(super) fn neighbours(particle: &Particle, particles: &[Particle]) -> usize {
    let near = |other: &&Particle| {
        other.id != particle.id && particle.to(other).norm_squared() <= CUTOFF * CUTOFF
    };
    particles.iter().filter(near).count()
}
