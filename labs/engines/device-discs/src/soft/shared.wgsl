// Given to the prefix sum: numbers that the invocations of a workgroup share, in its fast memory (CUDA: __shared__).
//
// The tests replace this file by one that also looks who reads and writes which number when.

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

// Waits until all invocations of the workgroup have come here (CUDA: __syncthreads()). Each of them sees what the
// others wrote before.
fn meet() {
    workgroupBarrier();
}
