// Deterministic guides of a pixel, by a march along its centre ray (brick_walk.glsl): depth, coverage, colour
// of the first visible matter, surface normal, and motion from the previous view. Depths from random paths
// would have centimetres of noise in translucent matter.
//
// Needs what path.glsl needs.

// Optical depths at which transmittance is 3/4, 1/2 and 1/4, and at which a march ends: an opacity of 255/256
// hides everything behind.
#define DEPTH_3_4 0.28768207245178085
#define DEPTH_1_2 0.69314718055994531
#define DEPTH_1_4 1.3862943611198906
#define DEPTH_OPAQUE 5.5451774444795625

struct Guide {
    float depthMm;     // along the ray to transmittance 1/2; negative when it does not fall so far
    float confidence;  // of depthMm, 0 to 1: see guideAlong
    float coverage;    // 1 - transmittance of the whole ray; above 255/256 the march ends
    vec3 albedo;       // mean over the matter down to transmittance 1/2, weighted by added opacity; 0 if none
    vec3 normal;       // world, unit, towards the eye: of the isosurface at depthMm; 0 where there is none
    vec2 motion;     // pixels: position in the previous view minus position now; 0 if it was behind that eye
    float beforeMm;  // its distance from the previous eye; negative if there is no matter or it was behind
};

// Another eye: the position of ours relative to it in world mm, and its picture's axes as in TraceParams.
struct Eye {
    vec3 oursMm;
    vec3 right;
    vec3 up;
    vec3 forward;
    Fovea fovea;
    float parallelMm;
};

// The inverse of eyeRay for any eye: the pixel position of a point at `v` from the eye (world mm) in its
// picture. False when the point is behind the eye; then `pixel` is 0.
bool pixelOfDirection(vec3 v, Eye eye, OUT(vec2) pixel) {
    pixel = vec2(0.0);
    float along = dot(v, eye.forward);
    if (!(along >= float(0.0))) return false;
    if (eye.parallelMm > float(0.0))
        along = eye.parallelMm;
    else if (!(along * along > float(1e-8) * dot(v, v)))
        return false;
    float x = dot(v, eye.right) / (along * dot(eye.right, eye.right));
    float y = dot(v, eye.up) / (along * dot(eye.up, eye.up));
    if (eye.fovea.magnification > float(1.0)) {
        vec2 stored = storedFromSeen(eye.fovea, vec2(x, y) * eye.fovea.halfSize) / eye.fovea.halfSize;
        x = stored.x;
        y = stored.y;
    }
    pixel = vec2((float(0.5) + float(0.5) * x) * float(params.imageSize.x),
                 (float(0.5) - float(0.5) * y) * float(params.imageSize.y));
    return true;
}

struct March {
    float opticalDepth;
    float nearMm;  // where transmittance is 3/4, 1/2, 1/4; negative when it does not fall so far
    float halfMm;
    float farMm;
    float endMm;   // where the last matter ends
    float seen;    // opacity accumulated down to transmittance 1/2
    float seenMm;  // sums of distance and albedo, weighted by opacity
    vec3 albedo;
};

// A hook that every step calls, for results that March does not hold (layers.glsl).
#ifndef MARCH_STEP
#define MARCH_STEP(before, after, fromMm, perDepth)
#endif

