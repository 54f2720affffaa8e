// region: 7.8b
// fails: task_7_8_no_thread_comes_between_a_load_and_a_store
// story: Whether something is left is looked at before a part is taken: another worker takes the last one in between, and an empty part beyond the end is handed out.
if next.load() >= n {
    return None;
}
let start = next.fetch_add(chunk);
Some(start..n.min(start + chunk))
