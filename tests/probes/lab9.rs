//! What is asked about lab 9: launches, and hard discs. Soft discs are in `lab9_soft.rs`.
//!
//! Kernels run on whatever Vulkan finds, on a grader's machine mostly a driver made of software. In
//! which order invocations come is not fixed, so lists are told sorted.

use common::hard::Simulation;
use device::Gpu;
use device_discs::hard::{Choice, Deal, Finder, HardDiscs, HardKernels};
use lab9::Lab9;

use self::launched::SMALL;
use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "lab9_soft.rs"]
mod discs;
#[path = "../lab9/launched.rs"]
mod launched;
#[path = "../lab9/questions.rs"]
mod questions;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "9.1" => {
            questions::launches(random, &mut answers.told());
            questions::refusals(gpu(), &mut answers.told());
        }
        "9.2" => filters(random, answers),
        "9.3" => {
            questions::confirmed(random, &mut answers.told());
            questions::grown(random, finder, &mut answers.told());
            questions::turns(gpu(), ("find_of_discs", Lab9::basic()), &mut answers.told());
            basic(random, answers);
        }
        "9.4" => {
            questions::rectangles(gpu(), random, &mut answers.told());
            questions::turns(gpu(), ("find_of_pairs", Lab9::balanced()), &mut answers.told());
        }
        "9.5" => questions::choices(gpu(), random, &mut answers.told()),
        "9.6" => questions::scans(gpu(), random, &mut answers.told()),
        "9.7" => discs::sorts(random, answers),
        "9.8" => discs::single(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

fn gpu() -> &'static Gpu {
    Gpu::shared().unwrap_or_else(|error| panic!("{error}"))
}

fn finder() -> Finder<Lab9, f32> {
    Finder::new(gpu(), Deal::Discs, SMALL, None).unwrap_or_else(|error| panic!("{error}"))
}

fn filters(random: &mut Random, answers: &mut Answers) {
    questions::slow_and_many(gpu(), random, &mut answers.told());
    for (least, fraction, speed) in [(80, 0.3, 2.0), (120, 0.6, 1.0), (120, 0.02, 10.0)] {
        let n = least + random.below(60) as u64;
        let scene = questions::scene(random, n, fraction, speed);
        let name = format!("{n} discs on {fraction} of the square");
        questions::filtered::<f32>(gpu(), &name, &scene, true, &mut answers.told());
        if gpu().expect_real::<f64>().is_ok() {
            questions::filtered::<f64>(gpu(), &name, &scene, true, &mut answers.told());
        }
    }
}

/// The candidates of steps, and where they take the discs.
fn basic(random: &mut Random, answers: &mut Answers) {
    let mut engine = HardDiscs::new(finder(), Choice::Host);
    for (least, fraction) in [(250, 0.3), (80, 0.6), (350, 0.05)] {
        let (n, steps) = (least + random.below(100) as u64, 3 + random.below(3));
        let scene = questions::scene(random, n, fraction, 2.0);
        let name = format!("{n} discs on {fraction} of the square");
        questions::candidates(&mut engine, (&name, &scene), steps, &mut answers.told());
        let mut discs = scene.discs().to_vec();
        engine.read(0, &mut discs);
        let state: Vec<f64> = discs.iter().flat_map(|d| [d.x, d.y, d.vx, d.vy]).collect();
        answers.exact(&format!("{name}, after {steps} steps, as x y vx vy"), &state);
    }
}
