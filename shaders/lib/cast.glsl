// Ray casting: one march along each ray through the one walk, without chance. What the clip removes is skipped.
//
// Needs, beside path.glsl: castLook(), useShading(), constants; blocksOfBrick(brick) and fetchFrom(blocks, voxel) for the
// voxels of one brick; params.windowLow and windowHigh, in table entries, params.entryCount, params.stepsPerEntry,
// params.ambient and params.diffuse.

// The most steps in one cell, and the most once a ray has taken MANY_ROUNDS, because lavapipe ends long loops.
#define CAST_STEPS 64
#define CAST_STEPS_LATE 4
#define MANY_ROUNDS 8000
// Below this transmittance nothing behind is seen.
#define CAST_OPAQUE 0.00390625

// The next stretch of the ray that is shown and whose brick has a bound above `least`: walk.distanceMm to toMm. toMm is where
// the one before ended, at first walk.distanceMm. False at the end.
bool nextPiece(INOUT(BrickWalk) walk, float least, INOUT(float) toMm, INOUT(int) rounds) {
    walk.distanceMm = toMm;
    do {
        rounds += 1;
        if (useClip()) {
            // One cut may end inside another.
            for (int i = 0; i < 3; ++i) walk.distanceMm = max(walk.distanceMm, endOfCut(walk.cutFrom, walk.cutTo, walk.distanceMm));
        }
        if (walk.majorant > least && walk.distanceMm < walk.segmentEndMm) {
            toMm = walk.segmentEndMm;
            if (useClip()) {
                vec3 cut = walk.cutFrom;
                if (cut.x < walk.cutTo.x && cut.x > walk.distanceMm) toMm = min(toMm, cut.x);
                if (cut.y < walk.cutTo.y && cut.y > walk.distanceMm) toMm = min(toMm, cut.y);
                if (cut.z < walk.cutTo.z && cut.z > walk.distanceMm) toMm = min(toMm, cut.z);
            }
            return true;
        }
        if (walk.distanceMm > walk.segmentEndMm) leap(walk, walk.distanceMm);
    } while (nextSegment(walk, rounds));
    return false;
}

// A ray from cell to cell: between eight voxel centres, so that along the ray the interpolated value is one cubic. From one
// cell to the next four of its corners stay, and only four are fetched. Half a voxel beyond the outer centres a cell has the
// same corner twice.
//
// Along each axis that the ray goes down, the volume is mirrored: in the walk's own coordinates every ray goes up.
struct CellWalk {
    vec3 side;       // 1, or -1 along the axes that are mirrored
    vec3 shift;      // see mirrored()
    vec3 origin;     // in voxels, with integers at centres
    vec3 direction;  // voxels per mm, none below 0
    vec3 inverse;
    vec3 cell;       // its low corner
    vec3 faceMm;     // where the ray meets the cell's high faces
    float fromMm;    // where it enters the cell
    float toMm;      // and leaves it
    Corners corners;
    Blocks blocks;     // of the brick under way
    ivec3 firstVoxel;  // of this brick, not mirrored
    ivec3 lastVoxel;
};

// Converts to the walk's coordinates, and from them.
vec3 mirrored(CellWalk cells, vec3 p) {
    return p * cells.side + cells.shift;
}

CellWalk startCells(vec3 originVoxel, vec3 directionVoxel) {
    CellWalk cells;
    cells.side = vec3(directionVoxel.x < float(0.0) ? float(-1.0) : float(1.0),
                      directionVoxel.y < float(0.0) ? float(-1.0) : float(1.0),
                      directionVoxel.z < float(0.0) ? float(-1.0) : float(1.0));
    cells.shift = (vec3(1.0) - cells.side) * float(0.5) * vec3(params.volumeSize - ivec3(1));
    cells.origin = mirrored(cells, originVoxel - vec3(0.5));
    cells.direction = directionVoxel * cells.side;
    cells.inverse = vec3(safeInverse(cells.direction.x), safeInverse(cells.direction.y), safeInverse(cells.direction.z));
    return cells;
}

