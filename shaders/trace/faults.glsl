// Counts of what went wrong in tracing: Film::Faults. FAULTS_BINDING is the binding, 19 in kernels with a
// film.
#ifndef FAULTS_BINDING
#define FAULTS_BINDING 19
#endif
layout(binding = FAULTS_BINDING, scalar) buffer Faults {
    uint nonFinite;   // samples that were not finite
    uint abandoned;   // paths cut off at kMaxRounds
    uint aboveBound;  // collisions in matter denser than its majorant, see Path
};
