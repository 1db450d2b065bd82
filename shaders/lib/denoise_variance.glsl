// How far a filtered pixel may be off: the mean square error of its luminance (Rec. 709), as far as its
// samples tell.
//
// The a-trous filter propagates variance as if its taps were independent. After some passes they are not:
// neighbours share their noise. At full weights nine passes leave 2.6e-4 of the variance of white noise, and
// the filter counts 1.9e-8. The geometric mean of the variance before the filter and of the one it counts is
// near the truth from no exchange to full (docs/measurements/hybrid-frame.md). It does not tell how far the
// filter blurs.
//
// Needs from its host what denoise_prepare.glsl does, of the same picture; by index of a pixel fetchNoise (of
// the last filterPixel) and fetchMass; and variance.glsl.

float varianceOfFiltered(ivec2 pixel) {
    int index = indexOf(pixel);
    float mass = max(massOfLight(fetchMass(index)), float(0.0));
    // The filter was told of less noise than there is, or of more.
    Prepared prepared = preparePixel(pixel);
    float left =
        sqrt(max(prepared.noise.x, float(0.0))) * sqrt(max(fetchNoise(index).x, float(0.0))) / prepared.told;
    return boundedVariance(left * mass * mass);
}
