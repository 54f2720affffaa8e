//! A lab's hints, folded into its chapter.

use anyhow::{Result, ensure};

use lab_kit::hints;
use lab_kit::{Kit, Lab};

/// What the three hints of a task are called.
const TIERS: [&str; hints::TIERS] = ["a nudge", "the idea", "nearly the answer"];

/// The hints of lab `2` or of task `2.4`, each behind its own fold.
///
/// # Errors
/// There is no such lab or task, or its file of hints is not as it should be.
pub(crate) fn folded(kit: &Kit, what: &str) -> Result<String> {
    let number = what.split('.').next().unwrap_or_default();
    let lab: Lab = number.parse().map_err(anyhow::Error::msg)?;
    let mut out = String::new();
    for hints in hints::read(kit, lab)? {
        if what.contains('.') && hints.task.to_string() != what {
            continue;
        }
        out.push_str(&format!("\n**Task {}: {}**\n", hints.task, hints.title));
        for (tier, hint) in TIERS.iter().zip(&hints.tiers) {
            out.push_str(&format!(
                "\n<details class=\"hint\"><summary>Hint: {tier}</summary>\n\n{hint}\n\n</details>\n"
            ));
        }
    }
    ensure!(!out.is_empty(), "labs/lab{lab}/hints.md has no hints for {what}");
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::folded;
    use lab_kit::Kit;

    #[test]
    fn one_task_or_all() {
        let folder = tempfile::tempdir().unwrap();
        let kit = Kit::at(folder.path());
        let hints = "## Task 1.1: the force\n1. Look.\n2. Think.\n3. Write.\n## Task 1.2: the move\n1. a\n2. b\n3. c\n";
        std::fs::create_dir_all(kit.path("labs/lab1")).unwrap();
        std::fs::write(kit.path("labs/lab1/hints.md"), hints).unwrap();

        let one = folded(&kit, "1.1").unwrap();
        assert!(one.contains("Think.") && !one.contains("the move"), "{one}");
        assert_eq!(folded(&kit, "1").unwrap().matches("<details").count(), 6);
        assert!(folded(&kit, "1.7").unwrap_err().to_string().contains("no hints for 1.7"));
        assert!(folded(&kit, "2").is_err());
    }
}
