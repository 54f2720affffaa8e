// region: 5.4
// fails: task_5_4_the_root_gets_everything_in_the_order_of_ranks
// loses: 5.8
// story: The root calls the methods of the other ranks.
root.gather_into(&count);
root.gather_varcount_into(items);
Vec::new()
