// Denoising of a traced picture: a temporal mean along the motion, then an edge-avoiding a-trous filter
// (Dammertz et al. 2010) whose reach is set by variance (Schied et al. 2017, "Spatiotemporal variance-guided
// filtering"), with two differences. What is exchanged between two pixels is a flow, as much given as taken:
// so the filter keeps the sum of light and of coverage exactly, whatever its weights are. And what is
// compared and exchanged is the light per coverage and albedo of the deterministic guides, so that their
// detail stays. Flow from q to p with weight w, per channel:
//
//     w(p, q) min(D(p), D(q)) (L(q) / D(q) - L(p) / D(p)),   D = coverage * albedo, w symmetric, sum of w at
//     most 1.
//
// Alpha likewise, with D = coverage, and weights and variance of its own. Nothing flows to or from a pixel
// that the guides say is empty. The weights shrink with the variance, so the picture goes over into the plain
// mean.
//
// Four kernels: denoise_gather.glsl, denoise_prepare.glsl, denoise_filter.glsl once for each pass, and
// denoise_specks.glsl before and after them.
//
// Needs from its host: denoise (DenoisePush); and fovea.glsl.

// Light above this is taken as this, so that its square over the smallest mass squared is a number.
#define MOST_LIGHT 1e12
// A pixel with less coverage or albedo takes no part.
#define LEAST_MASS 1e-3
// The least mass of one colour of a pixel that takes part: avoids a division by 0 where that colour is not
// scattered.
#define LEAST_OF_CHANNEL 1e-6

int indexOf(ivec2 pixel) {
    return pixel.y * denoise.imageSize.x + pixel.x;
}

bool isInside(ivec2 pixel) {
    return pixel.x >= 0 && pixel.y >= 0 && pixel.x < denoise.imageSize.x && pixel.y < denoise.imageSize.y;
}

// Width at distance 1 of what a pixel shows.
float pixelAngleAt(ivec2 pixel) {
    if (!(denoise.foveaMagnification > float(1.0))) return denoise.pixelAngle;
    Fovea fovea = Fovea(denoise.planeHalfSize, denoise.gaze, denoise.foveaRadius, denoise.foveaMagnification);
    vec2 stored = vec2(float(2 * pixel.x + 1) / float(denoise.imageSize.x) - float(1.0),
                       float(1.0) - float(2 * pixel.y + 1) / float(denoise.imageSize.y));
    return denoise.pixelAngle * sqrt(seenArea(fovea, stored * denoise.planeHalfSize));
}

// Width of what a pixel shows so far from where its ray begins: of a parallel view it is the same everywhere.
float footprintMmAt(ivec2 pixel, float distanceMm) {
    return pixelAngleAt(pixel) * (denoise.parallelMm > float(0.0) ? denoise.parallelMm : distanceMm);
}

// Mass: coverage * albedo, and coverage.
float massOfLight(vec4 mass) {
    return luminance(vec3(mass.x, mass.y, mass.z));
}

// How much of alpha's noise there can be: all at a coverage of 1/2, none where the guides know that a sample
// always, or never, meets matter.
float chanceOf(float coverage) {
    return clamp(float(4.0) * coverage * (float(1.0) - coverage), float(0.0), float(1.0));
}

// Whether nothing flows to or from a pixel. Its loops over neighbours then have no round, which is what makes
// background cheap: on a CPU device a branch around a loop is not.
bool isEmpty(vec4 mass) {
    return massOfLight(mass) < float(LEAST_MASS) && chanceOf(mass.w) <= float(0.0);
}

// From that peak on light is doubted, and from this on wholly: normal noise has about 4, and a dot in the
// dark 25.
#define PEAK_OF_NOISE 7.0
#define PEAK_OF_DOT 15.0

// Inflates the sample variance of light: few samples underestimate it, as the brightest ones are rare, and
// the filter would keep each bright pixel apart as a white dot. The factor is 7 for one sample and 1.4 for
// eight, but where no pixel around stands out it is 1: light that differs from pixel to pixel by itself, as
// in thin tissue, is no noise. `peak` is the largest square of what a pixel is brighter than those around
// tell, over the mean of such squares. Pictures that models learn from go without it (DenoisePush::doubts):
// noise differs from picture to picture and averages out, blur does not.
float doubtOf(float samples, float peak) {
    float isDot =
        clamp((peak - float(PEAK_OF_NOISE)) / float(PEAK_OF_DOT - PEAK_OF_NOISE), float(0.0), float(1.0));
    return float(1.0) + float(denoise.doubts) * isDot * float(24.0) / (samples * samples + float(3.0));
}

// The filter takes the variance of a pixel with so many samples for less than it is, by this factor: the more
// samples there are, the less neighbours exchange, since bias has to fall faster than noise.
float cautionOf(float samples) {
    return float(1.0) / (float(1.0) + samples * float(1.0 / 32.0));
}
