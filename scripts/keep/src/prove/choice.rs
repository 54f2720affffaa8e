//! How a solution with all its wrong answers in it learns which of them is chosen: from the environment.

use lab_kit::Lab;

/// The environment in which wrong solution `index` of `lab` is chosen.
pub(super) fn environment(lab: Lab, index: usize) -> (String, String) {
    (variable(lab), (index + 1).to_string())
}

/// A lab's code may be another lab's dependency: each has a variable of its own.
fn variable(lab: Lab) -> String {
    format!("CUTOFF_WRONG_{lab}")
}

/// Sends every shader's source through [`chooser`]'s `source`.
pub(super) fn choosing_sources(text: &str) -> String {
    text.split_inclusive('\n')
        .map(|line| match line.find("include_str!(").zip(line.find(".wgsl\")")) {
            Some((first, last)) => {
                let (before, rest) = line.split_at(first);
                let (include, after) = rest.split_at(last + ".wgsl\")".len() - first);
                format!("{before}crate::chosen_wrong::source({include}){after}")
            }
            None => line.to_owned(),
        })
        .collect()
}

/// The module that the chains ask. It is asked in the innermost loops, so it is one load.
pub(super) fn chooser(lab: Lab) -> String {
    let variable = variable(lab);
    format!(
        "
mod chosen_wrong {{
    use std::sync::atomic::{{AtomicU32, Ordering::Relaxed}};

    const UNREAD: u32 = u32::MAX;
    static NUMBER: AtomicU32 = AtomicU32::new(UNREAD);

    #[inline]
    pub(crate) fn number() -> u32 {{
        match NUMBER.load(Relaxed) {{
            UNREAD => read(),
            number => number,
        }}
    }}

    /// A shader with the chosen one of its answers.
    #[allow(dead_code)]
    pub(crate) fn source(all: &'static str) -> &'static str {{
        let number = number().to_string();
        let mut regions = all.split_inclusive(\"//= end\\n\");
        let mut chosen = String::new();
        for region in &mut regions {{
            let mut answers = region.split(\"//= \");
            chosen += answers.next().unwrap_or_default();
            let answers: Vec<_> = answers.filter_map(|answer| answer.split_once('\\n')).collect();
            let of = |wanted: &str| answers.iter().find(|(n, _)| *n == wanted);
            chosen += of(&number).or(of(\"0\")).map_or(\"\", |(_, body)| *body);
        }}
        chosen.leak()
    }}

    #[cold]
    fn read() -> u32 {{
        let number = std::env::var(\"{variable}\").ok().and_then(|n| n.parse().ok()).unwrap_or(0);
        NUMBER.store(number, Relaxed);
        number
    }}
}}
"
    )
}
