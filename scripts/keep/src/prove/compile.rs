//! The solution with all its wrong answers in it, compiled.

use std::path::Path;

use anyhow::Result;

use super::Bench;
use super::copy::Copy;
use super::mutate;
use lab_kit::answers::MarkedFile;
use lab_kit::harness::{BuildError, TestProgram};
use lab_kit::wrong::Wrong;

impl Bench<'_> {
    /// Compiles the solution with all its wrong answers in it; beside it, why some of them had to be left
    /// out. An error if the fault is in none of them.
    pub(super) fn mutated(
        &self,
        copy: &Copy,
        files: &[MarkedFile],
        wrongs: &[Wrong],
    ) -> Result<(TestProgram, Vec<Vec<String>>)> {
        let mut refused: Vec<Vec<String>> = vec![Vec::new(); wrongs.len()];
        loop {
            let without: Vec<usize> =
                (0..wrongs.len()).filter(|&i| !refused[i].is_empty()).collect();
            let mutants = mutate::mutate(self.lab, files, wrongs, &without)?;
            let folder = format!("solutions/lab{}", self.lab);
            for mutant in &mutants {
                copy.put(&Path::new(&folder).join(&mutant.path), mutant.text.as_bytes())?;
            }
            match self.build(copy.cargo(), &format!("solution{}", self.lab)) {
                Ok(program) => return Ok((program, refused)),
                Err(BuildError::Compile(errors)) => {
                    // Whose code does not compile is left out, and the others go on.
                    let before = without.len();
                    for error in &errors {
                        for mutant in &mutants {
                            let file = Path::new(&folder).join(&mutant.path);
                            for place in &mutant.places {
                                if error
                                    .places
                                    .iter()
                                    .any(|(f, line)| *f == file && place.holds(*line))
                                {
                                    refused[place.wrong].push(format!(
                                        "it does not compile in its place: {}",
                                        error.rendered
                                    ));
                                }
                            }
                        }
                    }
                    if refused.iter().filter(|why| !why.is_empty()).count() == before {
                        return Err(BuildError::Compile(errors).into());
                    }
                }
                Err(error) => return Err(error.into()),
            }
        }
    }
}