// Visitor: marches in steps of a voxel, or of a quarter voxel where a full step's optical depth exceeds FINE;
// extinction counts as constant over a step.
#define FINE 0.1
// The most rounds of a march: lavapipe ends every loop there; a visible volume takes some thousands. It also
// ends marches from kilometres away, where float cannot represent such small steps.
#define MOST_ROUNDS 65535
March march(INOUT(BrickWalk) walk) {
    March m = March(float(0.0), float(-1.0), float(-1.0), float(-1.0), float(0.0), float(0.0), float(0.0),
                    vec3(0.0));
    vec3 perMm = max(walk.direction, -walk.direction);
    float coarseMm = float(1.0) / (float(BRICK) * max(max(perMm.x, perMm.y), perMm.z));
    float fineMm = float(0.25) * coarseMm;
    float tinyMm = float(1e-3) * coarseMm;  // a shorter rest of a brick is rounding
    float stepMm = coarseMm;
    float fineToMm = float(-1.0);
    float runToMm = float(-1.0);  // end of the current run of adjacent bricks with matter
    float lastMm = float(0.0);    // length of the previous step, if this one begins at its end
    float lastAdded = float(0.0);
    int rounds = 0;
    bool inside = nextSegment(walk, rounds);
    while (inside && m.opticalDepth < float(DEPTH_OPAQUE) && rounds < MOST_ROUNDS) {
        float fromMm = walk.distanceMm;
        bool anew = fromMm > runToMm + tinyMm;
        lastMm = anew ? float(0.0) : lastMm;
        lastAdded = anew ? float(0.0) : lastAdded;
        runToMm = walk.segmentEndMm;
        fineToMm = anew ? fromMm + float(0.5) * coarseMm : fineToMm;
        stepMm = anew ? fineMm : stepMm;
        while (fromMm + tinyMm < walk.segmentEndMm && m.opticalDepth < float(DEPTH_OPAQUE) &&
               rounds < MOST_ROUNDS) {
            rounds += 1;
            float step = min(stepMm, walk.segmentEndMm - fromMm);
            float middleMm = fromMm + float(0.5) * step;
            vec3 at = walkPositionAt(walk, middleMm);
            float entry = expectedEntry(at);
            float steep = steepAt(at, entry);
            Mixture matter = mixtureAt(at, entry, steep);
            float extinction = totalOf(matter);
            if (isMasked(at)) extinction = float(0.0);
            if (useClip())
                extinction =
                    endOfCut(walk.cutFrom, walk.cutTo, middleMm) < float(0.0) ? extinction : float(0.0);
            float added = extinction * step;
            bool again = added > float(FINE) && step > fineMm;
            // Where a coarse step meets much matter, repeats it in fine steps from half of the previous step
            // on, where that matter may have begun. Means count that half twice; it is little, or that step
            // would have been fine.
            float before = again ? m.opticalDepth - float(0.5) * lastAdded : m.opticalDepth;
            float after = again ? before : before + added;
            float perDepth = float(1.0) / max(extinction, float(1e-20));
            if (before < float(DEPTH_3_4) && after >= float(DEPTH_3_4))
                m.nearMm = fromMm + (float(DEPTH_3_4) - before) * perDepth;
            if (before < float(DEPTH_1_2) && after >= float(DEPTH_1_2))
                m.halfMm = fromMm + (float(DEPTH_1_2) - before) * perDepth;
            if (before < float(DEPTH_1_4) && after >= float(DEPTH_1_4))
                m.farMm = fromMm + (float(DEPTH_1_4) - before) * perDepth;
            MARCH_STEP(before, after, fromMm, perDepth);
            float seen = max(exp(-before) - exp(-min(after, float(DEPTH_1_2))), float(0.0));
            m.seen += seen;
            m.seenMm += seen * middleMm;
            for (bool asks = useSteep() && seen > float(0.0) && !isSteepDenser(entry); asks; asks = false)
                steep = steepOfAll(at);
            m.albedo += albedoAt(at, entry, steep, secondShareOf(matter)) * seen;
            m.endMm = after > before ? fromMm + step : m.endMm;
            m.opticalDepth = after;
            fineToMm = again ? fromMm + step : fineToMm;
            fromMm = again ? fromMm - float(0.5) * lastMm : fromMm + step;
            lastMm = again ? float(0.0) : step;
            lastAdded = again ? float(0.0) : added;
            stepMm = fromMm + tinyMm < fineToMm || added > float(0.25 * FINE) ? fineMm : coarseMm;
        }
        inside = nextSegment(walk, rounds);
    }
    return m;
}

// Starts the march of a ray from the eye; `face` is that of stopAtFace().
BrickWalk startMarch(EyeRay eye, OUT(float) face) {
    vec3 directionVoxel = voxelsPerMm(eye.direction);
    BrickWalk walk = startEyeWalk(eye.originVoxel, directionVoxel);
    face = float(0.0);
    if (useClip() && params.greyFaces != 0) face = stopAtFace(walk, eye.originVoxel, directionVoxel);
    return walk;
}

