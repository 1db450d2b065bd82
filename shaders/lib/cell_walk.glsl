// The walk of a cast ray from cell to cell, where a cell lies between eight voxel centres.
//
// Needs, besides brick_walk.glsl and gradient.glsl: blocksOfBrick(brick) and fetchFrom(blocks, voxel) for the
// voxels of one brick; castLook(), useShading(), constants.

// A ray on its way through cells. Within a cell the interpolated value is one cubic along the ray.
// Neighbouring cells share four corners, so that only four are fetched. Beyond the outer voxel centres a cell
// has the same corner twice.
//
// The volume is mirrored along each axis on which the ray descends, so that in the walk's coordinates every
// ray ascends.
struct CellWalk {
    vec3 side;       // 1, or -1 along the axes that are mirrored
    vec3 shift;      // see mirrored()
    vec3 origin;     // in voxels, with integers at voxel centres
    vec3 direction;  // voxels per mm, none below 0
    vec3 inverse;
    vec3 cell;     // its low corner
    vec3 faceMm;   // where the ray meets the cell's high faces
    float fromMm;  // where it enters the cell
    float toMm;    // where the ray leaves the cell
    Corners corners;
    Blocks blocks;     // of the current brick
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
    cells.inverse =
        vec3(safeInverse(cells.direction.x), safeInverse(cells.direction.y), safeInverse(cells.direction.z));
    return cells;
}

// A corner's voxel, clamped to the brick: rounding may carry a cell across the brick's face.
ivec3 voxelOf(CellWalk cells, vec3 corner) {
    return clamp(ivec3(mirrored(cells, corner)), cells.firstVoxel, cells.lastVoxel);
}

void leaveCellAt(INOUT(CellWalk) cells, float endMm) {
    cells.faceMm = (cells.cell + vec3(1.0) - cells.origin) * cells.inverse;
    cells.toMm = min(max(min(min(cells.faceMm.x, cells.faceMm.y), cells.faceMm.z), cells.fromMm), endMm);
}

// The position within the cell, 0 to 1 along each axis, after this part of the ray's way through it.
vec3 fractionIn(CellWalk cells, float part) {
    float atMm = mix(cells.fromMm, cells.toMm, part);
    return clamp(cells.origin + cells.direction * atMm - cells.cell, vec3(0.0), vec3(1.0));
}

bool hasGradients() {
    return castLook() == kCastMatter && (useGradientOpacity() || useSteep() || useShading());
}

// Enters the first cell of a stretch in one brick. Returns the value at the entry.
float enterBrick(INOUT(CellWalk) cells, BrickWalk walk, float endMm) {
    ivec3 brick = clamp(ivec3(floor(walk.origin + walk.direction * (float(0.5) * (walk.distanceMm + endMm)))),
                        ivec3(0), params.gridSize - ivec3(1));
    cells.blocks = blocksOfBrick(brick);
    cells.firstVoxel = max(brick * BRICK - ivec3(1), ivec3(0));
    cells.lastVoxel = min(brick * BRICK + ivec3(BRICK - 1), params.volumeSize - ivec3(1));
    cells.fromMm = walk.distanceMm;
    cells.cell = floor(cells.origin + cells.direction * cells.fromMm);
    leaveCellAt(cells, endMm);
    ivec3 a = voxelOf(cells, cells.cell);
    ivec3 b = voxelOf(cells, cells.cell + vec3(1.0));
    cells.corners.near =
        vec4(fetchFrom(cells.blocks, a), fetchFrom(cells.blocks, ivec3(b.x, a.y, a.z)),
             fetchFrom(cells.blocks, ivec3(a.x, b.y, a.z)), fetchFrom(cells.blocks, ivec3(b.x, b.y, a.z)));
    cells.corners.far =
        vec4(fetchFrom(cells.blocks, ivec3(a.x, a.y, b.z)), fetchFrom(cells.blocks, ivec3(b.x, a.y, b.z)),
             fetchFrom(cells.blocks, ivec3(a.x, b.y, b.z)), fetchFrom(cells.blocks, b));
    return interpolated(cells.corners, fractionIn(cells, float(0.0)));
}

// The corners of the next cell along x, along y, or otherwise along z; `ahead` are its four new ones.
Corners movedOn(Corners c, vec4 ahead, bool x, bool y) {
    Corners next;
    next.fraction = vec3(0.0);
    next.near = vec4(x ? c.near.y : (y ? c.near.z : c.far.x), x ? ahead.x : (y ? c.near.w : c.far.y),
                     x ? c.near.w : (y ? ahead.x : c.far.z), x ? ahead.y : (y ? ahead.y : c.far.w));
    next.far = vec4(x ? c.far.y : (y ? c.far.z : ahead.x), x ? ahead.z : (y ? c.far.w : ahead.y),
                    x ? c.far.w : (y ? ahead.z : ahead.z), ahead.w);
    return next;
}

