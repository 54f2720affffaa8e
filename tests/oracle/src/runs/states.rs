//! The states of a run as numbers: x, y, vx, vy of each particle, in the order of ids.

use common::soft::{Particle, Scene, Simulation};

use crate::Model;
use crate::bits::difference;
use crate::compare::one_step;

/// Several states with the same number of particles, concatenated.
pub struct States {
    particles: usize,
    numbers: Vec<f64>,
}

impl States {
    /// Returns a single state.
    pub fn of(state: &[Particle]) -> Self {
        let mut states = Self { particles: state.len(), numbers: Vec::new() };
        states.add(state);
        states
    }

    /// Returns the states after each of `steps` steps of a scene, preceded by the loaded state if
    /// `loaded` is 1.
    pub fn of_run(engine: &mut dyn Simulation, scene: &Scene, steps: usize, loaded: usize) -> Self {
        engine.load(scene);
        let before = (loaded == 1).then(|| read(engine, scene.len()));
        let mut states = Self { particles: scene.len(), numbers: Vec::new() };
        before.iter().for_each(|state| states.add(state));
        states.numbers.extend(Self::of_loaded(engine, scene.len(), steps).numbers);
        states
    }

    /// Returns the states after each of `steps` steps of the loaded scene with `n` particles.
    pub fn of_loaded(engine: &mut dyn Simulation, n: usize, steps: usize) -> Self {
        let mut states = Self { particles: n, numbers: Vec::new() };
        for _ in 0..steps {
            engine.step();
            states.add(&read(engine, n));
        }
        states
    }

    /// Returns the state after `steps` steps of a scene in a row, without a read in between.
    pub fn after_a_run(engine: &mut dyn Simulation, scene: &Scene, steps: usize) -> Self {
        engine.load(scene);
        engine.run(steps as u64);
        Self::of(&read(engine, scene.len()))
    }

    /// Returns the state after `steps` single steps of a scene.
    pub fn of_end(engine: &mut dyn Simulation, scene: &Scene, steps: usize) -> Self {
        engine.load(scene);
        (0..steps).for_each(|_| engine.step());
        Self::of(&read(engine, scene.len()))
    }

    /// Removes the first `count` states from `numbers` and returns them.
    ///
    /// # Errors
    /// If there are too few numbers.
    pub fn split(numbers: &mut &[f64], particles: usize, count: usize) -> Result<Self, String> {
        let Some((own, rest)) = numbers.split_at_checked(4 * particles * count) else {
            return Err("the run is not complete".into());
        };
        *numbers = rest;
        Ok(Self { particles, numbers: own.to_vec() })
    }

    /// Returns the numbers of all states.
    pub fn numbers(self) -> Vec<f64> {
        self.numbers
    }

    /// Returns the number of states.
    pub fn count(&self) -> usize {
        self.numbers.len() / (4 * self.particles)
    }

    /// Returns state number `index`.
    pub fn state(&self, index: usize) -> Vec<Particle> {
        let length = 4 * self.particles;
        let numbers = self.numbers[index * length..(index + 1) * length].chunks_exact(4);
        let particle = |(id, v): (usize, &[f64])| {
            // A particle at another particle's index was read as NaN.
            let id = if v[0].is_nan() { u32::MAX } else { id as u32 };
            Particle { x: v[0], y: v[1], vx: v[2], vy: v[3], id }
        };
        numbers.enumerate().map(particle).collect()
    }

    /// Checks that the states after each step have the same bits as with all pairs.
    ///
    /// # Errors
    /// If they differ: the first wrong particle. A step whose error exceeds rounding is explained,
    /// because a missed pair is more informative than a wrong digit.
    pub fn bits_of_all_pairs(&self, scene: &Scene) -> Result<(), String> {
        let mut model = Model::new(scene);
        let mut before = scene.particles().to_vec();
        for step in 1..=self.count() {
            model.step();
            let after = self.state(step - 1);
            if let Some(words) = difference(&after, &model.particles) {
                one_step(scene.size(), &before, &after, None)
                    .map_err(|mistake| format!("step {step}, {mistake}"))?;
                return Err(format!(
                    "step {step}: the bits differ from those of all-pairs: {words}"
                ));
            }
            before = after;
        }
        Ok(())
    }

    /// Checks that every particle is at its index and inside a box of side `size`.
    ///
    /// # Errors
    /// If a particle is missing or outside: the first such particle.
    pub fn everyone_inside(&self, size: f64) -> Result<(), String> {
        let is_inside = |x: f64| (0.0..=size).contains(&x);
        for step in 1..=self.count() {
            for (id, particle) in self.state(step - 1).iter().enumerate() {
                if particle.id as usize != id || !is_inside(particle.x) || !is_inside(particle.y) {
                    return Err(format!("step {step}: particle {id} is lost or outside the box"));
                }
            }
        }
        Ok(())
    }

    /// Checks that every step agrees with the model up to rounding, starting from the program's own
    /// state before the step.
    ///
    /// # Errors
    /// If a step disagrees: the step, the first wrong particle, and an explanation.
    pub fn follow_the_model(&self, scene: &Scene) -> Result<(), String> {
        let mut before = scene.particles().to_vec();
        for step in 1..=self.count() {
            let after = self.state(step - 1);
            one_step(scene.size(), &before, &after, None)
                .map_err(|mistake| format!("step {step}, {mistake}"))?;
            before = after;
        }
        Ok(())
    }

    fn add(&mut self, state: &[Particle]) {
        for (id, p) in state.iter().enumerate() {
            let is_own = p.id as usize == id;
            let numbers = [p.x, p.y, p.vx, p.vy];
            self.numbers.extend(numbers.map(|v| if is_own { v } else { f64::NAN }));
        }
    }
}

/// Returns the state of an engine. Particles that the engine does not write stay visibly wrong.
pub(crate) fn read(engine: &dyn Simulation, n: usize) -> Vec<Particle> {
    let nan = f64::NAN;
    let unwritten = Particle { x: nan, y: nan, vx: nan, vy: nan, id: u32::MAX };
    let mut state = vec![unwritten; n];
    engine.read(0, &mut state);
    state
}
