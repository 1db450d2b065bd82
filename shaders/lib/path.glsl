// Light paths from the eye: free flights, and at every vertex next-event estimation to the environment. The
// background is not part of the result: a path that leaves the volume adds nothing, because the environment's
// light was added at its vertices; only after a vertex with a surface does it add a share of that light
// (lightAhead).
//
// Needs, besides mixture, walk, phase, environment, scattering and material: useSurfaces(), a constant;
// fetchAlbedo(entry), params.voxelFromWorld*, params.worldFrom*, params.bounces, params.anisotropy,
// params.lightStrength.

vec3 voxelsPerMm(vec3 worldDirection) {
    return params.voxelFromWorldX * worldDirection.x + params.voxelFromWorldY * worldDirection.y +
           params.voxelFromWorldZ * worldDirection.z;
}

// The distance in mm in which a ray crosses one voxel; `directionVoxel` is in voxels per mm.
float voxelMm(vec3 directionVoxel) {
    return float(1.0) / length(directionVoxel);
}

vec3 worldFromEnvironment(vec3 direction) {
    return params.worldFromEnvironmentX * direction.x + params.worldFromEnvironmentY * direction.y +
           params.worldFromEnvironmentZ * direction.z;
}

vec3 environmentFromWorld(vec3 direction) {
    return vec3(dot(params.worldFromEnvironmentX, direction), dot(params.worldFromEnvironmentY, direction),
                dot(params.worldFromEnvironmentZ, direction));
}

// Russian roulette: below this a ray or path continues only with a proportional probability, and its weight
// is raised to compensate.
#define ROULETTE_BELOW 0.1
#define BLACK_FACE 1e-4  // grey that displays as black, but differs from 0, which means no face

// A shadow ray begins with majorants larger by this factor. With tight ones, ratio tracking in dense matter
// ends at the first collision: transmittance is all or nothing. With looser ones it varies less
// (docs/speed-and-accuracy.md, "What a sample is worth").
#define SHADOW_LOOSENESS 4.0

// Matter at its majorant may exceed it by rounding.
#define ROUNDED_BOUND 1.001

// A path under way. It is a chain of rays: flights to the next collision, and after each a shadow ray to the
// light. The same few lines follow both kinds, a stride at a time, so that the lanes of a GPU stay together
// while one traces a flight, its neighbour a shadow ray, and a third has started its next sample.
struct Path {
    BrickWalk walk;       // the current ray
    vec3 origin;          // of the current ray, voxel coordinates
    vec3 direction;       // of the last flight, world, unit
    vec3 throughput;      // of the path so far
    vec3 pending;         // light of the shadow ray if nothing blocked it
    vec3 radiance;        // gathered so far, premultiplied: 0 if the path met nothing
    float coverage;       // 1 if the eye ray met matter or a grey face
    float transmittance;  // of the shadow ray so far; 0 after a flight with a collision
    float entry;          // the value at the flight's last tentative collision
    float steep;        // steep part of the matter there, if its extinction depends on it, see gradient.glsl
    float secondShare;  // of the second volume there, see mixture.glsl
    int vertices;
    int rounds;      // of all loops so far, which a device may limit
    int aboveBound;  // collisions in matter denser than its majorant: a bug, light leaks there
    bool shadow;     // the current ray is a shadow ray
    Net net;  // points of its choices: 2k + 1 for the light at vertex k, 2k for the direction to that vertex;
              // 0 only for paths of surface.glsl
    vec3 next;      // with surfaces: the direction after the current vertex
    float nextPdf;  // pdf per steradian of `next`; 0: the vertex has counted all its light already
    float face;     // light of the grey clip face behind the eye ray's matter; 0 if there is none
    // For the cache of indirect light. Once a path has continued from its first vertex, radiance and
    // throughput above count indirect light only.
    uvec4 cells;       // of the first vertex, once the path has continued from it; y 0: it has not
    vec3 direct;       // light of the first vertex that is not indirect
    float extinction;  // per mm, at the first vertex
    vec3 albedo;       // factor of indirect light at the first vertex
    float chance;  // random, 0 to 1, shared with neighbours: the path continues from its first vertex if it
                   // is low
};

