// Second step of denoising: the masses by which light and alpha are divided (demodulation), and how noisy
// both are.
//
// Needs from its host, by index of a pixel: fetchMean and fetchMoments (of gatherPixel), fetchSurface,
// fetchMatter, fetchMotion.

// From so many samples on, a pixel's own variance counts more than its neighbours'.
#define SAMPLES_TRUSTED 16.0

struct Prepared {
    vec4 mass;   // coverage * albedo, coverage: the divisors of light and alpha
    vec4 noise;  // variances of luminance per mass, and of alpha; slope of depth in mm per pixel; spread of
                 // depth
    float told;  // factor by which the variance of luminance was multiplied for the filter
};

// The mean mass over the area of a pixel, from a linear interpolation between pixel centres.
vec4 massAround(ivec2 pixel) {
    vec4 sum = vec4(0.0);
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            ivec2 at = clamp(pixel + ivec2(x, y), ivec2(0), denoise.imageSize - ivec2(1));
            vec4 matter = fetchMatter(indexOf(at));
            float weight = (x == 0 ? float(0.75) : float(0.125)) * (y == 0 ? float(0.75) : float(0.125));
            sum += vec4(matter.x * matter.w, matter.y * matter.w, matter.z * matter.w, matter.w) * weight;
        }
    }
    return sum;
}

// The smaller of the differences in depth to the two neighbours along `side`: at an edge, the one along the
// surface.
float slopeAlong(ivec2 pixel, float depth, ivec2 side) {
    ivec2 last = denoise.imageSize - ivec2(1);
    float before = fetchSurface(indexOf(clamp(pixel - side, ivec2(0), last))).w;
    float after = fetchSurface(indexOf(clamp(pixel + side, ivec2(0), last))).w;
    float none = float(1e30);
    bool hasBefore = before >= float(0.0) && isInside(pixel - side);
    bool hasAfter = after >= float(0.0) && isInside(pixel + side);
    float slope = min(hasBefore ? abs(depth - before) : none, hasAfter ? abs(after - depth) : none);
    return slope < none ? slope : float(0.0);
}

// The variance of the mean, estimated from the samples of this pixel and of those around; with fewer than two
// samples, from the differences between these pixels.
Prepared preparePixel(ivec2 pixel) {
    int index = indexOf(pixel);
    vec2 moments = fetchMoments(index);
    vec4 surface = fetchSurface(index);
    float confidence = fetchMotion(index).z;
    Prepared prepared;
    prepared.mass = massAround(pixel);

    float light = float(0.0);
    float mass = float(0.0);
    float masses = float(0.0);
    float lights = float(0.0);
    float cross = float(0.0);
    float variances = float(0.0);
    float variance = float(0.0);
    float lightAt[25];
    float massAt[25];
    int taps = isEmpty(prepared.mass) ? 0 : 25;
    for (int tap = 0; tap < taps; ++tap) {
        int y = tap / 5;
        int x = tap - 5 * y;
        ivec2 at = clamp(pixel + ivec2(x - 2, y - 2), ivec2(0), denoise.imageSize - ivec2(1));
        int q = indexOf(at);
        vec4 meanQ = fetchMean(q);
        vec2 momentsQ = fetchMoments(q);
        vec4 matterQ = fetchMatter(q);
        float l = luminance(vec3(meanQ.x, meanQ.y, meanQ.z));
        float d = luminance(vec3(matterQ.x, matterQ.y, matterQ.z)) * matterQ.w;
        // The variance of samples, clamped because rounding can make the mean of squares smaller than the
        // square of the mean.
        float own = max(momentsQ.x - l * l, float(0.0)) / max(momentsQ.y - float(1.0), float(1.0));
        lightAt[tap] = l;
        massAt[tap] = d;
        light += l;
        mass += d;
        masses += d * d;
        lights += l * l;
        cross += l * d;
        variances += own;
        variance = tap == 12 ? own : variance;
    }
    float perMass = float(1.0) / max(masses, float(25.0 * LEAST_MASS * LEAST_MASS));
    float level = light / max(mass, float(25.0 * LEAST_MASS));
    float between = max(lights - float(2.0) * level * cross + level * level * masses, float(0.0)) * perMass;
    float most = float(0.0);
    float squares = float(0.0);
    for (int tap = 0; tap < taps; ++tap) {
        float brighter = lightAt[tap] - level * massAt[tap];
        most = max(most, brighter);
        squares += brighter * brighter;
    }
    float peak = float(25.0) * most * most / max(squares, float(1e-30));
    float pooled = moments.y > float(1.5) ? variances * perMass : between;
    float d = max(massOfLight(prepared.mass), float(LEAST_MASS));
    float known = max(moments.y - float(1.0), float(0.0));
    float light2 =
        (float(SAMPLES_TRUSTED) * pooled + known * variance / (d * d)) / (float(SAMPLES_TRUSTED) + known);

    // Whether a sample meets matter is random, with a probability that the guides know.
    float coverage = prepared.mass.w;
    float alpha2 = max(coverage * (float(1.0) - coverage), float(0.002)) / max(moments.y, float(1.0));

    float caution = cautionOf(moments.y);
    prepared.told = caution * doubtOf(moments.y, peak);
    light2 *= prepared.told;
    alpha2 *= caution;

    float slope = float(0.0);
    float spread = float(0.0);
    if (surface.w >= float(0.0)) {
        float footprintMm = footprintMmAt(pixel, surface.w);
        slope = max(slopeAlong(pixel, surface.w, ivec2(1, 0)), slopeAlong(pixel, surface.w, ivec2(0, 1)));
        slope = max(slope, float(0.5) * footprintMm);
        spread = float(4.0) * footprintMm * (float(1.0) / max(confidence, float(0.02)) - float(1.0));
    }
    prepared.noise = vec4(light2, alpha2, slope, spread);
    return prepared;
}