// A corner's voxel. Rounding may carry a cell across a face of its brick: its corners are those of the face then.
ivec3 voxelOf(CellWalk cells, vec3 corner) {
    return clamp(ivec3(mirrored(cells, corner)), cells.firstVoxel, cells.lastVoxel);
}

void leaveCellAt(INOUT(CellWalk) cells, float endMm) {
    cells.faceMm = (cells.cell + vec3(1.0) - cells.origin) * cells.inverse;
    cells.toMm = min(max(min(min(cells.faceMm.x, cells.faceMm.y), cells.faceMm.z), cells.fromMm), endMm);
}

// Where a ray is at a part of its way through the cell, 0 to 1: between the corners, 0 to 1 along each axis.
vec3 fractionIn(CellWalk cells, float part) {
    float atMm = mix(cells.fromMm, cells.toMm, part);
    return clamp(cells.origin + cells.direction * atMm - cells.cell, vec3(0.0), vec3(1.0));
}

bool hasGradients() {
    return castLook() == kCastMatter && (useGradientOpacity() || useShading());
}

// Enters the first cell of a stretch in one brick. Returns the value where the ray enters it.
float enterBrick(INOUT(CellWalk) cells, BrickWalk walk, float endMm) {
    ivec3 brick = clamp(ivec3(floor(walk.origin + walk.direction * (float(0.5) * (walk.distanceMm + endMm)))), ivec3(0),
                        params.gridSize - ivec3(1));
    cells.blocks = blocksOfBrick(brick);
    cells.firstVoxel = max(brick * BRICK - ivec3(1), ivec3(0));
    cells.lastVoxel = min(brick * BRICK + ivec3(BRICK - 1), params.volumeSize - ivec3(1));
    cells.fromMm = walk.distanceMm;
    cells.cell = floor(cells.origin + cells.direction * cells.fromMm);
    leaveCellAt(cells, endMm);
    ivec3 a = voxelOf(cells, cells.cell);
    ivec3 b = voxelOf(cells, cells.cell + vec3(1.0));
    cells.corners.near = vec4(fetchFrom(cells.blocks, a), fetchFrom(cells.blocks, ivec3(b.x, a.y, a.z)),
                              fetchFrom(cells.blocks, ivec3(a.x, b.y, a.z)), fetchFrom(cells.blocks, ivec3(b.x, b.y, a.z)));
    cells.corners.far = vec4(fetchFrom(cells.blocks, ivec3(a.x, a.y, b.z)), fetchFrom(cells.blocks, ivec3(b.x, a.y, b.z)),
                             fetchFrom(cells.blocks, ivec3(a.x, b.y, b.z)), fetchFrom(cells.blocks, b));
    return interpolated(cells.corners, fractionIn(cells, float(0.0)));
}

// The corners of the next cell along x, along y, or else along z, of which four lie `ahead`.
Corners movedOn(Corners c, vec4 ahead, bool x, bool y) {
    Corners next;
    next.fraction = vec3(0.0);
    next.near = vec4(x ? c.near.y : (y ? c.near.z : c.far.x), x ? ahead.x : (y ? c.near.w : c.far.y),
                     x ? c.near.w : (y ? ahead.x : c.far.z), x ? ahead.y : (y ? ahead.y : c.far.w));
    next.far = vec4(x ? c.far.y : (y ? c.far.z : ahead.x), x ? ahead.z : (y ? c.far.w : ahead.y),
                    x ? c.far.w : (y ? ahead.z : ahead.z), ahead.w);
    return next;
}