// A ray from the eye meets only matter that the clip leaves.
BrickWalk startEyeWalk(vec3 originVoxel, vec3 directionVoxel) {
    return startWalk(originVoxel, directionVoxel, clipSpans(originVoxel, directionVoxel));
}

// A ray of light meets the same matter as the eye, or the whole volume when removed matter casts shadow.
BrickWalk startLightWalk(vec3 originVoxel, vec3 directionVoxel) {
    if (useClip() && params.clipShadows == 0) return startEyeWalk(originVoxel, directionVoxel);
    return startWalk(originVoxel, directionVoxel, nothingClipped());
}

// Ends the walk at the first clip face that shows a grey, and returns the linear light that the tone map will
// turn into that grey. At or below the window's low end a face is clear, so that air hides nothing, or black
// when greyFaces is 2.
float stopAtFace(INOUT(BrickWalk) walk, vec3 originVoxel, vec3 directionVoxel) {
    ClipSpans spans = clipSpans(originVoxel, directionVoxel);
    float face = max(walk.distanceMm, float(0.0));
    float slack = float(1e-3) * voxelMm(directionVoxel) +
                  float(1e-6) * face;  // from far away a float cannot represent a thousandth of a voxel
    bool first =
        spans.from >= walk.distanceMm - slack;  // otherwise the ray enters through the volume's own side
    float grey = float(0.0);
    for (int i = 0; i < 4 && grey <= float(0.0); ++i) {
        face = nextFace(spans, first && i == 0 ? face - slack : face);
        if (face >= walk.endMm) break;
        vec3 at = originVoxel + directionVoxel * face;
        if (!isMasked(at))
            grey = clamp((trilinearEntry(at) - params.greyLow) / (params.greyHigh - params.greyLow),
                         float(0.0), float(1.0));
        if (!isMasked(at) && params.greyFaces == 2) grey = max(grey, float(BLACK_FACE));
    }
    if (grey <= float(0.0)) return float(0.0);
    walk.endMm = face;
    return greyBeforeToneMap(grey, params.keepsHue == 1) / params.exposure;
}

Path startPath(vec3 originVoxel, vec3 worldDirection, Net net) {
    Path path;
    path.net = net;
    vec3 directionVoxel = voxelsPerMm(worldDirection);
    path.walk = startEyeWalk(originVoxel, directionVoxel);
    path.face = float(0.0);
    if (useClip() && params.greyFaces != 0) path.face = stopAtFace(path.walk, originVoxel, directionVoxel);
    path.origin = originVoxel;
    path.direction = worldDirection;
    path.throughput = vec3(1.0);
    path.pending = vec3(0.0);
    path.radiance = vec3(0.0);
    path.coverage = float(0.0);
    path.transmittance = float(1.0);
    path.entry = float(0.0);
    path.steep = float(0.0);
    path.secondShare = float(0.0);
    path.vertices = 0;
    path.rounds = 0;
    path.aboveBound = 0;
    path.shadow = false;
    path.next = vec3(0.0);
    path.nextPdf = float(0.0);
    path.cells = uvec4(0u);
    path.direct = vec3(0.0);
    path.extinction = float(0.0);
    path.albedo = vec3(1.0);
    path.chance = float(0.0);
    return path;
}

// Makes the ray that is about to start a shadow ray.
void beShadow(INOUT(Path) path) {
    path.shadow = true;
    path.walk.looseness = float(SHADOW_LOOSENESS);
}

// Tentative collisions in one call of follow(): enough to amortise the cost of a decision for the other
// lanes, few enough that lanes do not wait long for each other.
#define STRIDE 16

