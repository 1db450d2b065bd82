// Points on what can be seen: how much of it is at a place, what light comes from there, and how matter lies around.
//
// Needs what path.glsl needs.

// What is seen from so large a part of all directions counts in full; less, in proportion. Without this limit what lies open
// would get more points for the same area than what lies in a groove.
#define SEEN_ENOUGH 0.25

// Extinction that an eye can meet, per mm: 0 outside of the volume and of what clip and mask leave.
float shownExtinctionAt(vec3 at) {
    vec3 high = vec3(params.volumeSize);
    bool outside = at.x < float(0.0) || at.y < float(0.0) || at.z < float(0.0) || at.x > high.x || at.y > high.y || at.z > high.z;
    if (useClip()) {
        ClipSpans spans = clipSpans(at, voxelsPerMm(vec3(float(1.0), float(0.0), float(0.0))));
        outside = outside || spans.from > float(0.0) || spans.to < float(0.0) ||
                  endOfCut(spans.cutFrom, spans.cutTo, float(0.0)) >= float(0.0);
    }
    if (outside || isMasked(at)) return float(0.0);
    return extinctionAt(at, trilinearEntry(at));
}

vec3 directionOnSphere(float cosine, float turn) {
    float sine = sqrt(max(float(0.0), float(1.0) - cosine * cosine));
    float azimuth = float(2.0 * PI) * turn;
    return vec3(sine * cos(azimuth), sine * sin(azimuth), cosine);
}

vec3 randomDirection(INOUT(Rng) rng) {
    float cosine = float(1.0) - float(2.0) * random01(rng);
    return directionOnSphere(cosine, random01(rng));
}

// Visitor: transmittance of what an eye is shown, by ratio tracking with roulette.
float seenThrough(BrickWalk walk, INOUT(Rng) rng, INOUT(int) rounds) {
    float transmittance = float(1.0);
    while (transmittance > float(0.0) && nextTentative(walk, rng, rounds)) {
        vec3 at = walkPosition(walk);
        float real = min(extinctionAt(at, trilinearEntry(at)) / walk.majorant, float(1.0));
        if (isMasked(at)) real = float(0.0);
        transmittance *= float(1.0) - real;
        float chance = random01(rng);
        if (transmittance < float(ROULETTE_BELOW)) {
            transmittance = chance * float(ROULETTE_BELOW) < transmittance ? float(ROULETTE_BELOW) : float(0.0);
        }
    }
    return transmittance;
}

// From how much of all directions a point is seen, 0 to 1.
float visibilityOf(vec3 at, int directions, INOUT(Rng) rng) {
    float sum = float(0.0);
    float turn = random01(rng);
    int rounds = 0;
    for (int i = 0; i < directions; ++i) {
        // One in each of as many equal zones, a golden angle apart.
        float cosine = float(1.0) - float(2.0) * (float(i) + random01(rng)) / float(directions);
        vec3 direction = directionOnSphere(cosine, turn + float(i) * float(0.61803398875));
        sum += seenThrough(startEyeWalk(at, voxelsPerMm(direction)), rng, rounds);
    }
    return sum / float(directions);
}

// How much of what is seen is at a point, in mm^2 of surface per mm^3.
float weightOfPoint(vec3 at, int directions, INOUT(Rng) rng) {
    float extinction = shownExtinctionAt(at);
    int asked = extinction > float(0.0) ? directions : 0;
    float seen = asked > 0 ? visibilityOf(at, asked, rng) : float(0.0);
    return extinction * min(seen * float(1.0 / SEEN_ENOUGH), float(1.0));
}

// A path from outside towards a point, as far beyond it as it starts before it: what it brings is light that leaves the
// matter around the point, and whether it met any. `weight` is how well an eye there is seen from all outside; a path of no
// weight is complete.
Path startTowards(vec3 at, float radiusMm, INOUT(Rng) rng, INOUT(int) rounds, OUT(float) weight) {
    vec3 direction = randomDirection(rng);
    vec3 outwards = voxelsPerMm(direction);
    weight = seenThrough(startEyeWalk(at, outwards), rng, rounds);
    Path path = startPath(at + outwards * radiusMm, -direction);
    path.walk.endMm = min(path.walk.endMm, weight > float(0.0) ? float(2.0) * radiusMm : float(0.0));
    path.face = float(0.0);
    return path;
}
