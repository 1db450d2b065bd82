// Scale, rotation and opacity of a splat from its trained parameters; and their derivatives.
//
// In this file, and in those about projection and colour, what differs from splat to splat has no ?: and no
// branch, but mix(a, b, condition), b where it is true: so that it is also C++ where float is a vector of
// several splats (base/vector_in_glsl.h).

// As Splats::kMaxLogScale: limit of a log scale, so that nothing below overflows.
#define MAX_LOG_SCALE 20.0
// A quaternion with no component above this counts as the identity, and gets no gradient.
#define MIN_QUATERNION 1e-12

// Columns: the splat's axes in the world.
struct SplatAxes {
    vec3 x;
    vec3 y;
    vec3 z;
};

vec3 deviationsMm(vec3 logScale) {
    float most = float(MAX_LOG_SCALE);
    return vec3(exp(clamp(logScale.x, -most, most)), exp(clamp(logScale.y, -most, most)),
                exp(clamp(logScale.z, -most, most)));
}

float gateOfLogScale(float logScale, float gradient) {
    return mix(gradient, float(0.0), abs(logScale) > float(MAX_LOG_SCALE));
}

float lengthOf(vec4 q) {
    float most = max(max(abs(q.x), abs(q.y)), max(abs(q.z), abs(q.w)));
    vec4 scaled = q / most;
    return mix(float(0.0), most * sqrt(dot(scaled, scaled)), most > float(MIN_QUATERNION));
}

vec4 unitQuaternion(vec4 q) {
    float most = max(max(abs(q.x), abs(q.y)), max(abs(q.z), abs(q.w)));
    bool isTurn = most > float(MIN_QUATERNION);
    vec4 scaled = q / most;
    scaled = vec4(mix(float(1.0), scaled.x, isTurn), mix(float(0.0), scaled.y, isTurn),
                  mix(float(0.0), scaled.z, isTurn), mix(float(0.0), scaled.w, isTurn));
    return scaled / sqrt(dot(scaled, scaled));
}

SplatAxes axesOf(vec4 unit) {
    float w = unit.x;
    float x = unit.y;
    float y = unit.z;
    float z = unit.w;
    float two = float(2.0);
    float one = float(1.0);
    SplatAxes axes;
    axes.x = vec3(one - two * (y * y + z * z), two * (x * y + w * z), two * (x * z - w * y));
    axes.y = vec3(two * (x * y - w * z), one - two * (x * x + z * z), two * (y * z + w * x));
    axes.z = vec3(two * (x * z + w * y), two * (y * z - w * x), one - two * (x * x + y * y));
    return axes;
}

// A world vector's components along the splat's axes, and back.
vec3 alongAxes(SplatAxes axes, vec3 world) {
    return vec3(dot(axes.x, world), dot(axes.y, world), dot(axes.z, world));
}
vec3 fromAxes(SplatAxes axes, vec3 along) {
    return axes.x * along.x + axes.y * along.y + axes.z * along.z;
}

// The derivative with respect to the stored quaternion, from that with respect to the axes.
vec4 quaternionGradient(vec4 q, SplatAxes g) {
    float norm = lengthOf(q);
    vec4 unit = unitQuaternion(q);
    float w = unit.x;
    float x = unit.y;
    float y = unit.z;
    float z = unit.w;
    float two = float(2.0);
    vec4 byUnit =
        vec4(z * (g.x.y - g.y.x) + y * (g.z.x - g.x.z) + x * (g.y.z - g.z.y),
             y * (g.x.y + g.y.x) + z * (g.x.z + g.z.x) + w * (g.y.z - g.z.y) - two * x * (g.y.y + g.z.z),
             x * (g.x.y + g.y.x) + z * (g.y.z + g.z.y) + w * (g.z.x - g.x.z) - two * y * (g.x.x + g.z.z),
             x * (g.x.z + g.z.x) + y * (g.y.z + g.z.y) + w * (g.x.y - g.y.x) - two * z * (g.x.x + g.y.y));
    byUnit = byUnit * two;
    bool isTurn = norm > float(0.0);
    vec4 byStored = (byUnit - unit * dot(unit, byUnit)) / norm;
    return vec4(mix(float(0.0), byStored.x, isTurn), mix(float(0.0), byStored.y, isTurn),
                mix(float(0.0), byStored.z, isTurn), mix(float(0.0), byStored.w, isTurn));
}

// 1 / (1 + exp(-logit)), and its derivative, without overflow or cancellation.
float opacityOf(float logit) {
    float e = exp(-abs(logit));
    return mix(float(1.0), e, logit < float(0.0)) / (float(1.0) + e);
}
float opacitySlope(float logit) {
    float e = exp(-abs(logit));
    return e / ((float(1.0) + e) * (float(1.0) + e));
}