// Moves on through the face that the ray meets first, false at the end. It goes by index from cell to cell: rounding
// can neither stall it nor make it skip one.
bool nextCell(INOUT(CellWalk) cells, float endMm) {
    if (cells.toMm >= endMm) return false;
    bool x = cells.faceMm.x <= min(cells.faceMm.y, cells.faceMm.z);
    bool y = !x && cells.faceMm.y <= cells.faceMm.z;
    bool z = !x && !y;
    cells.cell += vec3(x ? float(1.0) : float(0.0), y ? float(1.0) : float(0.0), z ? float(1.0) : float(0.0));
    cells.fromMm = cells.toMm;
    leaveCellAt(cells, endMm);

    // The four corners on the far side: (low, low), (high, low), (low, high), (high, high) along the other two axes.
    ivec3 a = voxelOf(cells, cells.cell);
    ivec3 b = voxelOf(cells, cells.cell + vec3(1.0));
    vec4 ahead = vec4(fetchFrom(cells.blocks, ivec3(x ? b.x : a.x, y ? b.y : a.y, z ? b.z : a.z)),
                      fetchFrom(cells.blocks, ivec3(b.x, x || y ? b.y : a.y, z ? b.z : a.z)),
                      fetchFrom(cells.blocks, ivec3(x ? b.x : a.x, x ? a.y : b.y, b.z)), fetchFrom(cells.blocks, b));
    cells.corners = movedOn(cells.corners, ahead, x, y);
    return true;
}

// The value along the ray through the cell: a cubic, by the part of the way, 0 to 1, above its value at 0.
struct Cubic {
    float start;
    vec3 slopes;
};

float valueOf(Cubic c, float part) {
    return c.start + part * (c.slopes.x + part * (c.slopes.y + part * c.slopes.z));
}

Cubic cubicIn(CellWalk cells, float start) {
    vec3 entry = fractionIn(cells, float(0.0));
    vec3 exit = fractionIn(cells, float(1.0));
    float toMiddle = interpolated(cells.corners, (entry + exit) * float(0.5)) - start;
    float toEnd = interpolated(cells.corners, exit) - start;
    vec3 across = exit - entry;
    vec4 d = cells.corners.far - cells.corners.near;
    float third = (d.x - d.y - d.z + d.w) * (across.x * across.y * across.z);
    Cubic c;
    c.start = start;
    c.slopes = vec3(float(4.0) * toMiddle - toEnd + float(0.5) * third,
                    float(2.0) * toEnd - float(4.0) * toMiddle - float(1.5) * third, third);
    return c;
}

// The position of a fraction of the cell, in voxel coordinates with integers at faces.
vec3 positionIn(CellWalk cells, vec3 fraction) {
    return mirrored(cells, cells.cell + fraction) + vec3(0.5);
}

// Central differences at the corners of a cell, per voxel: between them gradientAt() is their interpolation.
struct CellGradient {
    Corners x;
    Corners y;
    Corners z;
};

// The values at a corner of the cell's neighbourhood and at the three beside it along u and v. `blocks` has those
// of all of it.
vec4 fetchFour(CellWalk cells, Blocks blocks, vec3 corner, vec3 u, vec3 v) {
    ivec3 last = params.volumeSize - ivec3(1);
    return vec4(fetchFrom(blocks, clamp(ivec3(mirrored(cells, corner)), ivec3(0), last)),
                fetchFrom(blocks, clamp(ivec3(mirrored(cells, corner + u)), ivec3(0), last)),
                fetchFrom(blocks, clamp(ivec3(mirrored(cells, corner + v)), ivec3(0), last)),
                fetchFrom(blocks, clamp(ivec3(mirrored(cells, corner + u + v)), ivec3(0), last)));
}

