// What went wrong in tracing: Film::Faults. FAULTS_BINDING is its binding, 19 where there is a film.
#ifndef FAULTS_BINDING
#define FAULTS_BINDING 19
#endif
layout(binding = FAULTS_BINDING, scalar) buffer Faults {
    uint nonFinite;   // samples that were not a number
    uint abandoned;   // paths that would have taken too many rounds
    uint aboveBound;  // collisions in matter denser than its bound, see Path
};
