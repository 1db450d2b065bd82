// Henyey-Greenstein scattering (Henyey and Greenstein 1941). `cosine` is between the direction of travel
// before and after; g > 0 scatters forward. Normalised over the sphere.

float phaseHenyeyGreenstein(float cosine, float g) {
    // 1 + g^2 - 2 g cosine, and 1 - g^2, without cancellation.
    float least = float(1.0) - abs(g);
    float along = g < float(0.0) ? -cosine : cosine;
    float d = least * least + float(2.0) * abs(g) * (float(1.0) - along);
    return least * (float(1.0) + abs(g)) / (float(4.0 * PI) * d * sqrt(d));
}

// Two vectors that make an orthonormal frame with `n` (Duff et al. 2017, "Building an orthonormal basis,
// revisited").
void orthonormalFrame(vec3 n, OUT(vec3) a, OUT(vec3) b) {
    float s = n.z < float(0.0) ? float(-1.0) : float(1.0);
    float p = float(-1.0) / (s + n.z);
    float q = n.x * n.y * p;
    a = vec3(float(1.0) + s * n.x * n.x * p, s * q, -s * n.x);
    b = vec3(q, s + n.y * n.y * p, -n.y);
}

// Samples a direction from the phase function around `forward` (unit), by inversion.
vec3 samplePhase(vec3 forward, float g, vec2 u) {
    float cosine = float(1.0) - float(2.0) * u.x;
    if (abs(g) > float(1e-3)) {
        float r = (float(1.0) - g * g) / (float(1.0) + g - float(2.0) * g * u.x);
        cosine = (float(1.0) + g * g - r * r) / (float(2.0) * g);
    }
    cosine = clamp(cosine, float(-1.0), float(1.0));
    float sine = sqrt(max(float(0.0), float(1.0) - cosine * cosine));
    float azimuth =
        float(2.0 * PI) * (u.y - float(0.5));  // Vulkan limits the errors of sin and cos only from -pi to pi
    vec3 a;
    vec3 b;
    orthonormalFrame(forward, a, b);
    return a * (sine * cos(azimuth)) + b * (sine * sin(azimuth)) + forward * cosine;
}
