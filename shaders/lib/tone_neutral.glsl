// From linear light to what a display gets, without branches: also C++ where float is a vector of several
// pixels (base/vector_in_glsl.h).

// The Khronos PBR neutral tone map (2024): colours as they are up to 0.8, highlights compressed and slowly
// desaturated.
vec3 toneMapNeutral(vec3 colour) {
    float startCompression = float(0.8 - 0.04);
    float desaturation = float(0.15);
    float x = min(colour.x, min(colour.y, colour.z));
    float offset = mix(float(0.04), x - float(6.25) * x * x, x < float(0.08));
    colour -= vec3(offset);
    float peak = max(colour.x, max(colour.y, colour.z));
    float d = float(1.0) - startCompression;
    float newPeak = float(1.0) - d * d / (peak + d - startCompression);
    float g = float(1.0) - float(1.0) / (desaturation * (peak - newPeak) + float(1.0));
    vec3 compressed = mix(colour * (newPeak / peak), vec3(newPeak), g);
    return mix(compressed, colour, bvec3(peak < startCompression));
}

// Linear 0 to 1 to display-encoded (IEC 61966-2-1).
float encodeSrgb(float linear) {
    float c = clamp(linear, float(0.0), float(1.0));
    return mix(float(1.055) * pow(c, float(1.0 / 2.4)) - float(0.055), c * float(12.92),
               c <= float(0.0031308));
}
