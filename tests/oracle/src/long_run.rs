//! What can be said of a long run, in which chaos hides single particles.

use common::soft::{
    Averages, CUTOFF, FrameFormat, FrameWriter, Particle, Scene, Simulation, Statistics,
};
use hmac_sha256::Hash;

use crate::grader::read;
use crate::{Grader, Model, energy, scenes};

/// The reference program's output for `-n 1000 -s 1 -o FILE`.
pub(crate) const OFFICIAL_SHA256: &str =
    "374fe976d9f1d1f831a0a6fadf3339c23bbeca62a7eadd62dc8c8db1fc735357";

impl Grader {
    /// Runs freely beside the model on the official scene: positions agree to 1e-9 until step 200.
    /// Later, chaos has doubled the last digit too often.
    pub fn free_run(&self) {
        self.run(|grader, engine| {
            let scene = scenes::official();
            let mut model = Model::new(&scene);
            engine.load(&scene);
            for step in 1..=200 {
                engine.step();
                model.step();
                for (found, expected) in read(engine, scene.len()).iter().zip(&model.particles) {
                    let off = (found.x - expected.x).hypot(found.y - expected.y);
                    if off.is_nan() || off > 1e-9 {
                        panic!(
                            "{}, step {step}: particle {} is {off:.1e} away from where a run \
                             beside the model takes it",
                            grader.name(),
                            expected.id
                        );
                    }
                }
            }
        });
    }

    /// Writes the official run, n = 1000 and seed 1, in the official format: byte for byte what
    /// the reference program writes.
    pub fn official_bytes(&self) {
        self.run(|grader, engine| {
            let scene = scenes::official();
            engine.load(&scene);
            let mut file = Vec::new();
            let format = FrameFormat::Official;
            let mut frames = FrameWriter::new(&mut file, format, scene.len(), scene.size())
                .expect("memory takes bytes");
            for step in 0..1000 {
                engine.step();
                if step % 10 == 0 {
                    let state = read(engine, scene.len());
                    frames.particles(&state).and_then(|()| frames.end_frame()).expect("memory takes bytes");
                }
            }
            let digest = sha256(&file);
            if digest != OFFICIAL_SHA256 {
                panic!(
                    "{}: the official output differs from the reference program's (sha256 {digest}). \
                     The other tests of the task say which particle goes wrong first; if they pass, \
                     it is a last digit",
                    grader.name()
                );
            }
        });
    }

    /// The statistics of the official scene's second half lie where correct programs' do, and
    /// its energy drifts no further than theirs.
    pub fn long_statistics(&self) {
        self.clone().statistics().run(|grader, engine| {
            let scene = scenes::official();
            let steps = statistics_of_run(engine, &scene, 1000, &grader.name());
            let a = Averages::of(scene.len(), &steps[500..]).expect("500 steps");
            for (name, value, least, greatest) in [
                ("neighbours per particle", a.neighbours, 0.088, 0.105),
                ("absmin", a.absmin, 0.74, 0.87),
                ("absavg", a.absavg, 0.953, 0.961),
            ] {
                if !(least..=greatest).contains(&value) {
                    panic!(
                        "{}: {name} over steps 501 to 1000 is {value:.4}, not {least} to {greatest}",
                        grader.name()
                    );
                }
            }
            let change = energy(&read(engine, scene.len())) / energy(scene.particles()) - 1.0;
            if !(-0.01..=0.09).contains(&change) {
                panic!("{}: the energy changed by {:.1} %", grader.name(), 100.0 * change);
            }
        });
    }

    /// Statistics of each of `steps` steps are those that the model's state before it gives:
    /// counts exactly, distances to 1e-12.
    pub fn statistics_of_each_step(&self, scene: &Scene, steps: usize) {
        let scene = scene.clone();
        self.clone().statistics().run(move |grader, engine| {
            engine.load(&scene);
            let mut before = scene.particles().to_vec();
            for step in 1..=steps {
                engine.step();
                let Some(found) = engine.statistics() else {
                    panic!("{}: no statistics, though they were asked for", grader.name());
                };
                let expected = statistics_of(&before);
                for (what, found, expected) in [
                    (
                        "ordered pairs within the cutoff, navg,",
                        found.navg as f64,
                        expected.navg as f64,
                    ),
                    ("the least distance, dmin,", found.dmin, expected.dmin),
                    ("the sum of distances, davg,", found.davg, expected.davg),
                ] {
                    if (found - expected).abs() > 1e-12 * expected.abs().max(1.0) {
                        panic!("{}, step {step}: {what} is {found}, not {expected}", grader.name());
                    }
                }
                before = read(engine, scene.len());
            }
        });
    }
}

/// The digest of `bytes`, as `sha256sum` prints it.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    Hash::hash(bytes).iter().map(|b| format!("{b:02x}")).collect()
}

fn statistics_of_run(
    engine: &mut dyn Simulation,
    scene: &Scene,
    steps: usize,
    name: &str,
) -> Vec<Statistics> {
    engine.load(scene);
    (0..steps)
        .map(|_| {
            engine.step();
            engine
                .statistics()
                .unwrap_or_else(|| panic!("{name}: no statistics, though they were asked for"))
        })
        .collect()
}

fn statistics_of(particles: &[Particle]) -> Statistics {
    let mut s = Statistics::default();
    for p in particles {
        for q in particles {
            let r2 = (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
            if r2 > 0.0 && r2 <= CUTOFF * CUTOFF {
                let r = r2.sqrt() / CUTOFF;
                s = Statistics { dmin: s.dmin.min(r), davg: s.davg + r, navg: s.navg + 1, ..s };
            }
        }
    }
    s
}
