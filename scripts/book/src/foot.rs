//! The foot of each page: its licence, and where to report a mistake.

use std::path::Path;

const LICENCE: &str = "Code, text and figures of this book are licensed under \
     <a href=\"https://opensource.org/license/mit\">MIT</a> or \
     <a href=\"https://www.apache.org/licenses/LICENSE-2.0\">Apache 2.0</a>, as you like.";

/// The foot of the page of this file. Where pages are edited, mdBook's `edit-url-template`, says where mistakes are
/// reported: beside it, at `issues/new`, as on GitHub, Codeberg and Gitea.
pub(crate) fn foot(file: &Path, edit: &str) -> String {
    let report = edit.split_once("/edit/").map(|(repository, _)| {
        format!(
            " <a href=\"{repository}/issues/new?title={}:\">Report a mistake on this page</a>.",
            file.display()
        )
    });
    format!("\n\n<footer class=\"foot\">{LICENCE}{}</footer>\n", report.unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::foot;

    #[test]
    fn mistakes_are_reported_where_pages_are_edited() {
        let page = Path::new("lab1.md");
        let there = foot(page, "https://example.org/a/kit/edit/main/book/{path}");
        let link = "href=\"https://example.org/a/kit/issues/new?title=lab1.md:\"";
        assert!(there.contains(link), "{there}");
        assert!(!foot(page, "").contains("Report"), "no address, no link");
    }
}
