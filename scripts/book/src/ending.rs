//! The end of a page: the scripts of its figures, and a foot with the licence.

use std::path::{Path, PathBuf};

/// The first tag of each kind of figure, and the scripts that such a figure needs.
const FIGURES: [(&str, &[&str]); 2] =
    [("<figure class=\"live\"", &BOXES), ("<figure class=\"steps\"", &["pictures", "steps"])];

/// The scripts of the boxes, in the order of their dependencies. They are in book/src/live.
const BOXES: [&str; 13] = [
    "random",
    "soft",
    "searches",
    "hard",
    "player",
    "panel",
    "layers",
    "searching",
    "energy",
    "windows",
    "contact",
    "collisions",
    "boxes",
];

/// Appends the scripts that the figures of a page need. The page is `depth` folders below the
/// book's folder.
pub(crate) fn scripts(page: String, depth: usize) -> String {
    let root = "../".repeat(depth);
    let wanted = FIGURES.iter().filter(|(figure, _)| page.contains(figure));
    let names: Vec<&str> = wanted.flat_map(|(_, scripts)| *scripts).copied().collect();
    if names.is_empty() {
        return page;
    }
    let mut out = page + "\n\n";
    // The last script reads the figures that the other scripts have made.
    for name in names.iter().chain(&["address"]) {
        out += &format!("<script src=\"{root}live/{name}.js\"></script>\n");
    }
    out
}

const LICENCE: &str = "Code, text and figures of this book are licensed under \
     <a href=\"https://opensource.org/license/mit\">MIT</a> or \
     <a href=\"https://www.apache.org/licenses/LICENSE-2.0\">Apache 2.0</a>, as you like.";

/// Name and file of a page of the book.
pub(crate) struct Page {
    pub(crate) name: String,
    pub(crate) file: PathBuf,
}

/// Returns links to the previous and the next page, with the pages' names.
pub(crate) fn neighbours(pages: &[Page], file: &Path) -> String {
    let Some(at) = pages.iter().position(|page| page.file == file) else { return String::new() };
    let root = "../".repeat(file.components().count().saturating_sub(1));
    let before = at.checked_sub(1).map(|at| ("before", &pages[at]));
    let after = pages.get(at + 1).map(|page| ("after", page));
    let mut links = String::new();
    for (way, page) in before.into_iter().chain(after) {
        let to = page.file.with_extension("html");
        links += &format!("<a class=\"{way}\" href=\"{root}{}\">{}</a>", to.display(), page.name);
    }
    format!("\n\n<nav class=\"turn\" aria-label=\"Pages before and after\">{links}</nav>\n")
}

/// Returns the foot of the page of this file.
///
/// `edit` is mdBook's `edit-url-template`. The link for reporting mistakes leads to `issues/new` in
/// the same repository, as on GitHub, Codeberg and Gitea.
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
    use super::*;

    #[test]
    fn only_pages_with_figures_that_play_have_scripts() {
        assert_eq!(scripts("# A\n\n<figure>".into(), 0), "# A\n\n<figure>");
        let page = scripts("<figure class=\"live\" data-box=\"idea\">".into(), 1);
        assert!(page.contains("<script src=\"../live/random.js\"></script>"), "{page}");
        let page = scripts("<figure class=\"steps\">".into(), 0);
        assert_eq!(page.matches("<script").count(), 3, "{page}");
        assert!(page.contains("<script src=\"live/steps.js\"></script>"), "{page}");
    }

    #[test]
    fn pages_before_and_after_have_names() {
        let pages = ["one.md", "exam/two.md", "three.md"]
            .map(|file| Page { name: format!("Page {file}"), file: file.into() });
        let links = neighbours(&pages, Path::new("exam/two.md"));
        assert!(links.contains("class=\"before\" href=\"../one.html\">Page one.md</a>"), "{links}");
        let after = "class=\"after\" href=\"../three.html\">Page three.md</a>";
        assert!(links.contains(after), "{links}");
        assert_eq!(neighbours(&pages, Path::new("one.md")).matches("<a ").count(), 1);
        assert_eq!(neighbours(&pages, Path::new("404.md")), "");
    }

    #[test]
    fn mistakes_are_reported_where_pages_are_edited() {
        let page = Path::new("lab1.md");
        let there = foot(page, "https://example.org/a/kit/edit/main/book/{path}");
        let link = "href=\"https://example.org/a/kit/issues/new?title=lab1.md:\"";
        assert!(there.contains(link), "{there}");
        assert!(!foot(page, "").contains("Report"), "no address, no link");
    }
}
