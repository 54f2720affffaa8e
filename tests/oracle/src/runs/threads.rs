//! Questions to a program that produces the bits of all pairs on any number of threads.

use super::Runs;
use crate::{Ask, scenes};

const THREADS: [usize; 5] = [1, 2, 3, 4, 8];

impl Runs {
    /// Asks for the bits of all pairs and their statistics on few and many threads, and whether
    /// particles are lost.
    pub fn bits_on_any_threads(&self, ask: &mut impl Ask) {
        for threads in THREADS {
            let runs = self.clone().threads(threads);
            runs.resynchronised(ask, &scenes::dense(), 20);
            runs.bits_of_all_pairs(ask, &scenes::dense(), 20);
            runs.bits_of_all_pairs(ask, &scenes::crowd(2), 4);
            runs.bits_of_all_pairs(ask, &scenes::all_leave(), 20);
            runs.resynchronised_on_each(ask, scenes::edges(), 1);
            runs.resynchronised_on_each(ask, (1..=20).map(scenes::crowd).collect(), 2);
            runs.resynchronised(ask, &scenes::close_pairs(), 5);
            runs.statistics_of_each_step(ask, &scenes::dense(), 5);
            for scene in scenes::fast() {
                runs.resynchronised(ask, &scene, 10);
            }
        }
        self.same_bits_on_threads(ask, &scenes::dense_with_seed(7), 50, &THREADS);
        self.clone().threads(3).keeps_everyone(ask, &scenes::dense_with_seed(8), 1000);
        // There are more threads (17) than rows of bins. So a program that adds up the buffers of
        // only some threads is detected too.
        self.clone().threads(17).bits_of_all_pairs(ask, &scenes::all_leave(), 20);
    }
}
