//! The first step of grouping: numbers the particles from 0 on, in the order of the task.
//!
//! The drawing in [`grouper`](super::grouper) shows this step as "number".

use neighbour_list::kernels::Pair;

use super::task::Task;

/// Entry of `number` for a particle without a number.
const NONE: u32 = u32::MAX;

/// Numbers from 0 on for all particles of a task, except for particles of couples.
#[derive(Default)]
pub(super) struct Numbering {
    /// For each particle of the task's range, the number of its pairs, at most 255.
    degree: Vec<u8>,
    /// For each particle of the task's range, its number, or [`NONE`].
    number: Vec<u32>,
    /// The particle with each number.
    pub(super) particles: Vec<u32>,
    /// The number of particles in pairs that are grouped elsewhere. These particles have the lowest
    /// numbers.
    pub(super) elsewhere: u32,
    /// The end of the numbers of particles that are grouped elsewhere or may reach a wall. The
    /// groups of these particles are not small groups.
    pub(super) alone: u32,
    /// The pairs that are not couples, as pairs of numbers.
    pub(super) pairs: Vec<Pair>,
}

impl Numbering {
    /// Numbers the particles of a task, and writes its couples to `couples`.
    ///
    /// A couple is a pair whose particles are in no other pair.
    pub(super) fn number(&mut self, task: &Task<'_>, couples: &mut Vec<u32>) {
        let first = task.range.start as u32;
        self.begin(task);
        // These particles come first, so that the least number of a group shows whether it is
        // grouped elsewhere.
        self.number_all(task.elsewhere, first);
        self.elsewhere = self.particles.len() as u32;
        self.number_all(task.alone, first);
        self.alone = self.particles.len() as u32;
        for &pair in task.pairs {
            let [a, b] = pair.map(|i| self.degree[(i - first) as usize]);
            if a | b == 1 {
                couples.extend(pair);
            } else {
                let numbers = pair.map(|i| self.number_of(i, first));
                self.pairs.push(numbers);
            }
        }
        for &i in task.pairs.iter().flatten().chain(task.elsewhere).chain(task.alone) {
            self.degree[(i - first) as usize] = 0;
            self.number[(i - first) as usize] = NONE;
        }
    }

    /// Counts the pairs of each particle.
    fn begin(&mut self, task: &Task<'_>) {
        let n = task.range.len();
        self.degree.resize(n.max(self.degree.len()), 0);
        self.number.resize(n.max(self.number.len()), NONE);
        self.particles.clear();
        self.pairs.clear();
        for &i in task.pairs.iter().flatten() {
            let degree = &mut self.degree[i as usize - task.range.start];
            *degree = degree.saturating_add(1);
        }
    }

    /// Numbers these particles, and makes sure that they do not become part of a couple.
    fn number_all(&mut self, particles: &[u32], first: u32) {
        for &i in particles {
            self.degree[(i - first) as usize] = u8::MAX;
            self.number_of(i, first);
        }
    }

    /// Returns the number of a particle. A particle without a number gets the next number.
    fn number_of(&mut self, i: u32, first: u32) -> u32 {
        let number = &mut self.number[(i - first) as usize];
        if *number == NONE {
            *number = self.particles.len() as u32;
            self.particles.push(i);
        }
        *number
    }
}
