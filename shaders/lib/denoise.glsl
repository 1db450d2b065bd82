// Denoising of a traced picture: a temporal mean along the motion, then an edge-avoiding a-trous filter
// (Dammertz et al. 2010) whose reach is set by variance (Schied et al. 2017, "Spatiotemporal variance-guided
// filtering"), with two differences. Two pixels exchange a flow, which one gives and the other takes: so the
// filter keeps the sums of light and of coverage exactly, whatever its weights are. And pixels compare and
// exchange light divided by coverage and albedo of the noise-free guides, so that the detail of the guides
// stays. Flow from q to p with weight w, per channel:
//
//     w(p, q) min(D(p), D(q)) (L(q) / D(q) - L(p) / D(p)),   D = coverage * albedo, w symmetric, sum of w at
//     most 1.
//
// Alpha likewise, with D = coverage and its own weights and variance. Nothing flows to or from a pixel that
// is empty in the guides. The weights shrink with the variance, so that the picture approaches the plain
// mean.
//
// Four kernels: denoise_gather.glsl, denoise_prepare.glsl, denoise_filter.glsl once for each pass, and
// denoise_specks.glsl before and after them.
//
// Needs from its host: denoise (DenoisePush); and fovea.glsl.

// Light is clamped to this, so that its square over the smallest mass squared stays finite.
#define MOST_LIGHT 1e12
// A pixel with less mass takes no part.
#define LEAST_MASS 1e-3
// Lower limit of a colour's mass as a divisor: avoids a division by 0 where matter does not scatter that
// colour.
#define LEAST_OF_CHANNEL 1e-6

int indexOf(ivec2 pixel) {
    return pixel.y * denoise.imageSize.x + pixel.x;
}

bool isInside(ivec2 pixel) {
    return pixel.x >= 0 && pixel.y >= 0 && pixel.x < denoise.imageSize.x && pixel.y < denoise.imageSize.y;
}

// The width at distance 1 that a pixel shows.
float pixelAngleAt(ivec2 pixel) {
    if (!(denoise.foveaMagnification > float(1.0))) return denoise.pixelAngle;
    Fovea fovea = Fovea(denoise.planeHalfSize, denoise.gaze, denoise.foveaRadius, denoise.foveaMagnification);
    vec2 stored = vec2(float(2 * pixel.x + 1) / float(denoise.imageSize.x) - float(1.0),
                       float(1.0) - float(2 * pixel.y + 1) / float(denoise.imageSize.y));
    return denoise.pixelAngle * sqrt(seenArea(fovea, stored * denoise.planeHalfSize));
}

// The width of a pixel's footprint at a distance from the origin of its ray; constant in a parallel view.
float footprintMmAt(ivec2 pixel, float distanceMm) {
    return pixelAngleAt(pixel) * (denoise.parallelMm > float(0.0) ? denoise.parallelMm : distanceMm);
}

// `mass` has coverage * albedo, and coverage.
float massOfLight(vec4 mass) {
    return luminance(vec3(mass.x, mass.y, mass.z));
}

// How noisy alpha can be, 0 to 1: most at a coverage of 1/2, not at all where the guides know that samples
// always, or never, meet matter.
float chanceOf(float coverage) {
    return clamp(float(4.0) * coverage * (float(1.0) - coverage), float(0.0), float(1.0));
}

// Whether nothing flows to or from a pixel. Its loops over neighbours then have no rounds, which makes the
// background cheap: on a CPU device a branch around a loop would not.
bool isEmpty(vec4 mass) {
    return massOfLight(mass) < float(LEAST_MASS) && chanceOf(mass.w) <= float(0.0);
}

// The peaks (see doubtOf) at which doubt begins and is complete: normal noise has about 4, a single dot in
// the dark 25.
#define PEAK_OF_NOISE 7.0
#define PEAK_OF_DOT 15.0

// The factor that inflates the sample variance of light. Few samples underestimate it, because very bright
// samples are rare, and the filter would then leave each bright pixel as a white dot. The factor is 7 for one
// sample and 1.4 for eight, but 1 where no pixel around stands out: light that truly varies from pixel to
// pixel, as in thin tissue, is not noise. `peak` is the largest square of a pixel's excess over the light
// that its surroundings predict, divided by the mean of such squares. Training views are not inflated
// (DenoisePush::doubts): noise differs from picture to picture and averages out, blur does not.
float doubtOf(float samples, float peak) {
    float isDot =
        clamp((peak - float(PEAK_OF_NOISE)) / float(PEAK_OF_DOT - PEAK_OF_NOISE), float(0.0), float(1.0));
    return float(1.0) + float(denoise.doubts) * isDot * float(24.0) / (samples * samples + float(3.0));
}

// The factor by which the filter lowers a pixel's variance: the more samples, the less neighbours exchange,
// because bias must fall faster than noise.
float cautionOf(float samples) {
    return float(1.0) / (float(1.0) + samples * float(1.0 / 32.0));
}
