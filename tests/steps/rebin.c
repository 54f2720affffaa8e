/* The end of a step of lab 3, as it comes to mind: all threads move their particles and put them into bins. */
#include <stdio.h>
#include <stdlib.h>

enum { PARTICLES = 100000, BINS = 100, ROOM = 4000, STEPS = 50 };

typedef struct { double x, vx; } particle_t;
typedef struct { int count, inside[ROOM]; } bin_t;

static particle_t particles[PARTICLES];
static bin_t bins[BINS];

static void put(int i) {
    bin_t *bin = &bins[(int)(particles[i].x * BINS)];
    bin->inside[bin->count++] = i;
}

static void step(void) {
    for (int b = 0; b < BINS; b++) bins[b].count = 0;
    #pragma omp parallel for
    for (int i = 0; i < PARTICLES; i++) {
        particles[i].x += 0.0005 * particles[i].vx;
        put(i);
    }
}

int main(void) {
    for (int i = 0; i < PARTICLES; i++) {
        particles[i].x = 0.1 + 0.8 * rand() / RAND_MAX;
        particles[i].vx = 2.0 * rand() / RAND_MAX - 1.0;
    }
    for (int s = 1; s <= STEPS; s++) {
        step();
        int count = 0;
        for (int b = 0; b < BINS; b++) count += bins[b].count;
        if (count != PARTICLES) {
            printf("step %d: %d of %d particles are in bins\n", s, count, PARTICLES);
            return 1;
        }
    }
    printf("%d steps: all particles are in bins\n", STEPS);
    return 0;
}
