// region: 3.3
// fails: task_3_3_every_row_has_one_owner_and_none_has_much_more
// story: The rest goes to the last thread: with 15 rows among 8 it has 8 rows and the others 1 each. Right, and half as fast as it could be.
let each = rows / workers;
let end = if worker + 1 == workers { rows } else { (worker + 1) * each };
worker * each..end
