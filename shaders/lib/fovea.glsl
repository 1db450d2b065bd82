// A picture that is stored larger where the eye looks. Both the picture as stored and the picture as seen lie
// in the plane at distance 1 from the eye, x to the right, y up, within the same rectangle. In every
// direction from the gaze, a point seen at distance q is stored at distance r:
//
//   q = r / m                                     up to the radius of the fovea
//   q = r / m + k (r - radius)^2                  beyond, k such that the border stays the border
//
// so that the scale changes without a step, and the inverse is a quadratic equation. The map of Kleinbeck et
// al. 2026 (1.7 of the reference) is similar, but linear in scale, with a step in its derivative at the
// radius.

struct Fovea {
    vec2 halfSize;        // of the rectangle
    vec2 gaze;            // inside the rectangle
    float radius;         // as stored; less than the distance from the gaze to the border
    float magnification;  // m, at least 1; 1 leaves the picture as it is
};

// The distance from the gaze to the border along a unit direction.
float borderDistance(Fovea fovea, vec2 direction) {
    float x =
        abs(direction.x) > float(1e-20)
            ? ((direction.x > float(0.0) ? fovea.halfSize.x : -fovea.halfSize.x) - fovea.gaze.x) / direction.x
            : float(1e20);
    float y =
        abs(direction.y) > float(1e-20)
            ? ((direction.y > float(0.0) ? fovea.halfSize.y : -fovea.halfSize.y) - fovea.gaze.y) / direction.y
            : float(1e20);
    return min(x, y);
}

// k in the equation above.
float foveaBend(Fovea fovea, float border) {
    float outside = border - fovea.radius;
    return border * (float(1.0) - float(1.0) / fovea.magnification) / (outside * outside);
}

vec2 seenFromStored(Fovea fovea, vec2 stored) {
    vec2 offset = stored - fovea.gaze;
    float r = sqrt(dot(offset, offset));
    float scale = float(1.0) / fovea.magnification;
    if (r > fovea.radius) {
        float beyond = r - fovea.radius;
        scale += foveaBend(fovea, borderDistance(fovea, offset / r)) * beyond * beyond / r;
    }
    return fovea.gaze + offset * scale;
}

vec2 storedFromSeen(Fovea fovea, vec2 seen) {
    vec2 offset = seen - fovea.gaze;
    float q = sqrt(dot(offset, offset));
    float inner = fovea.radius / fovea.magnification;
    if (q <= inner) return fovea.gaze + offset * fovea.magnification;
    float slope = float(1.0) / fovea.magnification;
    float beyond = q - inner;
    float bend = foveaBend(fovea, borderDistance(fovea, offset / q));
    // The positive root of bend s^2 + slope s = beyond, without cancellation.
    float s = float(2.0) * beyond / (slope + sqrt(slope * slope + float(4.0) * bend * beyond));
    return fovea.gaze + offset * ((fovea.radius + s) / q);
}

// The area of the picture as seen that a unit of area of the stored picture shows.
float seenArea(Fovea fovea, vec2 stored) {
    vec2 offset = stored - fovea.gaze;
    float r = sqrt(dot(offset, offset));
    float slope = float(1.0) / fovea.magnification;
    float scale = slope;
    if (r > fovea.radius) {
        float beyond = r - fovea.radius;
        float bend = foveaBend(fovea, borderDistance(fovea, offset / r));
        scale += bend * beyond * beyond / r;
        slope += float(2.0) * bend * beyond;
    }
    // In polar coordinates around the gaze the map leaves the angle alone, so its area is dq/dr times q/r.
    return slope * scale;
}

// The solid angle, in steradians, that a unit of area of the stored picture shows.
float seenSolidAngle(Fovea fovea, vec2 stored) {
    vec2 seen = seenFromStored(fovea, stored);
    float distance2 = float(1.0) + dot(seen, seen);
    return seenArea(fovea, stored) / (distance2 * sqrt(distance2));
}
