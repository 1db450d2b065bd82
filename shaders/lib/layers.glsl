// The depths from which a pixel's light comes: eight layers along the centre ray, each of which takes an
// eighth of the ray's light. Found deterministically by the march of guides.glsl.
//
// Needs guides.glsl, with MARCH_STEP defined as layerStep before it.
#define LAYERS 8

float layerMm[LAYERS];  // along the current ray to the middle of each layer; negative if opacity does not
                        // rise so far

void passLayer(int layer, float depth, float before, float after, float fromMm, float perDepth) {
    if (before < depth && after >= depth) layerMm[layer] = fromMm + (depth - before) * perDepth;
}

// Optical depths -ln(1 - opacity) at opacities of 1/16, 3/16, ... 15/16.
void layerStep(float before, float after, float fromMm, float perDepth) {
    passLayer(0, float(0.06453852113757118), before, after, fromMm, perDepth);
    passLayer(1, float(0.20763936477824449), before, after, fromMm, perDepth);
    passLayer(2, float(0.37469344944141070), before, after, fromMm, perDepth);
    passLayer(3, float(0.57536414490356180), before, after, fromMm, perDepth);
    passLayer(4, float(0.82667857318446791), before, after, fromMm, perDepth);
    passLayer(5, float(1.1631508098056809), before, after, fromMm, perDepth);
    passLayer(6, float(1.6739764335716716), before, after, fromMm, perDepth);
    passLayer(7, float(2.7725887222397811), before, after, fromMm, perDepth);
}

struct LayeredRay {
    float coverage;  // as of a guide
    float meanMm;    // of the matter down to transmittance 1/2, for matter too thin for a layer; negative: no
                     // matter
};

// What is known of the ray after its march, which has filled layerMm.
LayeredRay layersOfMarch(INOUT(March) m, BrickWalk walk, float face) {
    if (face > float(0.0)) {
        endAtFace(m, walk.endMm, face * params.exposure);
        for (int i = 0; i < LAYERS; ++i) layerMm[i] = layerMm[i] < float(0.0) ? walk.endMm : layerMm[i];
    }
    LayeredRay ray;
    ray.coverage = float(1.0) - exp(-m.opticalDepth);
    ray.meanMm = m.seen > float(0.0) ? m.seenMm / m.seen : float(-1.0);
    return ray;
}

// Marches the ray through a point of the picture, in pixels; fills layerMm.
LayeredRay layersOf(vec2 pixel) {
    for (int i = 0; i < LAYERS; ++i) layerMm[i] = float(-1.0);
    float face;
    BrickWalk walk = startMarch(eyeRay(pixel), face);
    March m = march(walk);
    return layersOfMarch(m, walk, face);
}
