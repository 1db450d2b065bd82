// Colour by direction: real spherical harmonics, in the order and with the signs of 3DGS (Kerbl et al. 2023),
// those of quantum mechanics with the Condon-Shortley phase. A colour is max(0, 0.5 + the sum over bands):
// add the bands that a model has and pass the sum to visibleColour. Callers skip a splat whose sum is not
// finite. Directions are unit vectors from the eye to the splat, in world axes; with parallel rays all are
// the rays' direction.

#define SH_0 0.28209479177387814
#define SH_1 0.48860251190291992

vec3 directionTo(vec3 position, SplatView view) {
    if (view.parallel != 0) return view.forward;
    vec3 fromEye = position - view.eyeMm;
    float far = lengthOf(fromEye);
    float scale = scaleFor(far);
    return mix(vec3(float(0.0), float(0.0), float(1.0)), fromEye * scale / (far * scale),
               bvec3(far > float(0.0)));
}

vec3 colourOfBand0(vec3 dc) {
    return vec3(float(0.5)) + dc * float(SH_0);
}

vec3 colourOfBand1(vec3 d, vec3 s1, vec3 s2, vec3 s3) {
    return (s2 * d.z - s1 * d.y - s3 * d.x) * float(SH_1);
}

vec3 colourOfBand2(vec3 d, vec3 s4, vec3 s5, vec3 s6, vec3 s7, vec3 s8) {
    float xx = d.x * d.x;
    float yy = d.y * d.y;
    float zz = d.z * d.z;
    float a = float(1.09254843059207907);
    return s4 * (a * d.x * d.y) - s5 * (a * d.y * d.z) +
           s6 * (float(0.31539156525252001) * (float(2.0) * zz - xx - yy)) - s7 * (a * d.x * d.z) +
           s8 * (float(0.54627421529603954) * (xx - yy));
}

vec3 colourOfBand3(vec3 d, vec3 s9, vec3 s10, vec3 s11, vec3 s12, vec3 s13, vec3 s14, vec3 s15) {
    float xx = d.x * d.x;
    float yy = d.y * d.y;
    float zz = d.z * d.z;
    float three = float(3.0);
    float a = float(0.59004358992664351);
    float b = float(0.45704579946446573);
    float ring = float(4.0) * zz - xx - yy;
    return s10 * (float(2.89061144264055405) * d.x * d.y * d.z) - s9 * (a * d.y * (three * xx - yy)) -
           s11 * (b * d.y * ring) +
           s12 * (float(0.37317633259011540) * d.z * (float(2.0) * zz - three * (xx + yy))) -
           s13 * (b * d.x * ring) + s14 * (float(1.44530572132027702) * d.z * (xx - yy)) -
           s15 * (a * d.x * (xx - three * yy));
}

// The derivative of colourOfBand0 with respect to dc.
float band0Slope() {
    return float(SH_0);
}

vec3 visibleColour(vec3 sum) {
    return max(sum, vec3(float(0.0)));
}

// Turns the derivative of the loss with respect to the visible colour into that with respect to the sum of
// the bands: 0 where the sum was clamped.
vec3 sumGradient(vec3 sum, vec3 byColour) {
    return vec3(mix(float(0.0), byColour.x, sum.x > float(0.0)),
                mix(float(0.0), byColour.y, sum.y > float(0.0)),
                mix(float(0.0), byColour.z, sum.z > float(0.0)));
}

// The derivatives of the loss with respect to the coefficients s1, s2, s3.
struct Band1Gradient {
    vec3 s1;
    vec3 s2;
    vec3 s3;
};
Band1Gradient band1Gradient(vec3 d, vec3 bySum) {
    vec3 g = bySum * float(SH_1);
    Band1Gradient result;
    result.s1 = g * -d.y;
    result.s2 = g * d.z;
    result.s3 = g * -d.x;
    return result;
}

// The derivative of the loss with respect to the position, through the direction of view; for bands up to
// degree 1.
vec3 colourPositionGradient(vec3 position, SplatView view, vec3 s1, vec3 s2, vec3 s3, vec3 bySum) {
    if (view.parallel != 0) return vec3(float(0.0));
    vec3 fromEye = position - view.eyeMm;
    float far = lengthOf(fromEye);
    float scale = scaleFor(far);
    vec3 d = fromEye * scale / (far * scale);
    vec3 byDirection = vec3(-dot(s3, bySum), -dot(s1, bySum), dot(s2, bySum)) * float(SH_1);
    vec3 byPosition = (byDirection - d * dot(d, byDirection)) * scale / (far * scale);
    return mix(vec3(float(0.0)), byPosition, bvec3(far > float(0.0)));
}