// The gradients of the whole cell at once: a branch within the steps would skip nothing where eight rays are one
// vector. What is at both ends of a difference in the cell itself is there already.
CellGradient gradientOfCell(CellWalk cells) {
    vec3 x = vec3(float(1.0), float(0.0), float(0.0));
    vec3 y = vec3(float(0.0), float(1.0), float(0.0));
    vec3 z = vec3(float(0.0), float(0.0), float(1.0));
    // Four voxels along each axis lie in two blocks at most.
    vec3 end = max(mirrored(cells, cells.cell - vec3(1.0)), mirrored(cells, cells.cell + vec3(2.0)));
    Blocks blocks = blocksOfBrick(clamp(ivec3(end), ivec3(0), params.volumeSize - ivec3(1)) >> 3);
    vec4 near = cells.corners.near;
    vec4 far = cells.corners.far;
    CellGradient gradient;
    vec4 before = fetchFour(cells, blocks, cells.cell - x, y, z);
    vec4 after = fetchFour(cells, blocks, cells.cell + x * float(2.0), y, z);
    gradient.x.near = vec4(near.y - before.x, after.x - near.x, near.w - before.y, after.y - near.z) * float(0.5);
    gradient.x.far = vec4(far.y - before.z, after.z - far.x, far.w - before.w, after.w - far.z) * float(0.5);
    before = fetchFour(cells, blocks, cells.cell - y, x, z);
    after = fetchFour(cells, blocks, cells.cell + y * float(2.0), x, z);
    gradient.y.near = vec4(near.z - before.x, near.w - before.y, after.x - near.x, after.y - near.y) * float(0.5);
    gradient.y.far = vec4(far.z - before.z, far.w - before.w, after.z - far.x, after.w - far.y) * float(0.5);
    gradient.z.near = (far - fetchFour(cells, blocks, cells.cell - z, x, y)) * float(0.5);
    gradient.z.far = (fetchFour(cells, blocks, cells.cell + z * float(2.0), x, y) - near) * float(0.5);
    return gradient;
}

vec3 gradientIn(CellWalk cells, CellGradient gradient, vec3 fraction) {
    return worldGradient(vec3(interpolated(gradient.x, fraction), interpolated(gradient.y, fraction),
                              interpolated(gradient.z, fraction)) * cells.side);
}

// What a headlight leaves of a colour: ambient + diffuse |cos| of the angle between the ray and the gradient (Lambert, both
// sides alike). Where the values around are all the same there is no surface, and it is seen as if it faced the light.
float headlight(vec3 gradient, vec3 worldDirection) {
    float length2 = dot(gradient, gradient);
    float cosine = length2 > float(0.0) ? abs(dot(gradient, worldDirection)) / sqrt(length2) : float(1.0);
    return params.ambient + params.diffuse * cosine;
}

// Albedo, and extinction per mm.
vec4 matterOfEntry(float entry) {
    int low = int(entry);
    vec4 matter = fetchMatter(low);
    return matter + (fetchMatter(low + 1) - matter) * (entry - float(low));
}

// How much the second volume's value changes through the cell, in parts of what its curve needs a step for, and how many of
// its voxels the ray crosses there.
float secondSteps(CellWalk cells, float transmittance) {
    vec3 begin = inSecond(positionIn(cells, fractionIn(cells, float(0.0))));
    vec3 end = inSecond(positionIn(cells, fractionIn(cells, float(1.0))));
    float middle = secondEntry((begin + end) * float(0.5));
    float change = abs(middle - secondEntry(begin)) + abs(secondEntry(end) - middle);
    return max(change * params.secondStepsPerEntry * transmittance, float(2.0) * length(end - begin));
}