// Adds a grey clip face behind the marched matter: opaque, with its grey as albedo.
void endAtFace(INOUT(March) m, float faceMm, float grey) {
    float seen = max(exp(-m.opticalDepth) - float(0.5), float(0.0));
    m.seen += seen;
    m.seenMm += seen * faceMm;
    m.albedo += vec3(grey) * seen;
    m.nearMm = m.nearMm >= float(0.0) ? m.nearMm : faceMm;
    m.halfMm = m.halfMm >= float(0.0) ? m.halfMm : faceMm;
    m.farMm = m.farMm >= float(0.0) ? m.farMm : faceMm;
    m.endMm = faceMm;
    m.opticalDepth = max(m.opticalDepth, float(100.0));
}

// Unit normal of the isosurface, towards the eye; 0 where all values around are equal.
vec3 surfaceNormal(vec3 at, vec3 worldDirection) {
    vec3 x = vec3(float(1.0), float(0.0), float(0.0));
    vec3 y = vec3(float(0.0), float(1.0), float(0.0));
    vec3 z = vec3(float(0.0), float(0.0), float(1.0));
    vec3 gradient =
        vec3(expectedEntry(at + x) - expectedEntry(at - x), expectedEntry(at + y) - expectedEntry(at - y),
             expectedEntry(at + z) - expectedEntry(at - z));
    // A difference below a twentieth of a stored value over two voxels is rounding of large values, no
    // surface.
    if (!(dot(gradient, gradient) > float(0.0025))) return vec3(0.0);
    // A gradient in voxels becomes one in mm by the transpose of the map from mm to voxels.
    vec3 world = vec3(dot(params.voxelFromWorldX, gradient), dot(params.voxelFromWorldY, gradient),
                      dot(params.voxelFromWorldZ, gradient));
    return normalize(dot(world, worldDirection) > float(0.0) ? -world : world);
}

// The same for the volume, first or second, with more of the extinction at the point.
vec3 normalAt(vec3 at, vec3 worldDirection) {
    if (!useSecond()) return surfaceNormal(at, worldDirection);
    float entry = expectedEntry(at);
    float steep = steepAt(at, entry);
    if (secondShareOf(mixtureAt(at, entry, steep)) <= float(0.5)) return surfaceNormal(at, worldDirection);
    vec3 world = secondGradient(at);
    if (!(dot(world, world) > float(0.0))) return vec3(0.0);
    return normalize(dot(world, worldDirection) > float(0.0) ? -world : world);
}

// The offset between two rays at a distance from their origins, world mm.
vec3 betweenRays(EyeRay to, EyeRay from, float distanceMm) {
    return (to.asideMm - from.asideMm) + (to.direction - from.direction) * distanceMm;
}

// The guide of a pixel whose centre is at `pixel`, by the march of one of its rays.
//
// Confidence says how well one depth stands for all visible matter: f / (f + s), where s is the length over
// which transmittance falls from 3/4 to 1/4 and f the width of four pixels there. It fades to 0 as coverage
// falls from 3/4 to 1/2, below which there is no depth.
Guide guideOfMarch(March m, EyeRay eye, vec2 pixel, Eye before) {
    vec3 direction = eye.direction;
    Guide guide;
    guide.depthMm = m.halfMm;
    guide.coverage = float(1.0) - exp(-m.opticalDepth);
    guide.albedo = m.albedo / max(m.seen, float(1e-20));
    guide.confidence = float(0.0);
    guide.normal = vec3(0.0);
    if (m.halfMm >= float(0.0)) {
        EyeRay middle = eyeRay(pixel);
        vec3 aside = betweenRays(eyeRay(pixel + vec2(float(1.0), float(0.0))), middle, m.halfMm);
        vec3 below = betweenRays(eyeRay(pixel + vec2(float(0.0), float(1.0))), middle, m.halfMm);
        float footprintMm = sqrt(max(dot(aside, aside), dot(below, below)));
        float spreadMm = (m.farMm >= float(0.0) ? m.farMm : m.endMm) - m.nearMm;
        guide.confidence =
            float(4.0) * footprintMm / (float(4.0) * footprintMm + max(spreadMm, float(1e-20)));
        guide.confidence *= clamp(float(4.0) * guide.coverage - float(2.0), float(0.0), float(1.0));
        guide.normal = normalAt(eye.originVoxel + voxelsPerMm(direction) * m.halfMm, direction);
    }
    // Matter too thin for a depth moves like its opacity-weighted mean position.
    vec3 fromBefore = before.oursMm + eye.asideMm +
                      direction * (m.halfMm >= float(0.0) ? m.halfMm : m.seenMm / max(m.seen, float(1e-20)));
    vec2 pixelBefore;
    guide.motion = vec2(0.0);
    guide.beforeMm = float(-1.0);
    if (m.seen > float(0.0) && pixelOfDirection(fromBefore, before, pixelBefore)) {
        guide.motion = pixelBefore - pixel;
        guide.beforeMm = before.parallelMm > float(0.0) ? dot(fromBefore, before.forward)
                                                        : sqrt(dot(fromBefore, fromBefore));
    }
    return guide;
}

