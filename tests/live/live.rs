//! Comparison of the book's live boxes with the kit: positions byte by byte, pair tests step by
//! step.
//!
//! The scripts run in node, or else in a headless Chromium. If neither program is installed,
//! nothing is compared, and a message reports this.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use common::hard::{self, Disc, RandomScene, write_end, write_step};
use common::soft::{FrameFormat, FrameWriter, Particle, Scene, Simulation};
use neighbour_list::{NeighbourList, Workers};
use solution1::{AllPairs, Tally};
use solution2::Sorted;
use solution3::rows_of_each;

/// Returns the scripts' answer to `ask`, an expression over the functions of asked.js. `None` if
/// scripts cannot be run here.
fn scripts(ask: &str) -> Option<String> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let live = here.join("../../book/src/live");
    let mut code = String::new();
    let models = ["random.js", "soft.js", "searches.js", "hard.js", "recorded.js", "owners.js"];
    let models = models.map(|name| live.join(name));
    for file in models.into_iter().chain([here.join("asked.js")]) {
        code += &fs::read_to_string(&file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    }
    let folder = tempfile::tempdir().unwrap();
    let script = folder.path().join("ask.js");
    fs::write(&script, format!("{code}\nprocess.stdout.write({ask});\n")).unwrap();
    if let Some(answer) = output(Command::new("node").arg(&script)) {
        return Some(answer);
    }
    let page = folder.path().join("ask.html");
    let body = format!("<body></body><script>{code}\ndocument.body.textContent = {ask};</script>");
    fs::write(&page, body).unwrap();
    for browser in ["chromium", "chromium-browser", "google-chrome"] {
        let mut command = Command::new(browser);
        command.args(["--headless", "--no-sandbox", "--disable-gpu", "--dump-dom"]).arg(&page);
        if let Some(answer) = output(&mut command) {
            let text = answer.split_once("<body>").expect("a page has a body").1;
            return Some(text.split("</body>").next().unwrap_or_default().to_owned());
        }
    }
    println!("skipped: neither node nor Chromium");
    None
}

/// Returns the output of a command. `None` if the command is not installed.
fn output(command: &mut Command) -> Option<String> {
    let output = command.stderr(Stdio::inherit()).output().ok()?;
    assert!(output.status.success(), "{command:?} failed");
    Some(String::from_utf8(output.stdout).expect("numbers"))
}

/// Checks that `found` equals `expected` line by line, and shows the first difference.
fn assert_same(found: Option<String>, expected: &str, what: &str) {
    let Some(found) = found else { return };
    for (line, (found, expected)) in found.lines().zip(expected.lines()).enumerate() {
        assert_eq!(found, expected, "{what}, line {}", line + 1);
    }
    assert_eq!(found.lines().count(), expected.lines().count(), "{what}: lines");
}

/// Returns the pair tests of each step, one per line, and the final particles.
fn tests(mut engine: impl Simulation, n: u64, seed: u32, steps: u64) -> (String, Vec<Particle>) {
    engine.load(&Scene::official(n, seed).unwrap());
    let mut text = String::new();
    for _ in 0..steps {
        engine.step();
        writeln!(text, "{}", engine.statistics().unwrap().pair_tests).unwrap();
    }
    let mut particles = vec![Particle::default(); n as usize];
    engine.read(0, &mut particles);
    (text, particles)
}

/// Returns the pair tests, and the final particles with every bit.
fn tests_and_bits(engine: impl Simulation, n: u64, seed: u32, steps: u64) -> String {
    let (mut text, particles) = tests(engine, n, seed, steps);
    for Particle { x, y, vx, vy, .. } in particles {
        let [x, y, vx, vy] = [x, y, vx, vy].map(f64::to_bits);
        writeln!(text, "{x:x} {y:x} {vx:x} {vy:x}").unwrap();
    }
    text
}

#[test]
fn a_thousand_steps_are_the_official_output() {
    let (n, seed, steps) = (1000, 1, 1000);
    let scene = Scene::official(n, seed).unwrap();
    let mut engine = AllPairs::<Tally>::default();
    engine.load(&scene);
    let mut out = Vec::new();
    let mut frames =
        FrameWriter::new(&mut out, FrameFormat::Official, n as usize, scene.size()).unwrap();
    let mut particles = scene.particles().to_vec();
    for step in 0..steps {
        engine.step();
        if step % 10 == 0 {
            engine.read(0, &mut particles);
            frames.particles(&particles).unwrap();
            frames.end_frame().unwrap();
        }
    }
    let expected = String::from_utf8(out).unwrap();
    assert_same(scripts("officialOutput(1000, 1, 1000)"), &expected, "all pairs");
}

#[test]
fn all_pairs_have_the_kits_bits_and_counts() {
    for (n, seed) in [(1, 1), (7, 3), (200, 2)] {
        let expected = tests_and_bits(AllPairs::<Tally>::default(), n, seed, 300);
        let ask = format!("testsAndBits(new soft.AllPairs(), {n}, {seed}, 300)");
        assert_same(scripts(&ask), &expected, &format!("{n} particles, seed {seed}"));
    }
}

