// region: 9.3b
// fails: task_9_3_the_list_grows_and_starts_again
// story: What has no room in the list is dropped, as in the report's programs that end at 50,000 discs.
        let count = finder.run(rows).min(finder.capacity());
        finder.fetch(count, found);
        Ok(())