Guide guideAlong(EyeRay eye, vec2 pixel, Eye before) {
    float face;
    BrickWalk walk = startMarch(eye, face);
    March m = march(walk);
    if (face > float(0.0)) endAtFace(m, walk.endMm, face * params.exposure);
    return guideOfMarch(m, eye, pixel, before);
}

// Rays of a pixel through a lens: few, because each is a march, but enough that after the filter a blurred
// edge does not look like a row of edges.
#define LENS_RAYS 16

// Points that divide a disc of radius 1 into equal areas, each turned by the golden angle from the last
// (Vogel 1979, "A better way to construct the sunflower head").
vec2 spiralPoint(int i) {
    float angle = float(2.39996322972865332) * float(i);
    return vec2(cos(angle), sin(angle)) * sqrt((float(i) + float(0.5)) * float(1.0 / LENS_RAYS));
}

// The guide of a point of the picture, in pixels: from its one ray, or with a lens the mean of its rays, so
// that guides are as blurred as the picture that they filter. The albedo is weighted by coverage, as light
// is.
Guide guideOf(vec2 pixel, Eye before) {
    EyeRay eye = eyeRay(pixel);
    bool blurs = params.lensRadiusMm > float(0.0);
    int rays = blurs ? LENS_RAYS : 1;
    Guide mean;
    mean.depthMm = float(0.0);
    mean.confidence = float(0.0);
    mean.coverage = float(0.0);
    mean.albedo = vec3(0.0);
    mean.normal = vec3(0.0);
    mean.motion = vec2(0.0);
    mean.beforeMm = float(0.0);
    float shares = float(0.0);
    float depths = float(0.0);
    float befores = float(0.0);
    for (int i = 0; i < rays; ++i) {
        EyeRay ray = eye;
        if (blurs) ray = throughLens(eye, spiralPoint(i));
        Guide guide = guideAlong(ray, pixel, before);
        float share = blurs ? guide.coverage : float(1.0);
        mean.albedo += guide.albedo * share;
        shares += share;
        depths += guide.depthMm >= float(0.0) ? float(1.0) : float(0.0);
        mean.depthMm += max(guide.depthMm, float(0.0));
        befores += guide.beforeMm >= float(0.0) ? float(1.0) : float(0.0);
        mean.beforeMm += max(guide.beforeMm, float(0.0));
        mean.confidence += guide.confidence;
        mean.coverage += guide.coverage;
        mean.normal += guide.normal;
        mean.motion += guide.motion;
    }
    float each = float(1.0) / float(rays);
    mean.albedo /= max(shares, float(1e-20));
    mean.depthMm = float(2.0) * depths >= float(rays) ? mean.depthMm / depths : float(-1.0);
    mean.beforeMm = befores > float(0.0) ? mean.beforeMm / befores : float(-1.0);
    mean.confidence *= each;
    mean.coverage *= each;
    mean.normal *= each;
    mean.motion *= each;
    return mean;
}
