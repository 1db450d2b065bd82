// How noisy a picture is as displayed: the standard error of each pixel's mean in display-encoded values.
//
// Needs picture.glsl, and from its host: fetchSums, fetchCount and fetchSquares, by index of a pixel.

// Upper limit of a variance; also used for one that is not finite.
#define MOST_VARIANCE 1e12
// From so many samples on, a pixel's own variance counts more than its block's.
#define SAMPLES_OF_ITS_OWN 16.0

struct PixelNoise {
    float light;     // exposed luminance of the mean
    float variance;  // of one sample
    float samples;
};

// Noise of coverage counts too, because the background shows through: `backdrop` is its expected luminance.
// In light paths coverage is 0 or 1 in each sample, and so its own square.
PixelNoise pixelNoise(vec4 sum, uint count, float squares, float exposure, float backdrop) {
    PixelNoise noise;
    noise.samples = float(count);
    float share = float(1.0) / max(noise.samples, float(1.0));
    float light = luminance(vec3(sum.x, sum.y, sum.z)) * share;
    float coverage = clamp(sum.w * share, float(0.0), float(1.0));
    float ofLight = max(squares * share - light * light, float(0.0)) * exposure * exposure;
    float ofCoverage = coverage * (float(1.0) - coverage) * backdrop * backdrop;
    float variance = (ofLight + ofCoverage) * noise.samples / max(noise.samples - float(1.0), float(1.0));
    noise.variance = isFinite(vec4(variance)) ? min(variance, float(MOST_VARIANCE)) : float(MOST_VARIANCE);
    noise.light =
        isFinite(vec4(light * exposure)) ? min(max(light * exposure, float(0.0)), float(1e6)) : float(1e6);
    return noise;
}

float shownGrey(float light, bool keepsHue) {
    vec3 mapped = toneMapNeutral(vec3(light));
    return encodeSrgb(keepsHue ? greyOfToneMapHue(light) : mapped.x);
}

// The standard error as displayed: half the difference between light one standard error above and below. The
// slope of the tone curve alone would not do for noise as large as the light.
float shownError(float light, float standardError, bool keepsHue) {
    return float(0.5) * (shownGrey(light + standardError, keepsHue) -
                         shownGrey(max(light - standardError, float(0.0)), keepsHue));
}

// The mean square error of a block's pixels, and 1 if some sample met matter or light. With few samples a
// pixel may have missed the bright ones, so that its variance is pooled with its block's. With fewer than two
// samples a pixel's error counts as 1.
vec2 noiseOfBlock(ivec2 block, ivec2 imageSize, float exposure, float backdrop, bool keepsHue) {
    float pixels = float(0.0);
    float pooled = float(0.0);
    float seen = float(0.0);
    for (int i = 0; i < 64; ++i) {
        ivec2 pixel = block * 8 + ivec2(i & 7, i >> 3);
        ivec2 inside = clamp(pixel, ivec2(0), imageSize - ivec2(1));
        float weight = pixel.x == inside.x && pixel.y == inside.y ? float(1.0) : float(0.0);
        int index = inside.y * imageSize.x + inside.x;
        vec4 sum = fetchSums(index);
        PixelNoise noise = pixelNoise(sum, fetchCount(index), fetchSquares(index), exposure, backdrop);
        pixels += weight;
        pooled += weight * noise.variance;
        seen =
            max(seen, sum.x != float(0.0) || sum.y != float(0.0) || sum.z != float(0.0) || sum.w != float(0.0)
                          ? weight
                          : float(0.0));
    }
    pooled /= max(pixels, float(1.0));
    float squares = float(0.0);
    for (int i = 0; i < 64; ++i) {
        ivec2 pixel = block * 8 + ivec2(i & 7, i >> 3);
        ivec2 inside = clamp(pixel, ivec2(0), imageSize - ivec2(1));
        float weight = pixel.x == inside.x && pixel.y == inside.y ? float(1.0) : float(0.0);
        int index = inside.y * imageSize.x + inside.x;
        PixelNoise noise =
            pixelNoise(fetchSums(index), fetchCount(index), fetchSquares(index), exposure, backdrop);
        float more = max(noise.samples - float(1.0), float(0.0));
        float variance =
            (float(SAMPLES_OF_ITS_OWN) * pooled + more * noise.variance) / (float(SAMPLES_OF_ITS_OWN) + more);
        float error = noise.samples < float(1.5)
                          ? float(1.0)
                          : shownError(noise.light, sqrt(variance / noise.samples), keepsHue);
        squares += weight * error * error;
    }
    return vec2(squares / max(pixels, float(1.0)), seen);
}