// Moves on through the face that the ray meets first; false at the end. Cells advance by index, so that
// rounding can neither stall the walk nor make it skip one.
bool nextCell(INOUT(CellWalk) cells, float endMm) {
    if (cells.toMm >= endMm) return false;
    bool x = cells.faceMm.x <= min(cells.faceMm.y, cells.faceMm.z);
    bool y = !x && cells.faceMm.y <= cells.faceMm.z;
    bool z = !x && !y;
    cells.cell += vec3(x ? float(1.0) : float(0.0), y ? float(1.0) : float(0.0), z ? float(1.0) : float(0.0));
    cells.fromMm = cells.toMm;
    leaveCellAt(cells, endMm);

    // The four corners on the far side: (low, low), (high, low), (low, high), (high, high) along the other
    // two axes.
    ivec3 a = voxelOf(cells, cells.cell);
    ivec3 b = voxelOf(cells, cells.cell + vec3(1.0));
    vec4 ahead =
        vec4(fetchFrom(cells.blocks, ivec3(x ? b.x : a.x, y ? b.y : a.y, z ? b.z : a.z)),
             fetchFrom(cells.blocks, ivec3(b.x, x || y ? b.y : a.y, z ? b.z : a.z)),
             fetchFrom(cells.blocks, ivec3(x ? b.x : a.x, x ? a.y : b.y, b.z)), fetchFrom(cells.blocks, b));
    cells.corners = movedOn(cells.corners, ahead, x, y);
    return true;
}

// The value along the ray through a cell: a polynomial in the part of the way, 0 to 1.
struct Course {
    float start;
    vec4 slopes;
};

float valueOf(Course c, float part) {
    return c.start + part * (c.slopes.x + part * (c.slopes.y + part * (c.slopes.z + part * c.slopes.w)));
}

// The course of the interpolated value, a cubic; `start` is the value where the ray enters.
Course courseIn(CellWalk cells, float start) {
    vec3 entry = fractionIn(cells, float(0.0));
    vec3 exit = fractionIn(cells, float(1.0));
    float toMiddle = interpolated(cells.corners, (entry + exit) * float(0.5)) - start;
    float toEnd = interpolated(cells.corners, exit) - start;
    vec3 across = exit - entry;
    vec4 d = cells.corners.far - cells.corners.near;
    float third = (d.x - d.y - d.z + d.w) * (across.x * across.y * across.z);
    Course c;
    c.start = start;
    c.slopes = vec4(float(4.0) * toMiddle - toEnd + float(0.5) * third,
                    float(2.0) * toEnd - float(4.0) * toMiddle - float(1.5) * third, third, float(0.0));
    return c;
}

// The position of a fraction of the cell, in voxel coordinates with integers at faces.
vec3 positionIn(CellWalk cells, vec3 fraction) {
    return mirrored(cells, cells.cell + fraction) + vec3(0.5);
}

// Central differences at the corners of a cell, per voxel: gradientAt() equals their interpolation.
struct CellGradient {
    Corners x;
    Corners y;
    Corners z;
};

// The values at a voxel near the cell and at the three next to it along u and v. `blocks` must cover them.
vec4 fetchFour(CellWalk cells, Blocks blocks, vec3 corner, vec3 u, vec3 v) {
    ivec3 last = params.volumeSize - ivec3(1);
    return vec4(fetchFrom(blocks, clamp(ivec3(mirrored(cells, corner)), ivec3(0), last)),
                fetchFrom(blocks, clamp(ivec3(mirrored(cells, corner + u)), ivec3(0), last)),
                fetchFrom(blocks, clamp(ivec3(mirrored(cells, corner + v)), ivec3(0), last)),
                fetchFrom(blocks, clamp(ivec3(mirrored(cells, corner + u + v)), ivec3(0), last)));
}

// The blocks of a cell and its adjacent voxels: four voxels along an axis lie in two blocks at most.
Blocks blocksAround(CellWalk cells) {
    vec3 end = max(mirrored(cells, cells.cell - vec3(1.0)), mirrored(cells, cells.cell + vec3(2.0)));
    return blocksOfBrick(clamp(ivec3(end), ivec3(0), params.volumeSize - ivec3(1)) >> 3);
}

// The gradients at all corners of the cell at once: a branch within the steps would save nothing where eight
// rays share a vector. The cell's own corners are fetched already.
CellGradient gradientOfCell(CellWalk cells) {
    vec3 x = vec3(float(1.0), float(0.0), float(0.0));
    vec3 y = vec3(float(0.0), float(1.0), float(0.0));
    vec3 z = vec3(float(0.0), float(0.0), float(1.0));
    Blocks blocks = blocksAround(cells);
    vec4 near = cells.corners.near;
    vec4 far = cells.corners.far;
    CellGradient gradient;
    vec4 before = fetchFour(cells, blocks, cells.cell - x, y, z);
    vec4 after = fetchFour(cells, blocks, cells.cell + x * float(2.0), y, z);
    gradient.x.near =
        vec4(near.y - before.x, after.x - near.x, near.w - before.y, after.y - near.z) * float(0.5);
    gradient.x.far = vec4(far.y - before.z, after.z - far.x, far.w - before.w, after.w - far.z) * float(0.5);
    before = fetchFour(cells, blocks, cells.cell - y, x, z);
    after = fetchFour(cells, blocks, cells.cell + y * float(2.0), x, z);
    gradient.y.near =
        vec4(near.z - before.x, near.w - before.y, after.x - near.x, after.y - near.y) * float(0.5);
    gradient.y.far = vec4(far.z - before.z, far.w - before.w, after.z - far.x, after.w - far.y) * float(0.5);
    gradient.z.near = (far - fetchFour(cells, blocks, cells.cell - z, x, y)) * float(0.5);
    gradient.z.far = (fetchFour(cells, blocks, cells.cell + z * float(2.0), x, y) - near) * float(0.5);
    return gradient;
}

vec3 gradientIn(CellWalk cells, CellGradient gradient, vec3 fraction) {
    return worldGradient(vec3(interpolated(gradient.x, fraction), interpolated(gradient.y, fraction),
                              interpolated(gradient.z, fraction)) *
                         cells.side);
}
