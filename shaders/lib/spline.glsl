// Values and gradients between voxels by the splines of medium.glsl, for cast rays.
//
// Needs only cell_walk.glsl and medium.glsl.

// The 4 x 4 x 4 voxels around a cell, in the walk's coordinates: 16 rows along x, ordered by y, then by z.
struct SplineCell {
    vec4 rows[16];
};

struct SplinePoint {
    float value;
    vec3 slope;  // per voxel, in the walk's coordinates
};

SplineCell fetchSpline(CellWalk cells) {
    ivec3 last = params.volumeSize - ivec3(1);
    Blocks blocks = blocksAround(cells);
    ivec3 side = ivec3(cells.side);
    ivec3 first = ivec3(mirrored(cells, cells.cell - vec3(1.0)));
    ivec3 low = clamp(first, ivec3(0), last);
    int x1 = clamp(first.x + side.x, 0, last.x);
    int x2 = clamp(first.x + 2 * side.x, 0, last.x);
    int x3 = clamp(first.x + 3 * side.x, 0, last.x);
    SplineCell spline;
    for (int row = 0; row < 16; ++row) {
        int y = clamp(first.y + (row & 3) * side.y, 0, last.y);
        int z = clamp(first.z + (row >> 2) * side.z, 0, last.z);
        spline.rows[row] = vec4(fetchFrom(blocks, ivec3(low.x, y, z)), fetchFrom(blocks, ivec3(x1, y, z)),
                                fetchFrom(blocks, ivec3(x2, y, z)), fetchFrom(blocks, ivec3(x3, y, z)));
    }
    return spline;
}

// The derivatives of splineWeights().
vec4 splineSlopes(float t) {
    float u = float(1.0) - t;
    vec4 soft = vec4(-u * u, t * (float(3.0) * t - float(4.0)), u * (float(4.0) - float(3.0) * u), t * t) *
                float(0.5);
    if (useSmooth()) return soft;
    vec4 through = vec4(u * (float(3.0) * t - float(1.0)), t * (float(9.0) * t - float(10.0)),
                        u * (float(10.0) - float(9.0) * u), t * (float(3.0) * t - float(2.0))) *
                   float(0.5);
    return through + (soft - through) * float(1.0 / 3.0);
}

// Value and slope at a position in the cell, 0 to 1 along each axis.
SplinePoint splineAt(SplineCell spline, vec3 fraction) {
    vec4 x = splineWeights(fraction.x);
    vec4 y = splineWeights(fraction.y);
    vec4 z = splineWeights(fraction.z);
    vec4 alongX = splineSlopes(fraction.x);
    vec4 alongY = splineSlopes(fraction.y);
    vec4 alongZ = splineSlopes(fraction.z);
    // For each layer along z.
    vec4 values = vec4(0.0);
    vec4 slopesX = vec4(0.0);
    vec4 slopesY = vec4(0.0);
    for (int layer = 0; layer < 4; ++layer) {
        vec4 a = spline.rows[4 * layer];
        vec4 b = spline.rows[4 * layer + 1];
        vec4 c = spline.rows[4 * layer + 2];
        vec4 d = spline.rows[4 * layer + 3];
        vec4 row = vec4(splined(a, x), splined(b, x), splined(c, x), splined(d, x));
        values[layer] = splined(row, y);
        slopesY[layer] = dot(row, alongY);
        slopesX[layer] = dot(vec4(dot(a, alongX), dot(b, alongX), dot(c, alongX), dot(d, alongX)), y);
    }
    SplinePoint point;
    point.value = splined(values, z);
    point.slope = vec3(dot(slopesX, z), dot(slopesY, z), dot(values, alongZ));
    return point;
}

// The course along the ray through a cell: the value as the polynomial with the spline's values at both ends
// and in the middle, and its slopes at both ends; the gradient as the parabola through the same three points.
struct SplineCourse {
    Course value;
    float least;  // range of the voxels, to which values of the polynomial are clamped
    float most;
    vec3 gradient;  // per voxel, in the walk's coordinates, where the ray enters
    vec3 gradientLinear;
    vec3 gradientSquare;
};

SplineCourse splineCourse(CellWalk cells) {
    SplineCell spline = fetchSpline(cells);
    vec3 entry = fractionIn(cells, float(0.0));
    vec3 exit = fractionIn(cells, float(1.0));
    SplinePoint a = splineAt(spline, entry);
    SplinePoint b = splineAt(spline, (entry + exit) * float(0.5));
    SplinePoint c = splineAt(spline, exit);
    float begins = dot(a.slope, exit - entry);
    float ends = dot(c.slope, exit - entry);
    // The value minus its tangent at the start: in the middle and at the end; and the slope of this
    // difference at the end.
    float middle = b.value - a.value - float(0.5) * begins;
    float end = c.value - a.value - begins;
    float steeper = ends - begins;
    float fourth = float(16.0) * middle - float(8.0) * end + float(2.0) * steeper;
    SplineCourse course;
    vec4 least = spline.rows[0];
    vec4 most = spline.rows[0];
    for (int row = 1; row < 16; ++row) {
        least = min(least, spline.rows[row]);
        most = max(most, spline.rows[row]);
    }
    course.least = min(min(least.x, least.y), min(least.z, least.w));
    course.most = max(max(most.x, most.y), max(most.z, most.w));
    course.value.start = a.value;
    course.value.slopes =
        vec4(begins, float(3.0) * end - steeper + fourth, steeper - float(2.0) * (end + fourth), fourth);
    course.gradient = a.slope;
    course.gradientLinear = float(4.0) * b.slope - float(3.0) * a.slope - c.slope;
    course.gradientSquare = float(2.0) * (a.slope + c.slope) - float(4.0) * b.slope;
    return course;
}

vec3 gradientOn(CellWalk cells, SplineCourse course, float part) {
    return worldGradient((course.gradient + part * (course.gradientLinear + part * course.gradientSquare)) *
                         cells.side);
}
