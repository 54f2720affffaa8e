//! Each drawing is a link to itself: a page on a phone is too narrow for its small print.

/// Puts a link to its own file around every SVG image that is in no link yet, be it an `<img>` or
/// Markdown's `![…](…)`.
pub(crate) fn link(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((at, image)) = next_image(rest) {
        let (before, after) = (&rest[..at], &rest[at + image.len()..]);
        out.push_str(before);
        match drawing(image) {
            Some(file) if image.starts_with('<') && !after.starts_with("</a>") => {
                out.push_str(&format!("<a class=\"figure\" href=\"{file}\">{image}</a>"));
            }
            Some(file) if image.starts_with('!') && !before.ends_with('[') => {
                out.push_str(&format!("[{image}]({file})"));
            }
            _ => out.push_str(image),
        }
        rest = after;
    }
    out + rest
}

/// Where the next image begins, and the image.
fn next_image(text: &str) -> Option<(usize, &str)> {
    let tag = text.find("<img ").and_then(|at| {
        let mut quoted = false;
        let end = text[at..].find(|c| {
            quoted ^= c == '"';
            c == '>' && !quoted
        })?;
        Some((at, &text[at..=at + end]))
    });
    // `vec![` in a program is none: no file stands behind its bracket.
    let markdown = text.match_indices("![").find_map(|(at, _)| {
        let file = at + text[at..].find(']')?;
        let end = text[file..].starts_with("](").then(|| text[file..].find(')'))??;
        Some((at, &text[at..=file + end]))
    });
    [tag, markdown].into_iter().flatten().min_by_key(|(at, _)| *at)
}

/// The SVG file that an image shows.
fn drawing(image: &str) -> Option<&str> {
    let file = match image.split_once("src=\"") {
        Some((_, rest)) => rest.split('"').next(),
        None => image.rsplit_once("](").and_then(|(_, rest)| rest.strip_suffix(')')),
    };
    file.filter(|file| file.ends_with(".svg"))
}

#[cfg(test)]
mod tests {
    use super::link;

    #[test]
    fn drawings_are_links_and_nothing_else() {
        let tag = "<figure>\n<img src=\"figures/a.svg\" alt=\"A > B\">\n</figure> and ";
        let linked = "<figure>\n<a class=\"figure\" href=\"figures/a.svg\"><img \
                      src=\"figures/a.svg\" alt=\"A > B\"></a>\n</figure> and ";
        assert_eq!(link(&tag.repeat(2)), linked.repeat(2));
        assert_eq!(link(linked), linked, "what is a link stays as it is");
        let linked = "see [![A](a.svg)](a.svg).";
        assert_eq!(link("see ![A](a.svg)."), linked);
        assert_eq!(link(linked), linked, "what is a link stays as it is");
        let code = "`vec![0; n]` and ";
        assert_eq!(
            link(&format!("{code}{tag}[B](#b)")),
            format!(
                "{code}<figure>\n<a class=\"figure\" href=\"figures/a.svg\"><img src=\"figures/a.svg\" alt=\"A > B\"></a>\n</figure> and [B](#b)"
            )
        );
        for other in ["", "![A](a.png)", "<img src=\"a.png\"> x.svg", "wow!", "a![0] <img "] {
            assert_eq!(link(other), other);
        }
    }
}