// Emission and absorption: the integral over the ray of transmittance * extinction * colour, premultiplied, and one minus
// the transmittance. A cell is crossed in as many steps as the transfer function needs over the values in it, and as what is
// left of the light deserves. Exact where extinction and colour are constant over each step; `phase`, 0 to 1, is where in its
// step a value is taken, and the mean over all phases has no bias of first order.
vec4 castMatter(EyeRay eye, float phase, INOUT(int) rounds) {
    vec3 directionVoxel = voxelsPerMm(eye.direction);
    BrickWalk walk = startEyeWalk(eye.originVoxel, directionVoxel);
    CellWalk cells = startCells(eye.originVoxel, directionVoxel);
    float face = float(0.0);
    if (useClip() && params.greyFaces != 0) face = stopAtFace(walk, eye.originVoxel, directionVoxel);
    int least = hasGradients() || useSecond() || useTints() ? 2 : 1;  // these change within a cell too
    vec3 colour = vec3(0.0);
    float transmittance = float(1.0);
    float toMm = walk.distanceMm;
    while (transmittance >= float(CAST_OPAQUE) && nextPiece(walk, float(0.0), toMm, rounds)) {
        float atEnd = enterBrick(cells, walk, toMm);
        do {
            rounds += 1;
            Cubic value = cubicIn(cells, atEnd);
            CellGradient gradients;
            if (hasGradients()) gradients = gradientOfCell(cells);
            float middle = valueOf(value, float(0.5));
            atEnd = valueOf(value, float(1.0));
            float change = abs(middle - value.start) + abs(atEnd - middle);
            int most = rounds < MANY_ROUNDS ? CAST_STEPS : CAST_STEPS_LATE;
            float wanted = change * params.stepsPerEntry * transmittance;
            if (useSecond()) wanted = max(wanted, secondSteps(cells, transmittance));
            int steps = clamp(int(ceil(min(wanted, float(CAST_STEPS)))), least, most);
            float step = (cells.toMm - cells.fromMm) / float(steps);
            for (int i = 0; i < steps && transmittance >= float(CAST_OPAQUE); ++i) {
                rounds += 1;
                float part = (float(i) + phase) / float(steps);
                vec3 fraction = fractionIn(cells, part);
                vec4 matter = matterOfEntry(max(valueOf(value, part), float(0.0)));
                vec3 at = positionIn(cells, fraction);
                vec3 emitted = vec3(matter);
                bool masked = isMasked(at);
                float extinction = masked ? float(0.0) : matter.w;
                float shade = float(1.0);
                if (hasGradients()) {
                    vec3 gradient = gradientIn(cells, gradients, fraction);
                    if (useGradientOpacity()) extinction = thinnedByGradient(extinction, gradient);
                    if (useShading()) shade = headlight(gradient, eye.direction);
                }
                if (useTints()) {
                    Tint tint = tintAt(at);
                    emitted = tinted(emitted, tint);
                    extinction *= tint.opacity;
                }
                if (useShading()) emitted *= shade;
                if (useSecond()) {
                    vec4 second = secondMatter(at);
                    Mixture mixture = Mixture(extinction, masked ? float(0.0) : second.w);
                    if (useShading()) second *= vec4(vec3(headlight(secondGradient(at), eye.direction)), float(1.0));
                    emitted = mix(emitted, vec3(second), secondShareOf(mixture));
                    extinction = totalOf(mixture);
                }
                float through = exp(-extinction * step);
                colour += emitted * (transmittance * (float(1.0) - through));
                transmittance *= through;
            }
        } while (transmittance >= float(CAST_OPAQUE) && nextCell(cells, toMm));
    }
    // Early termination: the rest of the transmittance is taken as 0, so that opaque matter is opaque.
    if (transmittance < float(CAST_OPAQUE)) return vec4(colour / (float(1.0) - transmittance), float(1.0));
    if (face > float(0.0)) return vec4(colour + vec3(transmittance * face), float(1.0));
    return vec4(colour, float(1.0) - transmittance);
}

// Voxels outside the scan have an entry of their own, below those of all that were measured (entry_map.cpp): air in a trachea
// counts. Padding lowers what it is interpolated with: that is no minimum, and no part of a mean. To a maximum it does no harm,
// and what lies beside it must not be lost.
bool isCounted(Corners corners) {
    vec4 near = abs(corners.near - vec4(params.paddingEntry));
    vec4 far = abs(corners.far - vec4(params.paddingEntry));
    if (castLook() == kCastMaximum) return dot(near, vec4(1.0)) + dot(far, vec4(1.0)) > float(0.5);
    return min(min(min(near.x, near.y), min(near.z, near.w)), min(min(far.x, far.y), min(far.z, far.w))) > float(0.5);
}

