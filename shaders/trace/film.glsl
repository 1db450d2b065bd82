// The film, on which samples are summed: src/pipeline/trace/film.h.
layout(binding = 16, scalar) buffer Sums {
    vec4 sums[];  // premultiplied radiance and coverage
};
layout(binding = 17, scalar) buffer Lost {
    vec4 lost[];  // compensation of the sums
};
layout(binding = 18, scalar) buffer Counts {
    uint counts[];  // finite samples
};
#include "trace/faults.glsl"
layout(binding = 20, scalar) buffer Squares {
    vec2 squares[];  // sum of squares of luminance, and its compensation; coverage is 0 or 1, its own square
};
layout(binding = 21, scalar) readonly buffer Plan {
    PlannedBlock planned[];  // by work group
};
