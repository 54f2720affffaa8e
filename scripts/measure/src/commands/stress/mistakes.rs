//! Tests with known mistakes. A program with such a mistake must fail, and the correct method must
//! pass.

use common::soft::{CUTOFF, DT, Particle, Scene};
use oracle::Model;

use super::engine::Answer;
use super::judge::{Cell, Judged, Verdict, judge};
use super::method::Method;
use super::trials::{Trial, short};

/// A change of the state after a step. The arguments are the side of the box, the state before the
/// step, and the state after it.
type Mistake = fn(f64, &[Particle], &mut [Particle]);

const NONE: Mistake = |_, _, _| {};

/// Takes official steps, and makes a mistake after each.
fn run(mistake: Mistake, scene: &Scene, trial: &Trial) -> Answer {
    let mut state = scene.particles().to_vec();
    let mut frames = Vec::new();
    for step in 0..trial.steps {
        let before = state.clone();
        let mut model = Model::from_state(scene.size(), state);
        model.step();
        state = model.particles;
        mistake(scene.size(), &before, &mut state);
        if step % trial.every == 0 {
            frames.push(state.clone());
        }
    }
    Ok(Some(frames))
}

#[test]
fn a_pair_that_was_thrown_back_to_a_wall_did_not_pass() {
    let trial = short(4).into_iter().find(|trial| trial.name == "head-on pairs").unwrap();
    let Judged { met, .. } = judge(Method::Official, &trial, &|scene| run(NONE, scene, &trial));
    for met in &met {
        let share = if met.speed == 20 { 0.25 } else { 0.0 };
        assert_eq!(met.through, share, "at relative speed {}, a step is {}", met.speed, DT);
    }
    assert!(met.iter().any(|met| met.worst > 1e6), "no particle was thrown");
}

/// Judges, in all short trials, a program that claims to use the method given in `says`.
fn cells(says: Method, mistake: Mistake) -> Vec<Cell> {
    let mut cells = Vec::new();
    for trial in short(4) {
        cells.extend(judge(says, &trial, &|scene| run(mistake, scene, &trial)).cells);
    }
    cells
}

fn failed(says: Method, mistake: Mistake) -> Vec<&'static str> {
    let mut cells = cells(says, mistake);
    cells.retain(|cell| matches!(cell.verdict, Verdict::Fails(_)));
    cells.iter().map(|cell| cell.column).collect()
}

#[test]
fn the_method_itself_passes_or_shows_its_limits() {
    let cells = cells(Method::Official, NONE);
    for cell in &cells {
        assert!(!matches!(cell.verdict, Verdict::Fails(_)), "{cell:?}");
    }
    for column in ["w 11-20", "very close"] {
        let of_column = cells.iter().find(|cell| cell.column == column).unwrap();
        let is_limit = matches!(of_column.verdict, Verdict::Limit(_));
        assert!(is_limit, "the official step is too long for {column}");
    }
}

/// Moves each particle to its exact end, if that is known.
fn exactly(size: f64, before: &[Particle], after: &mut [Particle]) {
    for (p, expected) in after.iter_mut().zip(Method::Better.step(size, before)) {
        *p = expected.map_or(*p, |(exact, _)| exact);
    }
}

#[test]
fn the_exact_motion_is_caught_if_it_calls_itself_official() {
    let failed = failed(Method::Official, exactly);
    assert!(failed.contains(&"w 1-5"), "more accurate, and not what was asked for");
}

#[test]
fn the_official_step_is_caught_if_it_calls_itself_better() {
    assert!(!failed(Method::Better, NONE).is_empty());
    assert_eq!(failed(Method::Better, exactly), [""; 0]);
    assert!(failed(Method::Better, miss_across_edges).contains(&"edges"));
}

#[test]
fn a_mistake_after_every_step_is_caught() {
    let mistakes: [(&str, Mistake, &[&str]); 5] = [
        ("pairs missed across edges of bins", miss_across_edges, &["edges", "crowd"]),
        (
            "single precision from the corner, in a wide box",
            |_, _, after| {
                for p in after {
                    (p.x, p.y) = (f64::from(p.x as f32), f64::from(p.y as f32));
                }
            },
            &["10^6 c", "w 1-5"],
        ),
        (
            "a wall that takes no particle back",
            |size, before, after| {
                for (p, q) in after.iter_mut().zip(before) {
                    if p.vx == -q.vx && p.vx != 0.0 && q.x > 0.5 * size {
                        (p.x, p.vx) = (size, q.vx);
                    }
                }
            },
            &["walls"],
        ),
        (
            "a position beyond the box",
            |size, _, after| {
                if let Some(p) = after.iter_mut().find(|p| p.x == size || p.y == size || p.x == 0.0)
                {
                    p.x = size.next_up();
                }
            },
            &[],
        ),
        (
            "0 / 0 of two at one position",
            |_, before, after| {
                for (p, q) in after.iter_mut().zip(before).filter(|(_, q)| q.vx.abs() > 1e250) {
                    let zero = q.vx - q.vx;
                    p.vx = zero / zero;
                }
            },
            &["absurd"],
        ),
    ];
    for (what, mistake, columns) in mistakes {
        let failed = failed(Method::Official, mistake);
        assert!(!failed.is_empty(), "{what}");
        assert!(columns.iter().all(|column| failed.contains(column)), "{what}: {failed:?}");
    }
}

/// Leaves out the force on a particle that touches a particle in the next bin.
fn miss_across_edges(size: f64, before: &[Particle], after: &mut [Particle]) {
    for (i, p) in before.iter().enumerate() {
        let mut touching =
            before.iter().filter(|q| p.to(q).norm_squared() < 0.99 * CUTOFF * CUTOFF);
        if touching.any(|q| bin(p.x) != bin(q.x)) {
            after[i].vx = p.vx;
            after[i].vy = p.vy;
            after[i].x = (p.x + p.vx * DT).clamp(0.0, size);
            after[i].y = (p.y + p.vy * DT).clamp(0.0, size);
        }
    }
}

fn bin(x: f64) -> f64 {
    (x / CUTOFF).floor()
}

#[test]
fn an_engine_that_shows_too_little_is_caught() {
    let Judged { cells, .. } =
        judge(Method::Official, &short(4)[0], &|scene| Ok(Some(vec![scene.particles().to_vec()])));
    assert!(cells.iter().all(|cell| matches!(cell.verdict, Verdict::Fails(_))));
}
