// Points on visible matter: the rays that find them, the area that each stands for, the light that leaves
// them, and the matter around them.
//
// Rays are distributed evenly over all lines that cross a cell (a box of the grid): they start anywhere on
// its surface, with the cosine law. So the probability that they meet matter at a point is proportional to
// its extinction and to the share of directions from which it is seen.
//
// Needs what path.glsl needs, and hasGreyFaces(), a constant.

// A point seen from at least this share of all directions counts in full; others in proportion. Without this
// limit open surfaces would get more points for the same area than grooves.
#define SEEN_ENOUGH 0.25

// The extra weight of points on grey clip faces, which gives them as many points as the surface of dense
// matter. Both are met by as many rays, but a face is seen from half of all directions everywhere, and matter
// from fewer the deeper it is met. It is the integral of min(2 E2(t), 1) over all depths t, times 1/2 over
// 1/4.
#define FACE_WEIGHT 1.8

// After so many rounds a ray is given up, see path_samples.glsl: only rays along very dense surfaces need
// more.
#define MANY_SURFACE_ROUNDS 4000

vec3 directionOnSphere(float cosine, float turn) {
    float sine = sqrt(max(float(0.0), float(1.0) - cosine * cosine));
    float azimuth = float(2.0 * PI) * (turn - float(0.5));  // as in samplePhase
    return vec3(sine * cos(azimuth), sine * sin(azimuth), cosine);
}

vec3 randomDirection(INOUT(Rng) rng) {
    float cosine = float(1.0) - float(2.0) * random01(rng);
    return directionOnSphere(cosine, random01(rng));
}

// Whether a point is within the volume and shown by clip and mask.
bool isShown(vec3 at) {
    vec3 high = vec3(params.volumeSize);
    bool outside = at.x < float(0.0) || at.y < float(0.0) || at.z < float(0.0) || at.x > high.x ||
                   at.y > high.y || at.z > high.z;
    if (useClip()) {
        ClipSpans spans = clipSpans(at, voxelsPerMm(vec3(float(1.0), float(0.0), float(0.0))));
        outside = outside || spans.from > float(0.0) || spans.to < float(0.0) ||
                  endOfCut(spans.cutFrom, spans.cutTo, float(0.0)) >= float(0.0);
    }
    return !outside && !isMasked(at);
}

float realShare(vec3 at, float majorant, INOUT(Rng) rng) {
    float entry = trilinearEntry(at);
    float steep = steepByChance(at, entry, rng);
    float real = min(totalOf(mixtureAt(at, entry, steep)) / majorant, float(1.0));
    return isMasked(at) ? float(0.0) : real;
}

// Visitor: transmittance of the shown matter, by ratio tracking with roulette. 0 for a ray that is given up.
float seenThrough(BrickWalk walk, INOUT(Rng) rng, INOUT(int) rounds) {
    float transmittance = float(1.0);
    int first = rounds;
    while (transmittance > float(0.0) && nextTentative(walk, rng, rounds)) {
        transmittance *= float(1.0) - realShare(walkPosition(walk), walk.majorant, rng);
        float chance = random01(rng);
        if (transmittance < float(ROULETTE_BELOW)) {
            transmittance =
                chance * float(ROULETTE_BELOW) < transmittance ? float(ROULETTE_BELOW) : float(0.0);
        }
        if (rounds - first > MANY_SURFACE_ROUNDS) transmittance = float(0.0);
    }
    return transmittance;
}

// Visitor: whether the ray meets matter before it ends; the walk then stands there.
bool meetsMatter(INOUT(BrickWalk) walk, INOUT(Rng) rng, INOUT(int) rounds) {
    bool met = false;
    int first = rounds;
    while (!met && rounds - first < MANY_SURFACE_ROUNDS && nextTentative(walk, rng, rounds)) {
        float chance = random01(rng);
        met = chance < realShare(walkPosition(walk), walk.majorant, rng);
    }
    return met;
}

