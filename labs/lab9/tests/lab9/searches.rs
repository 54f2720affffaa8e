//! Questions about steps of hard discs: their candidates, and the bytes of whole runs.

use common::hard::{Disc, Scene, Simulation};
use device::{Gpu, Real};
use device_discs::hard::{Choice, Deal, Finder, HardDiscs};
use lab9::{HARD_VARIANTS, Lab9};
use oracle::hard::{self, Runs};
use oracle::{Ask, Random};
use solution7::{Candidate, Square, pair_hit, wall_hit};

use super::adapter::{adapter, adapter_with_doubles};
use super::filters::{all_pairs, drawn};
use super::launched::SMALL;
use super::lists::sorted;

fn two_thousand() -> Scene {
    hard::scenes::random(2000, 0.2, 2.0, 50)
}

/// Returns the name of the task that a finder belongs to.
fn task_of(deal: Deal) -> &'static str {
    if deal == Deal::Discs { "9.3" } else { "9.4" }
}

/// Asks for the candidates of scenes of all kinds, in single precision and in double precision.
pub(crate) fn candidates(random: &mut Random, ask: &mut impl Ask, deal: Deal) {
    let Some(gpu) = adapter(task_of(deal)) else { return };
    let mut scenes = hard::scenes::all();
    for (least, fraction) in [(250, 0.3), (80, 0.6), (350, 0.05)] {
        let n = least + random.below(100) as u64;
        scenes.push(("drawn", drawn(random, n, fraction, 2.0)));
    }
    candidates_of::<f32>(gpu, ask, deal, &scenes, 1);
    if let Some(gpu) = adapter_with_doubles(task_of(deal)) {
        candidates_of::<f64>(gpu, ask, deal, &scenes, 3);
        candidates_of::<f64>(gpu, ask, deal, &[("2,000 discs", two_thousand())], 50);
    }
}

/// Asks one engine for candidates with a small launch, so that every invocation has several turns.
fn candidates_of<R: Real>(
    gpu: &'static Gpu,
    ask: &mut impl Ask,
    deal: Deal,
    scenes: &[(&'static str, Scene)],
    steps: usize,
) {
    let finder = Finder::<Lab9, R>::new(gpu, deal, SMALL, None);
    let finder = finder.unwrap_or_else(|error| panic!("{error}"));
    let mut engine = HardDiscs::new(finder, Choice::Host);
    for (name, scene) in scenes {
        let question = format!(
            "scene '{name}' of {} discs, in {}, {steps} steps: for each step, number of candidates, then kind (0 \
             corner, 1 and 2 walls, 3 pair), discs and time of each candidate",
            scene.len(),
            std::any::type_name::<R>()
        );
        let found = || {
            engine.load(scene);
            let mut found = Vec::new();
            for _ in 0..steps {
                engine.step();
                found.extend(with_number(engine.candidates()));
            }
            found
        };
        ask.judge(&question, found, |found| are_of_steps(found, scene, steps));
    }
}

/// Returns the number of candidates, followed by the candidates.
fn with_number(candidates: &[Candidate]) -> Vec<f64> {
    [vec![candidates.len() as f64], sorted(candidates)].concat()
}

/// Checks that candidates are the same as in each step of lab 7's sequential program.
fn are_of_steps(found: &[f64], scene: &Scene, steps: usize) -> Result<(), String> {
    let sequential = solution7::VARIANTS.iter().find(|variant| variant.name == "sequential");
    let sequential = sequential.expect("lab 7 has this variant");
    let mut engine = (sequential.build)(&sequential.config()).expect("the engine can be built");
    engine.load(scene);
    let mut discs = scene.discs().to_vec();
    let mut rest = found;
    for step in 1..=steps {
        let right = candidates_of_all_pairs(&discs, Square::of(scene));
        let Some((own, more)) = rest.split_at_checked(1 + 4 * right.len()) else {
            return Err(format!(
                "step {step}: the answer has only {} candidates, which are too few",
                rest.len() / 4
            ));
        };
        are_right(own, &right).map_err(|words| format!("step {step}: {words}"))?;
        rest = more;
        engine.step();
        engine.read(0, &mut discs);
    }
    Ok(())
}

/// Checks that a step has these candidates.
fn are_right(found: &[f64], right: &[Candidate]) -> Result<(), String> {
    if found[0] != right.len() as f64 {
        return Err(format!("there are {} candidates instead of {}", found[0], right.len()));
    }
    let (found, _) = found[1..].as_chunks::<4>();
    let right = sorted(right);
    let (right, _) = right.as_chunks::<4>();
    match found.iter().zip(right).find(|(found, right)| found != right) {
        None => Ok(()),
        Some((found, right)) => Err(format!(
            "kind, discs and time of the first candidate that differs\n     found: {found:?}\n  expected: {right:?}"
        )),
    }
}

/// Returns all collisions that a step can have.
fn candidates_of_all_pairs(discs: &[Disc], square: Square) -> Vec<Candidate> {
    let walls = (0..).zip(discs).filter_map(|(i, disc)| wall_hit(i, disc, square));
    let pairs = all_pairs(discs.len() as u32);
    let pairs = pairs.filter_map(|[a, b]| pair_hit(discs, a, b, square.radius));
    walls.chain(pairs).collect()
}

/// Asks for the bytes of lab 7's sequential program, and for steps that agree with the model. A
/// variant in double precision is asked only if the device supports double precision.
pub(crate) fn same_bytes(
    random: &mut Random,
    ask: &mut impl Ask,
    task: &'static str,
    variant: &'static str,
) {
    let gpu = if variant.ends_with("f64") { adapter_with_doubles(task) } else { adapter(task) };
    if gpu.is_none() {
        return;
    }
    let runs = Runs::new(task, HARD_VARIANTS, variant);
    let sequential = Runs::new(task, solution7::VARIANTS, "sequential");
    runs.bits_of(ask, &sequential, "2,000 discs", &two_thousand(), 50);
    let n = 250 + random.below(100) as u64;
    let scene = drawn(random, n, 0.3, 2.0);
    runs.bits_of(ask, &sequential, "drawn", &scene, 5);
    runs.resynchronised(ask, "crowded", &hard::scenes::random(400, 0.3, 2.0, 1), 5);
}
