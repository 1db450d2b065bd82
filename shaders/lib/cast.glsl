// Ray casting: one march along each ray through the one walk, without chance. What the clip removes is skipped.
//
// Needs, beside path.glsl: castLook(), useShading(), constants; params.windowLow and windowHigh, in table entries,
// params.entryCount, params.stepsPerEntry, params.ambient and params.diffuse.

// At most so many steps in one cell; and so many once a ray has taken MANY_ROUNDS, as lavapipe ends long loops.
#define CAST_STEPS 64
#define CAST_STEPS_LATE 4
#define MANY_ROUNDS 8000
// Below this transmittance nothing behind is seen.
#define CAST_OPAQUE 0.00390625

// The next stretch of the ray that is shown and has matter in it: walk.distanceMm to toMm. toMm is where the one before
// ended, at first walk.distanceMm. False at the end.
bool nextPiece(INOUT(BrickWalk) walk, INOUT(float) toMm, INOUT(int) rounds) {
    walk.distanceMm = toMm;
    do {
        rounds += 1;
        if (useClip()) {
            // One cut may end inside another.
            for (int i = 0; i < 3; ++i) walk.distanceMm = max(walk.distanceMm, endOfCut(walk.cutFrom, walk.cutTo, walk.distanceMm));
        }
        if (walk.majorant > float(0.0) && walk.distanceMm < walk.segmentEndMm) {
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

// A ray from cell to cell: between eight voxel centres, so that along the ray the interpolated value is one cubic, and its
// corners are fetched once. Half a voxel beyond the outer centres a cell has the same corner twice.
struct CellWalk {
    vec3 origin;     // in voxels, with integers at centres
    vec3 direction;  // voxels per mm
    vec3 inverse;
    vec3 next;       // cell
    vec3 cell;       // under way: its low corner
    float fromMm;    // where the ray enters it
    float toMm;      // and leaves it
};

CellWalk startCells(vec3 originVoxel, vec3 directionVoxel) {
    CellWalk cells;
    cells.origin = originVoxel - vec3(0.5);
    cells.direction = directionVoxel;
    cells.inverse = vec3(safeInverse(directionVoxel.x), safeInverse(directionVoxel.y), safeInverse(directionVoxel.z));
    cells.next = vec3(0.0);
    cells.cell = vec3(0.0);
    cells.fromMm = float(0.0);
    cells.toMm = float(0.0);
    return cells;
}

void enterCells(INOUT(CellWalk) cells, float atMm) {
    cells.toMm = atMm;
    cells.next = floor(cells.origin + cells.direction * atMm);
}

// False at the end. By index from cell to cell: rounding can neither stall it nor make it skip one.
bool nextCell(INOUT(CellWalk) cells, float endMm) {
    if (cells.toMm >= endMm) return false;
    vec3 up = vec3(cells.direction.x < float(0.0) ? float(0.0) : float(1.0),
                   cells.direction.y < float(0.0) ? float(0.0) : float(1.0),
                   cells.direction.z < float(0.0) ? float(0.0) : float(1.0));
    vec3 toFace = (cells.next + up - cells.origin) * cells.inverse;
    float exitMm = min(min(toFace.x, toFace.y), toFace.z);
    vec3 step = up * float(2.0) - vec3(1.0);
    cells.cell = cells.next;
    cells.next += vec3(toFace.x <= exitMm ? step.x : float(0.0), toFace.y <= exitMm ? step.y : float(0.0),
                       toFace.z <= exitMm ? step.z : float(0.0));
    cells.fromMm = cells.toMm;
    cells.toMm = min(max(exitMm, cells.fromMm), endMm);
    return true;
}

// Of the cell that lies so many voxels beside it.
Corners cornersBeside(CellWalk cells, ivec3 offset) {
    ivec3 last = params.volumeSize - ivec3(1);
    ivec3 low = ivec3(cells.cell) + offset;
    Corners c;
    c.fraction = vec3(0.0);
    fetchCorners(clamp(low, ivec3(0), last), clamp(low + ivec3(1), ivec3(0), last), c.near, c.far);
    return c;
}

Corners cornersOfCell(CellWalk cells) {
    return cornersBeside(cells, ivec3(0));
}

// Central differences at the corners of a cell, of which the gradient between them is the interpolation: what gradientAt
// comes to, with the voxels around fetched once for the whole cell.
struct CellGradient {
    Corners x;
    Corners y;
    Corners z;
};

// What is at both ends of a difference in the cell itself is not fetched again.
CellGradient gradientOfCell(CellWalk cells, Corners c) {
    CellGradient gradient;
    Corners before = cornersBeside(cells, ivec3(-1, 0, 0));
    Corners after = cornersBeside(cells, ivec3(1, 0, 0));
    gradient.x.near = vec4(c.near.y - before.near.x, after.near.y - c.near.x, c.near.w - before.near.z, after.near.w - c.near.z) * float(0.5);
    gradient.x.far = vec4(c.far.y - before.far.x, after.far.y - c.far.x, c.far.w - before.far.z, after.far.w - c.far.z) * float(0.5);
    before = cornersBeside(cells, ivec3(0, -1, 0));
    after = cornersBeside(cells, ivec3(0, 1, 0));
    gradient.y.near = vec4(c.near.z - before.near.x, c.near.w - before.near.y, after.near.z - c.near.x, after.near.w - c.near.y) * float(0.5);
    gradient.y.far = vec4(c.far.z - before.far.x, c.far.w - before.far.y, after.far.z - c.far.x, after.far.w - c.far.y) * float(0.5);
    before = cornersBeside(cells, ivec3(0, 0, -1));
    after = cornersBeside(cells, ivec3(0, 0, 1));
    gradient.z.near = (c.far - before.near) * float(0.5);
    gradient.z.far = (after.far - c.near) * float(0.5);
    gradient.x.fraction = vec3(0.0);
    gradient.y.fraction = vec3(0.0);
    gradient.z.fraction = vec3(0.0);
    return gradient;
}

vec3 gradientIn(INOUT(CellGradient) gradient, vec3 fraction) {
    gradient.x.fraction = fraction;
    gradient.y.fraction = fraction;
    gradient.z.fraction = fraction;
    return worldGradient(vec3(interpolated(gradient.x), interpolated(gradient.y), interpolated(gradient.z)));
}

// The value at a part of the way through the cell, 0 to 1.
float valueIn(CellWalk cells, INOUT(Corners) corners, float part) {
    float atMm = mix(cells.fromMm, cells.toMm, part);
    corners.fraction = clamp(cells.origin + cells.direction * atMm - cells.cell, vec3(0.0), vec3(1.0));
    return interpolated(corners);
}

// What a headlight leaves of a colour: ambient + diffuse |cos| of the angle between the ray and the gradient (Lambert, both
// sides alike). Where the values around are all the same there is no surface, and it is seen as if it faced the light.
float headlight(vec3 gradient, vec3 worldDirection) {
    float length2 = dot(gradient, gradient);
    float cosine = length2 > float(0.0) ? abs(dot(gradient, worldDirection)) / sqrt(length2) : float(1.0);
    return params.ambient + params.diffuse * cosine;
}

vec3 albedoOfEntry(float entry) {
    int low = int(entry);
    return mix(fetchAlbedo(low), fetchAlbedo(low + 1), entry - float(low));
}

// Emission and absorption: the integral over the ray of transmittance * extinction * colour, premultiplied, and one minus
// the transmittance. A cell is crossed in as many steps as the transfer function needs over the values in it, and as what is
// left of the light deserves. Exact where extinction and colour are constant over each step; `phase`, 0 to 1, is where in its
// step a value is taken, and the mean over all phases has no bias of first order.
vec4 castMatter(vec3 worldDirection, float phase, INOUT(int) rounds) {
    vec3 directionVoxel = voxelsPerMm(worldDirection);
    BrickWalk walk = startEyeWalk(params.originVoxel, directionVoxel);
    CellWalk cells = startCells(params.originVoxel, directionVoxel);
    float face = float(0.0);
    if (useClip() && params.greyFaces != 0) face = stopAtFace(walk, params.originVoxel, directionVoxel);
    int least = useGradientOpacity() || useShading() ? 2 : 1;  // gradients change within a cell too
    vec3 colour = vec3(0.0);
    float transmittance = float(1.0);
    float toMm = walk.distanceMm;
    while (transmittance >= float(CAST_OPAQUE) && nextPiece(walk, toMm, rounds)) {
        enterCells(cells, walk.distanceMm);
        while (transmittance >= float(CAST_OPAQUE) && nextCell(cells, toMm)) {
            rounds += 1;
            Corners corners = cornersOfCell(cells);
            // For the whole cell: a branch within the steps would skip nothing where eight rays are one vector.
            CellGradient gradients;
            if (useGradientOpacity() || useShading()) gradients = gradientOfCell(cells, corners);
            float middle = valueIn(cells, corners, float(0.5));
            float change = abs(valueIn(cells, corners, float(0.0)) - middle) + abs(valueIn(cells, corners, float(1.0)) - middle);
            int most = rounds < MANY_ROUNDS ? CAST_STEPS : CAST_STEPS_LATE;
            int steps = clamp(int(ceil(min(change * params.stepsPerEntry * transmittance, float(CAST_STEPS)))), least, most);
            float step = (cells.toMm - cells.fromMm) / float(steps);
            for (int i = 0; i < steps && transmittance >= float(CAST_OPAQUE); ++i) {
                rounds += 1;
                float entry = valueIn(cells, corners, (float(i) + phase) / float(steps));
                vec3 at = cells.cell + corners.fraction + vec3(0.5);
                float extinction = isMasked(at) ? float(0.0) : extinctionOfEntry(entry);
                vec3 emitted = albedoOfEntry(entry);
                if (useGradientOpacity() || useShading()) {
                    vec3 gradient = gradientIn(gradients, corners.fraction);
                    if (useGradientOpacity()) extinction = thinnedByGradient(extinction, gradient);
                    if (useShading()) emitted *= headlight(gradient, worldDirection);
                }
                float through = exp(-extinction * step);
                colour += emitted * (transmittance * (float(1.0) - through));
                transmittance *= through;
            }
        }
    }
    // What is left at the early end goes to what was seen: opaque matter is opaque.
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
// most lie, or at one of three points between. A mask counts for a whole cell, as it is in the middle of its stretch. The medium of a projection bounds how much a brick can change the answer
// (src/pipeline/volume/medium.h), so that bricks which cannot are not looked at.
vec4 castValues(vec3 worldDirection, INOUT(int) rounds) {
    vec3 directionVoxel = voxelsPerMm(worldDirection);
    BrickWalk walk = startEyeWalk(params.originVoxel, directionVoxel);
    CellWalk cells = startCells(params.originVoxel, directionVoxel);
    float sign = castLook() == kCastMinimum ? float(-1.0) : float(1.0);
    float best = float(-1e9);  // sign times the value
    float sum = float(0.0);
    float lengthMm = float(0.0);
    float toMm = walk.distanceMm;
    while (nextPiece(walk, toMm, rounds)) {
        // Half an entry is kept back for rounding.
        bool matters = castLook() == kCastMean ||
                       walk.majorant + float(0.5) > (sign > float(0.0) ? best + float(1.0) : best + float(params.entryCount));
        enterCells(cells, walk.distanceMm);
        while (matters && nextCell(cells, toMm)) {
            rounds += 1;
            Corners corners = cornersOfCell(cells);
            float first = valueIn(cells, corners, float(0.0));
            float middle = valueIn(cells, corners, float(0.5));
            float last = valueIn(cells, corners, float(1.0));
            float here = max(max(sign * first, sign * last), sign * middle);
            here = max(here, max(sign * valueIn(cells, corners, float(0.25)), sign * valueIn(cells, corners, float(0.75))));
            vec3 centre = walkPositionAt(walk, float(0.5) * (cells.fromMm + cells.toMm));
            bool counts = isCounted(corners) && !isMasked(centre);
            float length = counts ? cells.toMm - cells.fromMm : float(0.0);
            best = counts ? max(best, here) : best;
            sum += (first + float(4.0) * middle + last) * (length * float(1.0 / 6.0));
            lengthMm += length;
        }
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
    vec3 direction = eyeDirection(vec2(float(pixel.x) + offset.x, float(pixel.y) + offset.y));
    if (castLook() == kCastMatter) return castMatter(direction, offset.z, rounds);
    return castValues(direction, rounds);
}
