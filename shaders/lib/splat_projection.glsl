// Projects a Gaussian in space to one in the picture: EWA splatting (Zwicker et al. 2001). The perspective
// map is replaced by its linear part at the centre, J, so that the covariance in the picture is J S J^T + s
// I, s the low-pass; opacity is lowered by sqrt(det(J S J^T) / det(J S J^T + s I)), so that a splat smaller
// than a pixel keeps its sum over pixels (Mip-Splatting, Yu et al. 2024).
//
// The low-pass is widest, lowPassPx2, for splats thinner than a pixel: then sums over pixels hardly depend on
// the position within a pixel. Thicker splats need less; with more, surfaces seen edge-on would lose opacity
// that models of opaque matter need. With m the smaller variance of J S J^T it is s(m) = least + room max(1 -
// m / (2 room), 0)^2, where room = lowPassPx2 - least: m + s(m) begins at lowPassPx2, never falls and has no
// kink. The least, 1/12 px^2, is the variance of a pixel's area, which blurs a traced picture as well.
//
// For a centre far outside the picture J grows with the tangent of its angle, and the splat would smear over
// the whole picture. So J is taken at the centre's direction, clamped to the picture widened by 0.15 of its
// size on each side (1.3 times the tangent of half the field of view, as 3DGS does). The mean is not clamped.
// This is continuous; beyond the border the derivative of the clamped coordinate with respect to position is
// 0 (splat_projection_backward.glsl).
//
// With parallel rays the map is linear: J is just the scale of the picture, the same everywhere, and the
// projected splat is exact. `slope` is then x and y in mm, and nothing is clamped.
//
// Determinants are computed as sums of squares. The area A = sqrt(det(J S J^T)) is the length of the cross
// product of J's rows, scaled to the splat's axes, and that cross product has a closed form: so a disc seen
// edge-on and a needle lose no digits.
//
// Needs splat_types.glsl, splat_shape.glsl, finite.glsl.

// Intermediate results that the projection and its derivative share.
struct SplatSight {
    vec3 inCamera;      // mm; along x, y, z of the camera
    vec2 slope;         // x/z, y/z; with parallel rays x, y in mm
    vec2 slopeClamped;  // where J is taken
    vec3 rowX;          // J's rows in world axes: px per mm
    vec3 rowY;
    vec3 normal;  // their cross product: px^2 per mm^2
    SplatAxes axes;
    vec3 deviations;  // mm
    vec3 spreadX;     // px, of the splat's three deviations along x
    vec3 spreadY;
    vec3 areas;   // px^2 of pairs of deviations: (y, z), (z, x), (x, y)
    float area;   // A, px^2
    float major;  // px^2, the larger and the smaller variance before the low-pass
    float minor;
    float lowPass;  // px^2
    float xx;       // px^2, the covariance with the low-pass
    float xy;
    float yy;
    float height;  // det / yy
};

// A factor for a vector and its length before one is divided by the other, which keeps divisors below 2^126:
// beyond it graphics cards may return 0 (Vulkan, "Precision of core SPIR-V Instructions").
float scaleFor(float size) {
    return mix(float(1.0), float(7.888609052210118e-31), size > float(1e30));  // 2^-100
}

// v / z, for any z above 0.
vec2 overDepth(vec2 v, float z) {
    float scale = scaleFor(z);
    return v * scale / (z * scale);
}

float lengthOf(vec3 v) {
    float most = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = scaleFor(most);
    vec3 scaled = v * scale / (most * scale);
    return mix(float(0.0), most * sqrt(dot(scaled, scaled)), most > float(1e-30));
}

vec3 inCamera(vec3 position, SplatView view) {
    vec3 fromEye = position - view.eyeMm;
    return vec3(dot(view.right, fromEye), dot(view.down, fromEye), dot(view.forward, fromEye));
}

float lowPassOf(float minor, SplatView view) {
    float room = view.lowPassPx2 - view.lowPassLeastPx2;
    if (!(room > float(0.0))) return view.lowPassPx2;
    float share = max(float(1.0) - minor / (float(2.0) * room), float(0.0));
    return view.lowPassLeastPx2 + room * share * share;
}

// The derivative of lowPassOf with respect to `minor`.
float lowPassSlope(float minor, SplatView view) {
    float room = view.lowPassPx2 - view.lowPassLeastPx2;
    if (!(room > float(0.0))) return float(0.0);
    return -max(float(1.0) - minor / (float(2.0) * room), float(0.0));
}

