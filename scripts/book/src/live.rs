//! The scripts of what plays, on the pages that have it: boxes, and tables to step through.

/// What a page has, and the scripts that this needs.
const FIGURES: [(&str, &[&str]); 2] =
    [("<figure class=\"live\"", &BOXES), ("<figure class=\"steps\"", &["steps"])];

/// In the order in which they need each other; they lie in book/src/live.
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

/// The page, with the scripts at its end that its figures need. The page lies `depth` folders below
/// the book's own.
pub(crate) fn scripts(page: String, depth: usize) -> String {
    let root = "../".repeat(depth);
    let wanted = FIGURES.iter().filter(|(figure, _)| page.contains(figure));
    let tags: String = wanted
        .flat_map(|(_, scripts)| *scripts)
        .map(|name| format!("<script src=\"{root}live/{name}.js\"></script>\n"))
        .collect();
    if tags.is_empty() { page } else { format!("{page}\n\n{tags}") }
}

#[cfg(test)]
mod tests {
    use super::scripts;

    #[test]
    fn only_pages_with_figures_that_play_have_scripts() {
        assert_eq!(scripts("# A\n\n<figure>".into(), 0), "# A\n\n<figure>");
        let page = scripts("<figure class=\"live\" data-box=\"idea\">".into(), 1);
        assert!(page.contains("<script src=\"../live/random.js\"></script>"), "{page}");
        let page = scripts("<figure class=\"steps\">".into(), 0);
        assert_eq!(page.matches("<script").count(), 1, "{page}");
        assert!(page.contains("<script src=\"live/steps.js\"></script>"), "{page}");
    }
}