// Whether grey clip faces leave a point visible to an eye in direction `outwards` (voxels per mm). A face
// hides everything behind it; a point on a face is visible only if the eye's ray meets that face.
bool isOpen(vec3 at, vec3 outwards, bool onFace) {
    if (!hasGreyFaces()) return true;
    float far = startWalk(at, outwards, nothingClipped()).endMm + voxelMm(outwards);
    float slack = float(1e-2) * voxelMm(outwards) + float(1e-5) * far;
    vec3 eye = at + outwards * far;
    BrickWalk walk = startEyeWalk(eye, -outwards);
    walk.endMm = min(walk.endMm, onFace ? far + slack : far - slack);
    bool meetsFace = stopAtFace(walk, eye, -outwards) > float(0.0);
    return onFace ? meetsFace && walk.endMm > far - slack : !meetsFace;
}

// Transmittance from a point to an eye in direction `outwards` (voxels per mm).
float seenFrom(vec3 at, vec3 outwards, bool onFace, INOUT(Rng) rng, INOUT(int) rounds) {
    bool open = isOpen(at, outwards, onFace);
    BrickWalk walk = startEyeWalk(at, outwards);
    if (!open) walk.endMm = walk.distanceMm;
    float seen = seenThrough(walk, rng, rounds);
    return open ? seen : float(0.0);
}

// The normal of voxel faces across an axis, towards its high end; its length is proportional to their area.
vec3 acrossFaces(int axis) {
    if (axis == 0) return vec3(params.voxelFromWorldX.x, params.voxelFromWorldY.x, params.voxelFromWorldZ.x);
    if (axis == 1) return vec3(params.voxelFromWorldX.y, params.voxelFromWorldY.y, params.voxelFromWorldZ.y);
    return vec3(params.voxelFromWorldX.z, params.voxelFromWorldY.z, params.voxelFromWorldZ.z);
}

// A ray from the surface of the box [low, high] into it, distributed evenly over all lines that cross it.
// Returns the origin in voxel coordinates; `direction` is in the world.
vec3 rayInto(vec3 low, vec3 high, INOUT(Rng) rng, OUT(vec3) direction) {
    vec3 size = high - low;
    float areaX = length(acrossFaces(0)) * size.y * size.z;
    float areaY = length(acrossFaces(1)) * size.z * size.x;
    float areaZ = length(acrossFaces(2)) * size.x * size.y;
    float pick = random01(rng) * (areaX + areaY + areaZ);
    int axis = pick < areaX ? 0 : (pick < areaX + areaY ? 1 : 2);
    float side = random01(rng) < float(0.5) ? float(0.0) : float(1.0);
    float u = random01(rng);
    float v = random01(rng);
    vec3 where = axis == 0 ? vec3(side, u, v) : (axis == 1 ? vec3(u, side, v) : vec3(u, v, side));
    vec3 inwards = normalize(acrossFaces(axis)) * (float(1.0) - float(2.0) * side);
    vec3 lambert = inwards + randomDirection(rng);  // normal plus a random unit vector: the cosine law
    float reach = length(lambert);
    direction = reach > float(1e-4) ? lambert / reach : inwards;
    return low + where * size;
}

// A point that an eye can see, or none.
struct Candidate {
    vec3 at;        // voxel coordinates
    float weight;   // area for which it stands, over a quarter of all cells' surface; 0: none
    float density;  // of points per mm, times each point's area; below 0: on a grey face
};

