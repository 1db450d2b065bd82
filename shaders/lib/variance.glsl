// How noisy one pixel of a traced picture is: the variance of the luminance (Rec. 709) of the mean of its
// samples.
//
// Needs picture.glsl.

// Replaces a variance that is larger or NaN.
#define MOST_LIGHT_VARIANCE 1e24

float boundedVariance(float variance) {
    return variance >= float(0.0) && variance < float(MOST_LIGHT_VARIANCE) ? variance
                                                                           : float(MOST_LIGHT_VARIANCE);
}

// From the sums over `count` samples. The square of a single sample is, on average, its variance plus the
// square of its mean; for a path's light both are about equal, so that half of it counts. Without samples the
// variance is the largest.
float varianceOfMean(vec4 sum, uint count, float squares) {
    if (count == uint(0)) return float(MOST_LIGHT_VARIANCE);
    float samples = float(count);
    float light = luminance(vec3(sum.x, sum.y, sum.z)) / samples;
    float ofSamples =
        max(squares / samples - light * light, float(0.0)) / max(samples - float(1.0), float(1.0));
    if (!isFinite(vec4(light, squares, float(0.0), float(0.0)))) return float(MOST_LIGHT_VARIANCE);
    return boundedVariance(count == uint(1) ? float(0.5) * light * light : ofSamples);
}
