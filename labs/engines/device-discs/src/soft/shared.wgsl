// Functions for the prefix sum, on the numbers that the invocations of a workgroup share in its fast memory (CUDA:
// __shared__).
//
// The tests replace this file by a file that also records when each invocation reads or writes each number.

// The number of this invocation within its workgroup, for the tests.
var<private> own: u32;

// One number for each invocation of the workgroup.
var<workgroup> shared_numbers: array<u32, THREADS>;

// Writes number k.
fn put(k: u32, number: u32) {
    shared_numbers[k] = number;
}

// Reads number k.
fn fetch(k: u32) -> u32 {
    return shared_numbers[k];
}

// Waits until all invocations of the workgroup have called meet() (CUDA: __syncthreads()). Then each invocation sees
// the numbers that the others wrote before.
fn meet() {
    workgroupBarrier();
}
