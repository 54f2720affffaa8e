//! `cargo lab facts`: prints the facts of all labs for shell scripts, which cannot read TOML.

use std::collections::BTreeSet;
use std::process::ExitCode;

use anyhow::Result;
use lab_kit::{Facts, Kit, Lab};

/// Prints a line for each fact: the lab's number, the fact's name, its value.
pub(crate) fn run(kit: &Kit) -> Result<ExitCode> {
    let labs: BTreeSet<Lab> = kit.starters().into_iter().chain(kit.solutions()).collect();
    for lab in labs {
        print!("{}", lines(kit, lab)?);
    }
    Ok(ExitCode::SUCCESS)
}

fn lines(kit: &Kit, lab: Lab) -> Result<String> {
    let facts = kit.facts(lab)?;
    let contest = facts.has_contest().then(|| "yes".to_owned());
    let Facts { discs, workers, cluster, hybrid, smoke, .. } = facts;
    let mut lines = format!("{lab} program {}\n", program(kit, lab));
    lines += &format!("{lab} workers {}\n", serde_json::to_value(workers)?.as_str().unwrap_or(""));
    lines += &format!("{lab} discs {}\n", serde_json::to_value(discs)?.as_str().unwrap_or(""));
    let optional = [("contest", contest), ("cluster", cluster), ("hybrid", hybrid)];
    let runs = smoke.into_iter().map(|command| ("smoke", Some(command)));
    for (name, value) in optional.into_iter().chain(runs) {
        lines.extend(value.map(|value| format!("{lab} {name} {value}\n")));
    }
    Ok(lines)
}

/// Returns the program to measure: the solution's. A class's kit lacks the solution of its newest
/// lab, so there it returns the student's own program.
fn program(kit: &Kit, lab: Lab) -> String {
    let own = if kit.solutions().contains(&lab) { "solution" } else { "lab" };
    format!("{own}{lab}")
}

#[cfg(test)]
mod tests {
    use super::lines;
    use lab_kit::Kit;

    #[test]
    fn a_line_for_each_fact_of_a_lab_with_and_without_a_solution() {
        let folder = tempfile::tempdir().unwrap();
        let given = "title = \"bins\"\ndiscs = \"soft\"\nworkers = \"threads\"\n";
        let own = "title = \"ranks\"\ndiscs = \"hard\"\nworkers = \"ranks\"\ncluster = \"all\"\n\
                   smoke = [\"run 3\"]\n[[goal]]\nbeats = \"solution2\"\npoints = 1\n";
        let files = [
            ("labs/lab2/Cargo.toml", ""),
            ("solutions/lab2/Cargo.toml", ""),
            ("solutions/lab2/lab.toml", given),
            ("labs/lab3/Cargo.toml", ""),
            ("labs/lab3/lab.toml", own),
        ];
        let kit = Kit::of_files(folder.path(), &files);
        let lines = ["2", "3"].map(|lab| lines(&kit, lab.parse().unwrap()).unwrap());
        assert_eq!(lines[0], "2 program solution2\n2 workers threads\n2 discs soft\n");
        let all = "3 program lab3\n3 workers ranks\n3 discs hard\n3 contest yes\n3 cluster all\n3 smoke run 3\n";
        assert_eq!(lines[1], all);
    }
}
