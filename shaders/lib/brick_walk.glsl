// The one walk through the brick grid, a 3D DDA with empty-space leaping. Everything that asks about matter
// along a ray
// - free flights, transmittance, depth - is a visitor of it, so that the traversal can be right, or wrong, in
// one place only.
//
// Needs from its host: params.volumeSize, params.gridSize, and fetchBound(brick index): above 0 an upper
// bound of the extinction anywhere in the brick, per mm; at or below 0 the brick is empty, and so are all
// bricks closer than minus that number (Chebyshev distance in bricks), which the walk leaps over.

// Bricks reach from one voxel centre to another, half a voxel beside the faces of voxels, and the first one
// begins before the volume: brick b holds the cells between centres 8b - 1 and 8b + 7, so that what is
// interpolated in it touches only few blocks of voxels (src/pipeline/volume/brick_grid.h).
#define BRICK_SHIFT 0.5

struct BrickWalk {
    vec3 origin;         // in bricks
    vec3 direction;      // bricks per mm, so that distances along the ray are mm
    vec3 inverse;        // mm per brick, finite in every component
    vec3 cell;           // next brick to be looked at
    float distanceMm;    // how far the ray has come
    float endMm;         // where it leaves the volume
    float segmentEndMm;  // where the current segment ends
    float majorant;      // bound on extinction in it, per mm
    float looseness;     // factor on the brick's bound, at least 1
    vec3 cutFrom;        // what the clip removes on the way, see clip.glsl
    vec3 cutTo;
};

// Moves the walk to `distanceMm` along the ray.
void leap(INOUT(BrickWalk) walk, float distanceMm) {
    walk.distanceMm = distanceMm;
    walk.segmentEndMm = distanceMm;
    walk.majorant = float(0.0);
    vec3 entry = walk.origin + walk.direction * distanceMm;
    walk.cell = clamp(floor(entry), vec3(0.0), vec3(params.gridSize - ivec3(1)));
}

// Starts a walk along a ray given in voxel coordinates, through what `spans` leave of the volume. A ray that
// misses has endMm <= distanceMm.
BrickWalk startWalk(vec3 originVoxel, vec3 directionVoxel, ClipSpans spans) {
    BrickWalk walk;
    walk.origin = (originVoxel + vec3(BRICK_SHIFT)) * float(1.0 / BRICK);
    walk.direction = directionVoxel * float(1.0 / BRICK);
    walk.inverse =
        vec3(safeInverse(walk.direction.x), safeInverse(walk.direction.y), safeInverse(walk.direction.z));
    vec3 toLow = (vec3(BRICK_SHIFT / BRICK) - walk.origin) * walk.inverse;
    vec3 toHigh =
        ((vec3(params.volumeSize) + vec3(BRICK_SHIFT)) * float(1.0 / BRICK) - walk.origin) * walk.inverse;
    vec3 enter = min(toLow, toHigh);
    vec3 leave = max(toLow, toHigh);
    walk.endMm = min(min(min(leave.x, leave.y), leave.z), spans.to);
    walk.looseness = float(1.0);
    walk.cutFrom = spans.cutFrom;
    walk.cutTo = spans.cutTo;
    leap(walk, max(max(max(enter.x, enter.y), max(enter.z, float(0.0))), spans.from));
    return walk;
}

// Moves on to the next segment with matter in it: distanceMm to segmentEndMm, bounded by majorant. On
// a face or a corner a segment may have no length. False at the end.
// `rounds` counts the rounds of its loop.
bool nextSegment(INOUT(BrickWalk) walk, INOUT(int) rounds) {
    // The brick's index is computed in floats within a plane, which is faster; across planes the largest
    // volumes have too many bricks for floats.
    float row = float(params.gridSize.x);
    int plane = params.gridSize.x * params.gridSize.y;
    int lastBrick = params.gridSize.x * params.gridSize.y * params.gridSize.z - 1;
    vec3 forward = vec3(walk.direction.x < float(0.0) ? float(0.0) : float(1.0),
                        walk.direction.y < float(0.0) ? float(0.0) : float(1.0),
                        walk.direction.z < float(0.0) ? float(0.0) : float(1.0));
    vec3 step = forward * float(2.0) - vec3(1.0);
    walk.distanceMm = walk.segmentEndMm;
    while (walk.distanceMm < walk.endMm) {
        rounds += 1;
        // At its very end, rounding may put the walk one brick outside: then any bound is as good as another.
        float bound =
            fetchBound(clamp(int(walk.cell.y * row + walk.cell.x) + int(walk.cell.z) * plane, 0, lastBrick));
        float reach = max(-bound, float(1.0));

        // The faces of the cube of empty bricks around this one, or of this one alone.
        vec3 margin = vec3(reach - float(1.0));
        vec3 toFace = (walk.cell + forward + step * margin - walk.origin) * walk.inverse;
        float exitMm = min(min(toFace.x, toFace.y), toFace.z);

        // Across that face by index, elsewhere by position: rounding can neither stall the walk nor let it
        // skip a brick.
        vec3 there = floor(walk.origin + walk.direction * exitMm);
        vec3 beside = clamp(there, walk.cell - margin, walk.cell + margin);
        vec3 across = walk.cell + step * reach;
        walk.cell = vec3(toFace.x <= exitMm ? across.x : beside.x, toFace.y <= exitMm ? across.y : beside.y,
                         toFace.z <= exitMm ? across.z : beside.z);

        walk.segmentEndMm = min(max(exitMm, walk.distanceMm), walk.endMm);
        walk.majorant = bound * walk.looseness;
        if (bound > float(0.0)) return true;
        walk.distanceMm = walk.segmentEndMm;
    }
    walk.majorant = float(0.0);
    return false;
}

// Moves on to the next tentative collision in what is shown: a Poisson process of rate `majorant` along the
// ray, which may begin again at any point. False when the ray has left the volume first.
bool nextTentative(INOUT(BrickWalk) walk, INOUT(Rng) rng, INOUT(int) rounds) {
    float depth = exponentialDepth(random01(rng));
    do {
        float segmentDepth = walk.majorant * (walk.segmentEndMm - walk.distanceMm);
        if (depth < segmentDepth) {
            walk.distanceMm += depth / walk.majorant;
            float cutEnd = useClip() ? endOfCut(walk.cutFrom, walk.cutTo, walk.distanceMm) : float(-1.0);
            if (cutEnd < float(0.0)) return true;
            leap(walk, cutEnd);
            segmentDepth = float(0.0);
            depth = exponentialDepth(random01(rng));
        }
        depth -= segmentDepth;
        rounds += 1;
    } while (nextSegment(walk, rounds));
    return false;
}

// A point of the ray, in voxel coordinates.
vec3 walkPositionAt(BrickWalk walk, float distanceMm) {
    return (walk.origin + walk.direction * distanceMm) * float(BRICK) - vec3(BRICK_SHIFT);
}
vec3 walkPosition(BrickWalk walk) {
    return walkPositionAt(walk, walk.distanceMm);
}
