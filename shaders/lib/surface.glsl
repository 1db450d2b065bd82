// Points on what can be seen: rays that find them, how much of it each stands for, what light comes from
// there, and how matter lies around.
//
// Rays are even over all lines that cross a cell (a box of the grid): they start anywhere on its surface,
// with the cosine law. So they meet matter at a place in proportion to its extinction and to how much of all
// directions it is seen from.
//
// Needs what path.glsl needs, and hasGreyFaces(), a constant.

// What is seen from so large a part of all directions counts in full; less, in proportion. Without this limit
// what lies open would get more points for the same area than what lies in a groove.
#define SEEN_ENOUGH 0.25

// A face that shows grey values is met by as many rays as the surface of dense matter, but seen from half of
// all directions throughout, and matter from fewer the deeper it is met: so much more a point of the face
// weighs, so that both have as many points. It is the integral of min(2 E2(t), 1) over all depths t, times
// 1/2 over 1/4.
#define FACE_WEIGHT 1.8

// Rounds of a ray after which it is given up, see path_samples.glsl: more than any takes but along the
// densest of surfaces.
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

// Whether an eye can be shown anything at a point: not outside of the volume, nor of what clip and mask
// leave.
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

// Visitor: transmittance of what an eye is shown, by ratio tracking with roulette. A ray that is given up
// sees nothing.
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

// Whether faces of the clip leave a point to be seen by an eye in direction `outwards` (voxels per mm). A
// face hides what is behind it; and what is on one is seen only from where the face is met.
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

// The normal of the faces of voxels across an axis, inwards from their low end; its length is in proportion
// to their area.
vec3 acrossFaces(int axis) {
    if (axis == 0) return vec3(params.voxelFromWorldX.x, params.voxelFromWorldY.x, params.voxelFromWorldZ.x);
    if (axis == 1) return vec3(params.voxelFromWorldX.y, params.voxelFromWorldY.y, params.voxelFromWorldZ.y);
    return vec3(params.voxelFromWorldX.z, params.voxelFromWorldY.z, params.voxelFromWorldZ.z);
}

// A ray from the surface of the box [low, high] into it, even over all lines that cross it. Origin in voxel
// coordinates, direction in the world.
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
    vec3 lambert =
        inwards + randomDirection(rng);  // ends of unit vectors on a ball that touches: the cosine law
    float reach = length(lambert);
    direction = reach > float(1e-4) ? lambert / reach : inwards;
    return low + where * size;
}

// A place that an eye can see, or none.
struct Candidate {
    vec3 at;       // voxel coordinates
    float weight;  // area for each ray, over a quarter of the surface of all cells; 0: none
    float
        density;  // of points, per mm, times the area that each stands for; below 0: on a face of grey values
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

    // First what lies before the cell: the place is as likely seen as that lets light pass. Then from how
    // much of all directions it is seen: by one in each of as many equal zones, a golden angle apart. One
    // loop, because a kernel with two of them compiles twice as long.
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
    // A ray has seen it, whatever chance has made of the others.
    float entry = trilinearEntry(at);
    float steep = steepAt(at, entry);
    candidate.density = totalOf(mixtureAt(at, entry, steep)) *
                        clamp(visibility * float(1.0 / SEEN_ENOUGH), float(0.25), float(1.0));
    if (onFace) candidate.density = float(-1.0);
    return candidate;
}

// A path from outside towards a point, as far beyond it as it starts before it: what it brings is light that
// leaves the matter around the point, and whether it met any. `weight` is how well an eye there is seen from
// all outside; a path of no weight is complete.
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
