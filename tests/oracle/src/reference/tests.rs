use common::soft::{CUTOFF, MASS, Particle, Scene};

use super::{Fineness, exact};
use crate::{Model, energy, potential_of_pair};

fn pair(gap: f64, speed: f64) -> Scene {
    let at = |x, vx| Particle { x, y: 0.5, vx, ..Particle::default() };
    let (a, b) = (0.5 - gap / 2.0, 0.5 + gap / 2.0);
    Scene::new(1.0, vec![at(a, speed / 2.0), at(b, -speed / 2.0)]).unwrap()
}

/// The time of a head-on contact, computed as the integral of dt = dr / |ṙ| with ṙ² = w² - 4 U(r) /
/// m. The substitution r = least + (c - least) s² removes the square root at the turning point.
fn contact_time(speed: f64) -> f64 {
    let rate = |r: f64| speed * speed - 4.0 * potential_of_pair(r, 0.0) / MASS;
    let (mut low, mut high) = (0.5 * CUTOFF, CUTOFF);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if rate(middle) < 0.0 { low = middle } else { high = middle }
    }
    let (least, n) = (high, 200_000);
    let inner = |s: f64| {
        let r = least + (CUTOFF - least) * s * s;
        2.0 * (CUTOFF - least) * s / rate(r).max(1e-300).sqrt()
    };
    // Midpoints: the value at the turning point itself is a limit.
    2.0 * (0..n).map(|k| inner((f64::from(k) + 0.5) / f64::from(n))).sum::<f64>() / f64::from(n)
}

#[test]
fn a_head_on_pair_takes_the_time_that_quadrature_says() {
    let speed = 1.5;
    let (gap, time) = (0.013, 0.012);
    let end = exact(&pair(gap, speed), time, Fineness::FINE).unwrap();
    let way_after = speed * (time - (gap - CUTOFF) / speed - contact_time(speed));
    let found = end[1].x - end[0].x - CUTOFF;
    assert!((found - way_after).abs() < 1e-9, "{found:e} is not {way_after:e}");
    assert!((end[1].vx - speed / 2.0).abs() < 1e-11, "{end:?}");
}

#[test]
fn energy_is_kept_to_a_part_in_ten_billion() {
    let scene = Scene::official(200, 3).unwrap();
    let end = exact(&scene, 0.05, Fineness::FINE).unwrap();
    let (before, after) = (energy(scene.particles()), energy(&end));
    assert!((after / before - 1.0).abs() < 1e-12, "{:e}", after / before - 1.0);
    let moved = scene.particles().iter().zip(&end).any(|(a, b)| a.vx != b.vx && a.vx != -b.vx);
    assert!(moved, "a force acted on a particle");
}

#[test]
fn another_fineness_ends_at_the_same_position() {
    let scene = Scene::official(200, 5).unwrap();
    let fine = exact(&scene, 0.05, Fineness::FINE).unwrap();
    let check = exact(&scene, 0.05, Fineness::CHECK).unwrap();
    let worst = fine.iter().zip(&check).map(|(a, b)| (a.x - b.x).hypot(a.y - b.y));
    let worst = worst.fold(0.0, f64::max);
    assert!(worst < 1e-10, "{worst:e}");
}

#[test]
fn it_agrees_with_the_model_as_its_steps_shrink() {
    // A contact whose step is not small: the model must be near the exact motion, but not equal.
    let scene = pair(0.0101, 1.0);
    let mut model = Model::new(&scene);
    for _ in 0..20 {
        model.step();
    }
    let end = exact(&scene, 20.0 * common::soft::DT, Fineness::FINE).unwrap();
    let off = (end[0].x - model.particles[0].x).abs();
    assert!(off > 1e-8 && off < 1e-3, "{off:e}");
}

#[test]
fn walls_and_corners_reflect() {
    let at = |x, y| Particle { x, y, vx: -1.0, vy: -1.0, ..Particle::default() };
    let scene = Scene::new(1.0, vec![at(0.02, 0.02), at(0.5, 0.01), at(0.508, 0.01)]).unwrap();
    let end = exact(&scene, 0.05, Fineness::FINE).unwrap();
    assert!((end[0].x - 0.03).abs() < 1e-14 && (end[0].y - 0.03).abs() < 1e-14, "{end:?}");
    // The particles touch each other, and both meet the wall at the same time.
    assert!((end[1].y - 0.04).abs() < 1e-14 && (end[2].vy - 1.0).abs() < 1e-14, "{end:?}");
}