// Whether a ray after so many vertices meets all matter, also what the mask hides.
bool seesAll(bool isShadow, int vertices) {
    return params.clipShadows != 0 && (isShadow || vertices > 0);
}

// Whether the tentative collision, at which the walk stands, ends the current ray. A flight ends at its first
// real collision (Woodcock tracking); a shadow ray estimates its transmittance without bias (ratio tracking,
// with roulette).
bool collide(INOUT(Path) path, INOUT(Rng) rng) {
    vec3 at = walkPosition(path.walk);
    path.entry = entryAt(at, rng);
    path.steep = steepByChance(at, path.entry, rng);
    Mixture matter = mixtureAt(at, path.entry, path.steep);
    path.secondShare = secondShareOf(matter);
    float real = totalOf(matter) / path.walk.majorant;
    if (useMask() && !seesAll(path.shadow, path.vertices) && isMasked(at)) real = float(0.0);
    path.aboveBound += real > float(ROUNDED_BOUND) ? 1 : 0;
    real = min(real, float(1.0));
    float chance = random01(rng);
    if (path.shadow) {
        path.transmittance *= float(1.0) - real;
        if (path.transmittance < float(ROULETTE_BELOW)) {
            path.transmittance =
                chance * float(ROULETTE_BELOW) < path.transmittance ? float(ROULETTE_BELOW) : float(0.0);
        }
    } else {
        path.transmittance = chance < real ? float(0.0) : float(1.0);
    }
    return path.transmittance == float(0.0);
}

// Visitor: follows the current ray for a stride. True when the ray has ended.
bool follow(INOUT(Path) path, INOUT(Rng) rng) {
    path.rounds += 1;
    for (int i = 0; i < STRIDE; ++i) {
        path.rounds += 1;
        if (!nextTentative(path.walk, rng, path.rounds) || collide(path, rng)) return true;
    }
    path.walk.majorant /=
        path.walk.looseness;  // a ray that has not ended by now continues with tight majorants
    path.walk.looseness = float(1.0);
    return false;
}

// At the first vertex, after its direct light: true if the path takes its indirect light from the cache and
// is complete. Where the cache is a control variate, a path that continues is reweighted.
bool endsInCache(INOUT(Path) path, INOUT(Rng) rng) {
    uvec4 cells;
    vec4 found =
        indirectAt(path.origin, path.direction, indirectMatter(path.throughput, path.extinction), rng, cells);
    float goesOn = float(INDIRECT_DOUBT) / (float(INDIRECT_DOUBT) + found.w);
    if (params.indirectLeast > float(0.0)) goesOn = max(goesOn, params.indirectLeast);
    vec3 light = path.throughput * vec3(found);
    if (path.chance >= goesOn) {
        path.radiance += light;
        return true;
    }
    path.cells = cells;
    path.direct = path.radiance;
    path.albedo = path.throughput;
    if (params.indirectLeast > float(0.0)) {
        path.direct += light * (float(1.0) - float(1.0) / goesOn);
        path.albedo /= goesOn;
    }
    path.radiance = vec3(0.0);
    path.throughput = vec3(1.0);
    return false;
}

// The light of a complete path.
vec3 lightOf(Path path) {
    return useIndirect() ? path.direct + path.albedo * path.radiance : path.radiance;
}

// The environment's light for a path that has left the volume after a vertex with a surface. The vertex's
// next-event estimation could have found the same light, so each counts by its share of both pdfs (multiple
// importance sampling, balance heuristic, Veach and Guibas 1995).
vec3 lightAhead(Path path) {
    vec4 light = fetchEnvironment(environmentTexel(environmentFromWorld(path.direction)));
    return path.throughput * vec3(light) * (params.lightStrength * path.nextPdf / (path.nextPdf + light.w));
}

