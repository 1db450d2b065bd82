// The mean square error of a filtered pixel's luminance (Rec. 709), estimated from its samples.
//
// The a-trous filter propagates variance as if its taps were independent. After some passes they are not:
// neighbours share their noise. At full weights nine passes leave 2.6e-4 of the variance of white noise, and
// the filter propagates 1.9e-8. The geometric mean of the variances before the filter and as propagated is
// near the truth, from no exchange to full exchange (docs/measurements/hybrid-frame.md). It does not include
// the bias of the filter's blur.
//
// Needs from its host what denoise_prepare.glsl needs, for the same picture; by index of a pixel fetchNoise
// (of the last filterPixel) and fetchMass; and variance.glsl.

float varianceOfFiltered(ivec2 pixel) {
    int index = indexOf(pixel);
    float mass = max(massOfLight(fetchMass(index)), float(0.0));
    // Both variances carry the factor that was meant for the filter only.
    Prepared prepared = preparePixel(pixel);
    float left =
        sqrt(max(prepared.noise.x, float(0.0))) * sqrt(max(fetchNoise(index).x, float(0.0))) / prepared.told;
    return boundedVariance(left * mass * mass);
}
