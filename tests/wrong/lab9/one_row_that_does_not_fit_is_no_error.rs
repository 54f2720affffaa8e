// region: 9.3b
// fails: task_9_3_the_list_grows_and_starts_again
// story: Where the device has too little memory the rows are done one by one, and of a row that does not fit the rest is left out, instead of its error passed on.
let count = finder.run(rows.clone());
if count <= finder.capacity() {
    finder.fetch(count, found);
    return Ok(());
}
if finder.grow(count).is_ok() {
    let count = finder.run(rows);
    finder.fetch(count, found);
    return Ok(());
}
for row in rows {
    let count = finder.run(row..row + 1);
    finder.fetch(count.min(finder.capacity()), found);
}
Ok(())