// At a vertex that may have a surface: sets the light of the shadow ray, and the direction in which the path
// continues. The last vertex does not continue, and its shadow ray counts all of the light.
void scatterAtVertex(INOUT(Path) path, EnvironmentSample light, vec3 towardsLight, vec3 albedo,
                     INOUT(Rng) rng) {
    Matter matter = matterAt(path.origin, path.direction, albedo, path.secondShare, rng);
    bool isOnlyLook = matter.surface <= float(0.0) || path.vertices + 1 >= params.bounces;
    Scattering there = scattering(matter, path.direction, towardsLight);
    float chances = light.pdfPerSr + (isOnlyLook ? float(0.0) : there.pdfPerSr);
    path.pending = light.pdfPerSr > float(0.0)
                       ? path.throughput * there.perSr * light.radiance * (params.lightStrength / chances)
                       : vec3(0.0);
    float choice = random01(rng);
    path.next =
        scatteredDirection(matter, path.direction, netPoint(path.net, uint(2 * path.vertices + 2)), choice);
    Scattering onwards = scattering(matter, path.direction, path.next);
    path.throughput *= onwards.perSr / max(onwards.pdfPerSr, float(1e-20));
    path.nextPdf = isOnlyLook ? float(0.0) : onwards.pdfPerSr;
}

// Continues after a ray that has ended: after a flight with a vertex and its shadow ray; after a shadow ray
// with its light and a new flight. False when the path is complete.
bool decide(INOUT(Path) path, INOUT(Rng) rng) {
    vec3 direction;
    if (path.shadow) {
        path.radiance += path.pending * path.transmittance;
        path.vertices += 1;
        if (path.vertices >= params.bounces) return false;
        bool ends = false;
        // A loop, not an if: lavapipe skips it if no lane enters.
        for (bool asks = useIndirect() && path.vertices == 1; asks; asks = false)
            ends = endsInCache(path, rng);
        if (ends) return false;
        float strength = max(path.throughput.x, max(path.throughput.y, path.throughput.z));
        if (strength < float(ROULETTE_BELOW)) {
            if (random01(rng) * float(ROULETTE_BELOW) >= strength) return false;
            path.throughput *= float(ROULETTE_BELOW) / strength;
        }
        path.direction = useSurfaces() ? path.next
                                       : samplePhase(path.direction, params.anisotropy,
                                                     netPoint(path.net, uint(2 * path.vertices)));
        direction = path.direction;
    } else {
        if (path.transmittance > float(0.0)) {  // it has left the volume, or reached a face
            if (path.vertices == 0 && path.face > float(0.0)) {
                path.radiance = vec3(path.face);
                path.coverage = float(1.0);
            }
            if (useSurfaces() && path.nextPdf > float(0.0)) path.radiance += lightAhead(path);
            return false;
        }
        path.coverage = float(1.0);
        path.origin = walkPosition(path.walk);
        for (bool asks = useSteep() && !isSteepDenser(path.entry); asks; asks = false)
            path.steep = steepPart(gradientByChance(path.origin, rng));
        vec3 albedo = albedoAt(path.origin, path.entry, path.steep, path.secondShare);
        for (bool asks = useIndirect() && path.vertices == 0; asks; asks = false)
            path.extinction = totalOf(mixtureAt(path.origin, path.entry, path.steep));
        EnvironmentSample light = sampleEnvironment(netPoint(path.net, uint(2 * path.vertices + 1)));
        direction = worldFromEnvironment(light.direction);
        if (useSurfaces()) {
            scatterAtVertex(path, light, direction, albedo, rng);
        } else {
            path.throughput *= albedo;
            float phase = phaseHenyeyGreenstein(dot(path.direction, direction), params.anisotropy);
            path.pending = light.pdfPerSr > float(0.0) ? path.throughput * light.radiance *
                                                             (params.lightStrength * phase / light.pdfPerSr)
                                                       : vec3(0.0);
        }
    }
    bool wasShadow = path.shadow;
    path.walk = startLightWalk(path.origin, voxelsPerMm(direction));
    path.transmittance = float(1.0);
    path.shadow = false;
    if (!wasShadow) beShadow(path);
    return true;
}

