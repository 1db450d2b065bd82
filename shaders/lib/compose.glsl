// A picture of splats and a traced one of the same view, as one.

// Both linear and premultiplied, so that light and coverage are mixed alike: where both agree nothing changes
// on the way from one to the other. What has a share of nothing is not looked at, whatever it is.
vec4 composed(vec4 splats, vec4 traced, float tracedShare) {
    if (!(tracedShare > float(0.0))) return splats;
    if (tracedShare >= float(1.0)) return traced;
    return splats + (traced - splats) * tracedShare;
}
