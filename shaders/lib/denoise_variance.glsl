// How far a filtered pixel may be off: the mean square error of its luminance (Rec. 709), as far as its samples tell.
//
// The filter takes what its taps show for independent: so it knows how far a pass may reach, but not what is left after
// many, since neighbours then share their noise. Over even matter nine passes leave 3e-4 of the variance, and the filter
// counts 2e-8. The geometric mean of what there was before it and of what it counts is near the truth for any reach, from
// none to all (docs/measurements/hybrid-frame.md). It knows nothing of what the filter blurs.
//
// Needs from its host what denoise_prepare.glsl does, of the same picture; by index of a pixel fetchNoise (of the last
// filterPixel) and fetchMass; and variance.glsl.

float varianceOfFiltered(ivec2 pixel) {
    int index = indexOf(pixel);
    float mass = max(massOfLight(fetchMass(index)), float(0.0));
    float before = preparePixel(pixel).noise.x;
    // The filter was told of less noise than there is.
    float left = sqrt(max(before, float(0.0))) * sqrt(max(fetchNoise(index).x, float(0.0))) / cautionOf(fetchMoments(index).y);
    return boundedVariance(left * mass * mass);
}