// Finds a candidate by a ray through the cell [low, high], in voxel coordinates within the volume.
Candidate findCandidate(vec3 low, vec3 high, int directions, INOUT(Rng) rng) {
    vec3 direction;
    vec3 origin = rayInto(low, high, rng, direction);
    vec3 along = voxelsPerMm(direction);
    BrickWalk walk = startEyeWalk(origin, along);
    vec3 inverse = vec3(safeInverse(along.x), safeInverse(along.y), safeInverse(along.z));
    vec3 leave = max((low - origin) * inverse, (high - origin) * inverse);
    walk.endMm = min(walk.endMm, min(leave.x, min(leave.y, leave.z)));
    bool meetsFace = hasGreyFaces() && stopAtFace(walk, origin, along) > float(0.0);
    int rounds = 0;
    bool met = meetsMatter(walk, rng, rounds);
    vec3 at = walkPositionAt(walk, met ? walk.distanceMm : walk.endMm);
    bool onFace = meetsFace && !met && rounds < MANY_SURFACE_ROUNDS;

    // Round 0 finds the transmittance of the matter in front of the cell, which is the probability to keep
    // the point. Later rounds find the share of directions from which it is seen, with one direction in each
    // of so many equal zones, a golden angle apart. One loop, because a kernel with two takes twice as long
    // to compile.
    bool found = onFace;
    float visibility = float(0.0);
    float turn = random01(rng);
    int last = met || onFace ? 0 : -1;
    for (int i = 0; i <= last; ++i) {
        float cosine = float(1.0) - float(2.0) * (float(i) - random01(rng)) / float(directions);
        vec3 outwards = voxelsPerMm(directionOnSphere(cosine, turn + float(i) * float(0.61803398875)));
        bool before = i == 0;
        if (before) outwards = -along;
        float seen = seenFrom(before ? origin : at, outwards, onFace && !before, rng, rounds);
        if (before) {
            found = onFace || random01(rng) < seen;
            last = found ? directions : 0;
        } else {
            visibility += seen / float(directions);
        }
    }
    Candidate candidate;
    candidate.at = at;
    candidate.weight = onFace
                           ? min(float(FACE_WEIGHT) / max(visibility, float(1e-3)), float(1.0 / SEEN_ENOUGH))
                           : float(1.0) / max(visibility, float(SEEN_ENOUGH));
    if (!found) candidate.weight = float(0.0);
    // At least one ray has seen it: the lower limit is for points that all other rays missed.
    float entry = trilinearEntry(at);
    float steep = steepAt(at, entry);
    candidate.density = totalOf(mixtureAt(at, entry, steep)) *
                        clamp(visibility * float(1.0 / SEEN_ENOUGH), float(0.25), float(1.0));
    if (onFace) candidate.density = float(-1.0);
    return candidate;
}

// Moments of the extinction in a ball around a point: sums over taps, by offset from the point in mm.
struct Surroundings {
    float mass;
    vec3 first;
    vec3 diagonal;  // squares of the components of the offset
    vec3 offAxis;   // x y, y z, z x
};

// Optical depth behind a grey face over one radius: opaque.
#define FACE_DEPTH 20.0

// The share of one of `lanes` threads that tap the ball together, `taps` each. Taps fill the ball evenly:
// shells of equal volume, by the R2 sequence (Roberts 2018). Behind a grey face everything counts as opaque.
Surroundings surroundingsOf(vec3 point, float radiusMm, bool onFace, int lane, int lanes, int taps,
                            INOUT(Rng) rng) {
    Surroundings sums = Surroundings(float(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    for (int i = 0; i < taps; ++i) {
        int tap = i * lanes + lane;
        float shell = (float(tap) + float(0.5)) * float(0.754877666);
        shell -= floor(shell);
        vec3 offset =
            directionOnSphere(float(1.0) - (float(2.0) * float(tap) + float(1.0)) / float(taps * lanes),
                              float(tap) * float(0.569840291));
        offset *= radiusMm * pow(shell, float(1.0 / 3.0));
        vec3 at = point + voxelsPerMm(offset);
        float entry = trilinearEntry(at);
        float steep = steepByChance(at, entry, rng);
        float extinction = onFace ? float(FACE_DEPTH) / radiusMm : totalOf(mixtureAt(at, entry, steep));
        if (!isShown(at)) extinction = float(0.0);
        sums.mass += extinction;
        sums.first += extinction * offset;
        sums.diagonal += extinction * offset * offset;
        sums.offAxis += extinction * offset * vec3(offset.y, offset.z, offset.x);
    }
    return sums;
}

// A path from `radiusMm` outside a point to as far beyond it: its light leaves the matter around the point,
// and its coverage says whether it met any. `weight` is the transmittance from the point outwards along that
// path; a path with weight 0 is complete.
Path startTowards(vec3 at, float radiusMm, bool onFace, Net net, INOUT(Rng) rng, INOUT(int) rounds,
                  OUT(float) weight) {
    vec2 u = netPoint(net, 0u);
    vec3 direction = directionOnSphere(float(1.0) - float(2.0) * u.x, u.y);
    vec3 outwards = voxelsPerMm(direction);
    weight = seenFrom(at, outwards, onFace, rng, rounds);
    Path path = startPath(at + outwards * radiusMm, -direction, net);
    float reach = weight > float(0.0) ? float(2.0) * radiusMm : float(0.0);
    if (path.walk.endMm > reach) {
        path.walk.endMm = reach;
        path.face = float(0.0);
    }
    return path;
}
