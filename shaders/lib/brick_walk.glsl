// The one walk through the brick grid, a 3D DDA with empty-space leaping. Everything that needs matter along
// a ray (free flights, transmittance, depth) is a visitor of this walk, so that traversal can be right or
// wrong in one place only.
//
// Needs from its host: params.volumeSize, params.gridSize, and fetchBound(brick index): above 0 the brick's
// majorant, an upper bound of the extinction anywhere in it, per mm; at or below 0 the brick is empty, and so
// are all bricks closer than minus that number (Chebyshev distance in bricks), which the walk leaps over.

// Bricks reach from one voxel centre to another, half a voxel off the voxel faces, and the first one begins
// before the volume: brick b holds the cells between centres 8b - 1 and 8b + 7, so that interpolation in it
// touches only few blocks of voxels (src/pipeline/volume/brick_grid.h).
#define BRICK_SHIFT 0.5

struct BrickWalk {
    vec3 origin;         // in bricks
    vec3 direction;      // bricks per mm, so that distances along the ray are mm
    vec3 inverse;        // mm per brick, finite in every component
    vec3 cell;           // next brick to visit
    float distanceMm;    // how far the ray has come
    float endMm;         // where it leaves the volume
    float segmentEndMm;  // where the current segment ends
    float majorant;      // of the current segment, per mm
    float looseness;     // factor on the brick's majorant, at least 1
    CUTS cutFrom;        // intervals of the ray that the clip removes, see clip.glsl
    CUTS cutTo;
};

// Moves the walk to `distanceMm` along the ray.
void leap(INOUT(BrickWalk) walk, float distanceMm) {
    walk.distanceMm = distanceMm;
    walk.segmentEndMm = distanceMm;
    walk.majorant = float(0.0);
    vec3 entry = walk.origin + walk.direction * distanceMm;
    walk.cell = clamp(floor(entry), vec3(0.0), vec3(params.gridSize - ivec3(1)));
}

// Starts a walk along a ray in voxel coordinates, through the part of the volume that `spans` leave. For a
// ray that misses, endMm <= distanceMm.
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

// Moves on to the next segment with matter in it: distanceMm to segmentEndMm, with its majorant. At a face or
// a corner a segment may have no length. False at the end. `rounds` counts the rounds of its loop.
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
        // At the very end rounding may put the walk one brick outside, where any bound will do.
        float bound =
            fetchBound(clamp(int(walk.cell.y * row + walk.cell.x) + int(walk.cell.z) * plane, 0, lastBrick));
        float reach = max(-bound, float(1.0));

        // The faces of the cube of empty bricks around this one, or of this one alone.
        vec3 margin = vec3(reach - float(1.0));
        vec3 toFace = (walk.cell + forward + step * margin - walk.origin) * walk.inverse;
        float exitMm = min(min(toFace.x, toFace.y), toFace.z);

        // Crosses that face by index, and finds the other two coordinates by position, so that rounding can
        // neither stall the walk nor make it skip a brick.
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

// Moves on to the next tentative collision outside the clip's cuts: a Poisson process of rate `majorant`
// along the ray, which may restart at any point because it has no memory. False when the ray leaves the
// volume first.
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
