//! The checks of a program that gives the bits of all pairs, on any number of threads.

use crate::{Grader, scenes};

const THREADS: [usize; 5] = [1, 2, 3, 4, 8];

impl Grader {
    /// The bits of all pairs and their statistics on few threads and many, and no particle is lost.
    pub fn bits_on_any_threads(&self) {
        for threads in THREADS {
            let grader = self.clone().threads(threads);
            grader.resynchronised(&scenes::dense(), 20);
            grader.bits_of_all_pairs(&scenes::dense(), 20);
            grader.bits_of_all_pairs(&scenes::crowd(2), 4);
            grader.bits_of_all_pairs(&scenes::all_leave(), 20);
            grader.resynchronised_on_each(scenes::edges(), 1);
            grader.resynchronised_on_each((1..=20).map(scenes::crowd).collect(), 2);
            grader.resynchronised(&scenes::close_pairs(), 5);
            grader.statistics_of_each_step(&scenes::dense(), 5);
            for scene in scenes::fast() {
                grader.resynchronised(&scene, 10);
            }
        }
        self.same_bits_on_threads(&scenes::dense_with_seed(7), 50, &THREADS);
        self.clone().threads(3).keeps_everyone(&scenes::dense_with_seed(8), 1000);
        // More threads than rows of bins, and more buffers than a loop over a few would read.
        self.clone().threads(17).bits_of_all_pairs(&scenes::all_leave(), 20);
    }
}