// Extends a path by a stride, and by a decision if the ray has ended. False when the path is complete.
bool extendPath(INOUT(Path) path, INOUT(Rng) rng) {
    return !follow(path, rng) || decide(path, rng);
}

// The ray through a point of the picture.
struct EyeRay {
    vec3 originVoxel;  // the eye; in a parallel view the ray's point in the plane through the eye
    vec3 asideMm;      // from the eye to originVoxel, world
    vec3 direction;    // unit, world
};

// `pixel` is counted from the top left corner of the picture.
EyeRay eyeRay(vec2 pixel) {
    vec2 p = vec2(float(2.0) * pixel.x / float(params.imageSize.x) - float(1.0),
                  float(1.0) - float(2.0) * pixel.y / float(params.imageSize.y));
    if (params.foveaMagnification > float(1.0)) {
        Fovea fovea = Fovea(params.planeHalfSize, params.gaze, params.foveaRadius, params.foveaMagnification);
        p = seenFromStored(fovea, p * params.planeHalfSize) / params.planeHalfSize;
    }
    vec3 inPlane = params.right * p.x + params.up * p.y;
    if (params.parallelMm > float(0.0)) {
        vec3 asideMm = inPlane * params.parallelMm;
        return EyeRay(params.originVoxel + voxelsPerMm(asideMm), asideMm, params.forward);
    }
    return EyeRay(params.originVoxel, vec3(0.0), normalize(params.forward + inPlane));
}

// The same ray through a point of a thin lens around the eye, `onDisc` on a disc of radius 1: both rays meet
// in the plane of focus.
EyeRay throughLens(EyeRay ray, vec2 onDisc) {
    vec3 focusMm = ray.direction * (params.lensFocusMm / dot(ray.direction, params.forward));
    vec3 onLensMm =
        (normalize(params.right) * onDisc.x + normalize(params.up) * onDisc.y) * params.lensRadiusMm;
    return EyeRay(ray.originVoxel + voxelsPerMm(onLensMm), ray.asideMm + onLensMm,
                  normalize(focusMm - onLensMm));
}

// Maps uniform numbers in [0, 1) to uniform points of a disc of radius 1.
vec2 discPoint(vec2 u) {
    float radius = sqrt(u.x);
    float angle = float(2.0 * PI) * u.y;
    return vec2(cos(angle), sin(angle)) * radius;
}

// A random number in [0, 1) that all pixels of a block share for a sample.
float blockChance(ivec2 block, uint sampleIndex) {
    uint bits = hashOf(hashOf(uint(block.x), uint(block.y)), hashOf(sampleIndex, params.seed));
    return float(bits >> 8u) * float(1.0 / 16777216.0);
}

// The path of one sample of a pixel, and its random numbers.
Path startSample(ivec2 pixel, uint sampleIndex, OUT(Rng) rng) {
    rng = makeRng(uint(pixel.x), uint(pixel.y), sampleIndex, params.seed);
    Net net = netOfPixel(uint(pixel.x), uint(pixel.y), sampleIndex, params.seed);
    // The position in the pixel is plainly random: a net would make edges so exact that the denoiser, which
    // assumes independent samples, would blur them for noise that they do not have.
    float x = float(pixel.x) + random01(rng);
    float y = float(pixel.y) + random01(rng);
    EyeRay ray = eyeRay(vec2(x, y));
    for (bool blurs = params.lensRadiusMm > float(0.0); blurs; blurs = false) {
        float u = random01(rng);
        float v = random01(rng);
        ray = throughLens(ray, discPoint(vec2(u, v)));
    }
    Path path = startPath(ray.originVoxel, ray.direction, net);
    // One for a block of the picture: lanes that work together take as long as their longest path.
    if (useIndirect()) path.chance = blockChance(pixel / 8, sampleIndex);
    return path;
}
