//! Puts the answer to each prediction of a chapter into a separate fold, below its question.
//!
//! The questions are a numbered list in the section *Predict*. The answers are a list of the same
//! length in the fold of the section *The predictions*. So a reader can unfold one answer without
//! seeing the others.

use anyhow::{Context, Result, ensure};

const QUESTIONS: &str = "## Predict\n";
const ANSWERS: &str = "## The predictions\n";

/// Returns the page with a fold for each of its predictions. A page without predictions stays as it
/// is.
///
/// # Errors
/// The two lists do not have the same length.
pub(crate) fn unfolded(text: &str) -> Result<String> {
    let (Some(questions), Some(begin)) = (text.find(QUESTIONS), text.find(ANSWERS)) else {
        return Ok(text.to_owned());
    };
    let questions = items(&text[questions + QUESTIONS.len()..]);
    let section = &text[begin + ANSWERS.len()..];
    let fold = section.find("<details>").context("the predictions have no fold")?;
    let answers = items(&section[fold..]);
    let end = section.find("</details>").context("the fold of the predictions has no end")?;
    let [asked, answered] = [&questions, &answers].map(Vec::len);
    ensure!(asked == answered, "{asked} predictions have {answered} answers");
    let mut out = text[..begin + ANSWERS.len()].to_owned() + &section[..fold];
    for (number, (question, answer)) in (1..).zip(questions.iter().zip(answers)) {
        out += &format!(
            "<details class=\"prediction\" data-number=\"{number}\"><summary>\n\n{number}. {question}\n\n</summary>\n\n\
             {answer}\n\n</details>\n\n"
        );
    }
    Ok(out + section[end + "</details>".len()..].trim_start())
}

/// Returns the items of the first numbered list of a section.
fn items(section: &str) -> Vec<String> {
    let mut items: Vec<String> = Vec::new();
    for line in section.split_inclusive('\n') {
        if line.starts_with("## ") || line.starts_with("</details>") {
            break;
        }
        let number = format!("{}. ", items.len() + 1);
        if let Some(item) = line.strip_prefix(&number) {
            items.push(item.to_owned());
        } else if let (Some(item), Some(rest)) = (items.last_mut(), line.strip_prefix("   ")) {
            item.push_str(rest);
        }
    }
    items.iter().map(|item| item.trim().to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::unfolded;

    const PAGE: &str = "# Lab\n\n## Predict\n\n1. How much?\n2. Which one,\n   and why?\n\n## The idea\n\n\
        ## The predictions\n\n<details><summary>Answers</summary>\n\n1. Much.\n   More.\n2. This.\n\n</details>\n\n## Test\n";

    #[test]
    fn each_answer_has_a_fold_below_its_question() {
        let page = unfolded(PAGE).unwrap();
        let order = [
            "## The predictions",
            "1. How much?",
            "Much.\nMore.",
            "2. Which one,\nand why?",
            "This.",
            "## Test",
        ];
        let mut from = page.find("## The predictions").unwrap();
        for part in order {
            from += page[from..].find(part).unwrap_or_else(|| panic!("{part}: {page}"));
        }
        assert_eq!(page.matches("<details class=\"prediction\"").count(), 2);
        assert_eq!(unfolded("# A page\n").unwrap(), "# A page\n");
    }

    #[test]
    fn an_answer_that_is_missing_is_an_error() {
        let error = unfolded(&PAGE.replace("2. This.\n", "")).unwrap_err();
        assert_eq!(error.to_string(), "2 predictions have 1 answers");
    }
}
