// region: 9.3b
// fails: task_9_3_the_list_grows_and_starts_again
// story: Where the device has no memory for all candidates the search gives up, though parts of the rows would have room.
        let mut count = finder.run(rows.clone());
        if count > finder.capacity() {
            finder.grow(count)?;
            count = finder.run(rows);
        }
        finder.fetch(count, found);
        Ok(())
