// Blends a picture of splats and a traced one of the same view.

// Both are linear and premultiplied, so that light and coverage mix alike and equal pictures stay equal. A
// picture with a share of 0 is not used at all: its pixels may be NaN.
vec4 composed(vec4 splats, vec4 traced, float tracedShare) {
    if (!(tracedShare > float(0.0))) return splats;
    if (tracedShare >= float(1.0)) return traced;
    return splats + (traced - splats) * tracedShare;
}