// The largest, smallest or mean value along what is shown of the ray, as the grey that the window gives it; nothing where
// the ray meets no values. The mean is exact, by Simpson's rule on cubics; an extreme is that at a face of a cell, where
// most lie, or at one of three points between. A mask counts for a whole cell, as it is in the middle of its stretch. The medium
// of a projection bounds how much a brick can change the answer (src/pipeline/volume/medium.h), so that bricks which cannot are
// not looked at.
vec4 castValues(EyeRay eye, INOUT(int) rounds) {
    vec3 directionVoxel = voxelsPerMm(eye.direction);
    BrickWalk walk = startEyeWalk(eye.originVoxel, directionVoxel);
    CellWalk cells = startCells(eye.originVoxel, directionVoxel);
    float sign = castLook() == kCastMinimum ? float(-1.0) : float(1.0);
    float best = float(-1e9);  // sign times the value
    float sum = float(0.0);
    float lengthMm = float(0.0);
    float toMm = walk.distanceMm;
    // What a brick's bound must be above to change the answer: half an entry is kept back for rounding.
    float least = float(0.0);
    while (nextPiece(walk, least, toMm, rounds)) {
        float atEnd = enterBrick(cells, walk, toMm);
        do {
            rounds += 1;
            Cubic value = cubicIn(cells, atEnd);
            float middle = valueOf(value, float(0.5));
            atEnd = valueOf(value, float(1.0));
            float here = max(max(sign * value.start, sign * atEnd), sign * middle);
            here = max(here, max(sign * valueOf(value, float(0.25)), sign * valueOf(value, float(0.75))));
            vec3 centre = walkPositionAt(walk, float(0.5) * (cells.fromMm + cells.toMm));
            bool counts = isCounted(cells.corners) && !isMasked(centre);
            float length = counts ? cells.toMm - cells.fromMm : float(0.0);
            best = counts ? max(best, here) : best;
            sum += (value.start + float(4.0) * middle + atEnd) * (length * float(1.0 / 6.0));
            lengthMm += length;
        } while (nextCell(cells, toMm));
        if (castLook() == kCastMaximum) least = max(best + float(0.5), float(0.0));
        if (castLook() == kCastMinimum) least = max(best + float(params.entryCount) - float(0.5), float(0.0));
    }
    if (best <= float(-1e9)) return vec4(0.0);
    float entry = castLook() == kCastMean ? (lengthMm > float(0.0) ? sum / lengthMm : best) : sign * best;
    float grey = clamp((entry - params.windowLow) / (params.windowHigh - params.windowLow), float(0.0), float(1.0));
    return vec4(vec3(greyBeforeToneMap(grey) / params.exposure), float(1.0));
}

// An additive recurrence (Roberts 2018, in three dimensions): where in the pixel and in its steps a sample lies, 0 to 1. The
// first one is the centre. The same for all pixels, so that a smooth picture stays smooth.
vec3 castOffset(uint sampleIndex) {
    uint centre = 0x80000000u;
    return vec3(float((centre + sampleIndex * 3518319155u) >> 8u), float((centre + sampleIndex * 2882110345u) >> 8u),
                float((centre + sampleIndex * 2360945575u) >> 8u)) * float(1.0 / 16777216.0);
}

// One sample of a pixel: premultiplied, with coverage.
vec4 castSample(ivec2 pixel, uint sampleIndex, INOUT(int) rounds) {
    vec3 offset = castOffset(sampleIndex);
    EyeRay eye = eyeRay(vec2(float(pixel.x) + offset.x, float(pixel.y) + offset.y));
    if (castLook() == kCastMatter) return castMatter(eye, offset.z, rounds);
    return castValues(eye, rounds);
}
