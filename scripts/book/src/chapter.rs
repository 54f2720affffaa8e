//! A chapter taken apart: its sections, its lists, its figures.

/// What stands before the first task.
pub(crate) fn before_build(text: &str) -> &str {
    text.split_once("\n## Build\n").map_or(text, |(before, _)| before)
}

/// Whether a reader can move something: a box that plays, or a run to step through.
pub(crate) fn moves(text: &str) -> bool {
    ["<figure class=\"live\"", "<figure class=\"steps\""].iter().any(|figure| text.contains(figure))
}

/// The figures, from `<figure` to its end.
pub(crate) fn figures(text: &str) -> impl Iterator<Item = &str> {
    text.split("<figure").skip(1).filter_map(|rest| rest.split("</figure>").next())
}

/// What a figure lacks for a reader who cannot see it, or sees it still. A figure of text is its own words.
pub(crate) fn wordless(figure: &str) -> Option<String> {
    let is_text = figure.contains("```text");
    let within = |from: &str, to: &str| {
        let words = figure.split_once(from).and_then(|(_, rest)| rest.split(to).next());
        words.is_some_and(|words| !words.trim().is_empty())
    };
    let file = figure.split_once("src=\"").and_then(|(_, rest)| rest.split('"').next());
    let name = file.unwrap_or("without a picture");
    let lacks = [
        (!is_text && !within("alt=\"", "\""), "alternative text"),
        (!within("<figcaption>", "</figcaption>"), "caption"),
    ];
    let lacks: Vec<_> =
        lacks.into_iter().filter_map(|(lacks, what)| lacks.then_some(what)).collect();
    (!lacks.is_empty()).then(|| format!("the figure {name} has no {}", lacks.join(" and no ")))
}

/// What follows a heading.
pub(crate) fn section<'t>(text: &'t str, heading: &str) -> Option<&'t str> {
    text.split_once(&format!("\n{heading}\n")).map(|(_, rest)| rest)
}

/// The items of a numbered list, from line to line.
pub(crate) fn items(text: &str) -> Vec<String> {
    let mut items: Vec<String> = Vec::new();
    for line in text.lines() {
        let numbered = line.split_once(". ").is_some_and(|(n, _)| n.parse::<u8>().is_ok());
        match items.last_mut() {
            _ if numbered => items.push(line.into()),
            Some(item) if line.starts_with(' ') => *item += line,
            _ => {}
        }
    }
    items
}