// The projection of a splat in front of the eye. For others the numbers have no meaning.
SplatSight sightOf(Splat splat, SplatView view) {
    SplatSight sight;
    sight.inCamera = inCamera(splat.position, view);
    float z = sight.inCamera.z;
    sight.slope = vec2(sight.inCamera.x, sight.inCamera.y);
    sight.slopeClamped = sight.slope;
    vec2 scale = view.focalPx;
    if (view.parallel != 0) {
        sight.rowX = view.right * scale.x;
        sight.rowY = view.down * scale.y;
        sight.normal = view.forward * (scale.x * scale.y);
    } else {
        sight.slope = overDepth(sight.slope, z);
        sight.slopeClamped = clamp(sight.slope, view.lowestSlope, view.highestSlope);
        scale = overDepth(scale, z);
        sight.rowX = (view.right - view.forward * sight.slopeClamped.x) * scale.x;
        sight.rowY = (view.down - view.forward * sight.slopeClamped.y) * scale.y;
        sight.normal = (view.forward + view.right * sight.slopeClamped.x + view.down * sight.slopeClamped.y) *
                       (scale.x * scale.y);
    }

    sight.axes = axesOf(unitQuaternion(splat.rotation));
    sight.deviations = deviationsMm(splat.logScale);
    vec3 d = sight.deviations;
    sight.spreadX = alongAxes(sight.axes, sight.rowX) * d;
    sight.spreadY = alongAxes(sight.axes, sight.rowY) * d;
    sight.areas = alongAxes(sight.axes, sight.normal) * vec3(d.y * d.z, d.z * d.x, d.x * d.y);
    sight.area = lengthOf(sight.areas);

    float xx = dot(sight.spreadX, sight.spreadX);
    float yy = dot(sight.spreadY, sight.spreadY);
    sight.xy = dot(sight.spreadX, sight.spreadY);
    sight.major = float(0.5) * (xx + yy) + lengthOf(vec3(float(0.5) * (xx - yy), sight.xy, float(0.0)));
    sight.minor = mix(float(0.0), sight.area * (sight.area / sight.major), sight.major > float(0.0));
    float s = lowPassOf(sight.minor, view);
    sight.lowPass = s;
    sight.xx = xx + s;
    sight.yy = yy + s;
    // det = A^2 + s (xx + yy) + s^2. In this order it does not overflow.
    sight.height = sight.area * (sight.area / sight.yy) + s * ((xx + sight.yy) / sight.yy);
    return sight;
}

// The factor on opacity that compensates for the low-pass.
float compensationOf(SplatSight sight, SplatView view) {
    if (view.compensated == 0) return float(1.0);
    return min(sight.area / (sqrt(sight.height) * sqrt(sight.yy)), float(1.0));
}

ScreenSplat noSplat() {
    ScreenSplat none;
    none.mean = vec2(float(0.0));
    none.conic = vec3(float(1.0), float(0.0), float(1.0));
    none.opacity = float(0.0);
    none.depthMm = float(0.0);
    none.extent = vec2(float(0.0));
    return none;
}

// Opacity 0 for a splat with numbers that are not finite, in front of the near plane, too faint, or without a
// pixel centre in reach.
ScreenSplat projectSplat(Splat splat, SplatView view) {
    bool known = isFinite(vec4(splat.position, splat.opacityLogit)) &&
                 isFinite(vec4(splat.logScale, float(0.0))) && isFinite(splat.rotation);
    SplatSight sight = sightOf(splat, view);
    float z = sight.inCamera.z;
    float opacity = opacityOf(splat.opacityLogit) * compensationOf(sight, view);
    vec2 mean = sight.slope * view.focalPx + view.principalPx;

    // A little too large, to allow for rounding here and where alpha is computed.
    float reach = sqrt(float(2.0) * log(opacity / view.minAlpha)) * float(1.0001) + float(0.001);
    vec2 extent = vec2(sqrt(sight.xx), sqrt(sight.yy)) * reach;
    vec2 last = vec2(view.sizePx) - vec2(float(0.5));
    bool shows = known && z >= view.nearMm && opacity > view.minAlpha && mean.x + extent.x >= float(0.5) &&
                 mean.y + extent.y >= float(0.5) && mean.x - extent.x <= last.x &&
                 mean.y - extent.y <= last.y;
    vec3 conic = vec3(float(1.0) / sight.height, -sight.xy / sight.yy, float(1.0) / sight.yy);

    ScreenSplat screen = noSplat();
    screen.mean = mix(screen.mean, mean, bvec2(shows));
    screen.conic = mix(screen.conic, conic, bvec3(shows));
    screen.opacity = mix(screen.opacity, opacity, shows);
    screen.depthMm = mix(screen.depthMm, z, shows);
    screen.extent = mix(screen.extent, extent, bvec2(shows));
    return screen;
}
