#define CONSTANT(type, name) type const RSMPI_##name = MPI_##name;
#include "symbols.h"

double RSMPI_Wtime(void) { return MPI_Wtime(); }
double RSMPI_Wtick(void) { return MPI_Wtick(); }