#[test]
fn bins_have_the_kits_bits_and_counts() {
    for (width, n, steps) in [(1.0, 1000, 1000), (1.5, 300, 100), (3.0, 40, 100)] {
        let expected = tests_and_bits(Sorted::<Tally>::new(width), n, 1, steps);
        let ask = format!("testsAndBits(new soft.Bins({width:?}), {n}, 1, {steps})");
        assert_same(scripts(&ask), &expected, &format!("bins of {width} cutoffs"));
    }
}

/// Compares the counts of lists. The kit sums in a different order, which does not affect counts
/// for a few hundred steps.
#[test]
fn lists_have_the_kits_counts() {
    for (skin, n, steps) in [(0.5, 1000, 300), (0.25, 300, 300), (0.6, 500, 300)] {
        let (expected, _) =
            tests(NeighbourList::<Tally>::new(Workers::if_possible(1), skin, 1), n, 1, steps);
        let ask = format!("tests(new soft.List({skin:?}), {n}, 1, {steps})");
        assert_same(scripts(&ask), &expected, &format!("a skin of {skin} cutoffs"));
    }
}

/// Compares the bits of all pairs with the box of the list, which sums in the order of ids.
#[test]
fn a_list_misses_no_pair() {
    for skin in [0.1, 2.0] {
        let (_, expected) = tests(AllPairs::<Tally>::default(), 300, 4, 300);
        let Some(found) = scripts(&format!("testsAndBits(new soft.List({skin:?}), 300, 4, 300)"))
        else {
            return;
        };
        for (line, p) in found.lines().skip(300).zip(expected) {
            let [x, y, vx, vy] = [p.x, p.y, p.vx, p.vy].map(f64::to_bits);
            assert_eq!(line, format!("{x:x} {y:x} {vx:x} {vy:x}"), "particle {}", p.id);
        }
    }
}

#[test]
fn hard_discs_are_where_the_kit_has_them() {
    for (n, side, radius, seed) in [(10, 20.0, 1.0, 4), (100, 100.0, 2.0, 1)] {
        let scene = RandomScene::new(n, side, radius, seed).draw().unwrap();
        let variant = solution7::VARIANTS.iter().find(|v| v.name == "sequential").unwrap();
        let config = variant.config();
        let mut engine: Box<dyn hard::Simulation> = (variant.build)(&config).unwrap();
        engine.load(&scene);
        let (mut out, mut discs) = (Vec::new(), vec![Disc::default(); n as usize]);
        for step in 1..=50 {
            engine.step();
            engine.read(0, &mut discs);
            write_step(&mut out, step, 0, &discs).unwrap();
        }
        write_end(&mut out, 50, 0, &discs).unwrap();
        let ask = format!("hardSteps({n}, {side:?}, {radius:?}, {seed}, 50)");
        let expected = String::from_utf8(out).unwrap();
        assert_same(scripts(&ask), &expected, &format!("{n} hard discs"));
    }
}

/// Compares the collisions with the collisions of a movie that tests only pairs in sufficiently
/// wide cells.
#[test]
fn cells_miss_no_collision() {
    let ask = "sameHits(200, 60, 1, 3, 30)";
    assert_same(scripts(ask), "30 steps, all the same", "collisions");
}

#[test]
fn rows_are_cut_as_the_labs_cut_them() {
    for (workers, rows) in [(1, 1), (3, 10), (7, 31), (5, 2)] {
        let mut expected = String::from("0");
        rows_of_each(workers, rows).for_each(|block| write!(expected, ",{}", block.end).unwrap());
        let ask = format!("owners.even({rows}, {workers}).join()");
        assert_same(scripts(&ask), &expected, &format!("{rows} rows, {workers} workers"));
        let ask = format!("ownersOfRows(owners.even({rows}, {workers}), {rows})");
        let mut expected = String::new();
        for (worker, block) in rows_of_each(workers, rows).enumerate() {
            block.for_each(|_| write!(expected, "{worker} ").unwrap());
        }
        assert_same(scripts(&ask), &expected, &format!("{rows} rows, {workers} workers"));
    }
    // Block k starts at the first row before which there are at least k of 3 parts of the 12
    // particles.
    assert_same(scripts("owners.balanced([5, 0, 1, 6], 3).join()"), "0,1,4,4", "equal numbers");
    assert_same(scripts("owners.balanced([0, 0], 2).join()"), "0,0,2", "no particles");
    // One row in the middle: the blocks on both sides have copies of it, an empty block has no
    // copies.
    assert_same(scripts("owners.copies([0, 1, 2, 2, 4], 1, 0, 2).join()"), "0,3", "ghosts");
}

/// Shows one disc in a box of side 1 that hits the wall on its right half-way between two frames.
#[test]
fn a_recorded_disc_turns_where_it_was_hit() {
    let words: [u16; 8] = [45_874, 32_767, 65_534, 32_767, 45_874, 32_767, 0, 32_767];
    let ask = format!("recordedPlaces({words:?}, 6, [0, 0.25, 0.5, 0.75, 1])");
    let expected = "0.700 0.850 1.000 0.850 0.700";
    assert_same(scripts(&ask), expected, "positions");
}
