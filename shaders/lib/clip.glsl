// Which parts of a ray the clip shows. A clip keeps one convex region and removes up to three others: the
// distances at which a ray enters and leaves them are computed once, when the ray starts. Voxel coordinates
// as in medium.glsl; distances in mm.
//
// Needs from its host: params.clip*, and useClip(), a constant.

// Below this a direction counts as parallel to a face: 1 mm of travel crosses less than 10^-12 bricks.
#define PARALLEL 1e-12

float safeInverse(float x) {
    return float(1.0) /
           (abs(x) > float(PARALLEL) ? x : (x < float(0.0) ? float(-PARALLEL) : float(PARALLEL)));
}

// A number for each shape that can be cut out: box, corner, ball.
#define CUTS vec3

struct ClipSpans {
    float from;    // the ray is shown from here
    float to;      // to here
    CUTS cutFrom;  // except for cuts that begin here
    CUTS cutTo;    // and end here; an empty cut ends before it begins
};

// Farther than any patient; neither its product with PARALLEL nor its square underflows or overflows.
#define FAR_MM 1e15

// The interval in which a ray is inside all half-spaces [first, first + count); empty if x > y. The border
// belongs to the inside.
vec2 spanOfPlanes(vec3 origin, vec3 direction, int first, int count) {
    vec2 span = vec2(float(-FAR_MM), float(FAR_MM));
    for (int i = first; i < first + count; ++i) {
        vec4 plane = params.clipPlanes[i];
        vec3 normal = vec3(plane.x, plane.y, plane.z);
        float slope = dot(normal, direction);
        float at =
            clamp(-(dot(normal, origin) + plane.w) * safeInverse(slope), float(-FAR_MM), float(FAR_MM));
        if (slope < float(0.0)) {
            span.y = min(span.y, at);
        } else {
            span.x = max(span.x, at);
        }
    }
    return span;
}

// The interval in which a ray is inside the ball, an ellipsoid in voxel coordinates.
vec2 spanOfBall(vec3 origin, vec3 direction) {
    vec3 o = origin - params.clipBallCentre;
    vec3 q = params.clipBallX * o.x + params.clipBallY * o.y + params.clipBallZ * o.z;
    vec3 d = params.clipBallX * direction.x + params.clipBallY * direction.y + params.clipBallZ * direction.z;
    float a = max(dot(d, d), float(1e-30));
    float nearest = -dot(q, d) / a;
    vec3 miss = q + d * nearest;  // from the centre; avoids the cancellation of the usual discriminant
    float room = (float(1.0) - dot(miss, miss)) / a;
    if (room <= float(0.0)) return vec2(float(FAR_MM), float(-FAR_MM));
    float reach = sqrt(room);
    return vec2(nearest - reach, nearest + reach);
}

ClipSpans nothingClipped() {
    return ClipSpans(float(-FAR_MM), float(FAR_MM), CUTS(float(FAR_MM)), CUTS(float(-FAR_MM)));
}

ClipSpans clipSpans(vec3 origin, vec3 direction) {
    ClipSpans spans = nothingClipped();
    if (!useClip()) return spans;
    vec2 keep = spanOfPlanes(origin, direction, 0, params.clipKeepCount);
    if (params.clipBall == kClipKeeps) {
        vec2 ball = spanOfBall(origin, direction);
        keep = vec2(max(keep.x, ball.x), min(keep.y, ball.y));
    }
    spans.from = keep.x;
    spans.to = keep.y;
    int first = params.clipKeepCount;
    if (params.clipBoxCount > 0) {
        vec2 cut = spanOfPlanes(origin, direction, first, params.clipBoxCount);
        spans.cutFrom.x = cut.x;
        spans.cutTo.x = cut.y;
    }
    first += params.clipBoxCount;
    if (params.clipCornerCount > 0) {
        vec2 cut = spanOfPlanes(origin, direction, first, params.clipCornerCount);
        spans.cutFrom.y = cut.x;
        spans.cutTo.y = cut.y;
    }
    if (params.clipBall == kClipCuts) {
        vec2 cut = spanOfBall(origin, direction);
        spans.cutFrom.z = cut.x;
        spans.cutTo.z = cut.y;
    }
    return spans;
}

// The end of the cut that contains this point; negative when none does.
float endOfCut(CUTS cutFrom, CUTS cutTo, float atMm) {
    float end = float(-1.0);
    if (cutFrom.x <= atMm && atMm < cutTo.x) end = max(end, cutTo.x);
    if (cutFrom.y <= atMm && atMm < cutTo.y) end = max(end, cutTo.y);
    if (cutFrom.z <= atMm && atMm < cutTo.z) end = max(end, cutTo.z);
    return end;
}

// Where the next cut after `afterMm` begins; `toMm` if none does before it.
float nextCut(CUTS cutFrom, CUTS cutTo, float afterMm, float toMm) {
    float at = toMm;
    if (cutFrom.x < cutTo.x && cutFrom.x > afterMm) at = min(at, cutFrom.x);
    if (cutFrom.y < cutTo.y && cutFrom.y > afterMm) at = min(at, cutFrom.y);
    if (cutFrom.z < cutTo.z && cutFrom.z > afterMm) at = min(at, cutFrom.z);
    return at;
}

// The next face of the clip after `afterMm` at which the ray passes from a removed part into a shown one;
// FAR_MM when there is none.
float nextFace(ClipSpans spans, float afterMm) {
    float face = float(FAR_MM);
    if (spans.from > afterMm && endOfCut(spans.cutFrom, spans.cutTo, spans.from) < float(0.0))
        face = spans.from;
    CUTS to = spans.cutTo;
    bool ofBox = spans.cutFrom.x < to.x && to.x > afterMm && to.x >= spans.from;
    bool ofCorner = spans.cutFrom.y < to.y && to.y > afterMm && to.y >= spans.from;
    bool ofBall = spans.cutFrom.z < to.z && to.z > afterMm && to.z >= spans.from;
    if (ofBox && endOfCut(spans.cutFrom, spans.cutTo, to.x) < float(0.0)) face = min(face, to.x);
    if (ofCorner && endOfCut(spans.cutFrom, spans.cutTo, to.y) < float(0.0)) face = min(face, to.y);
    if (ofBall && endOfCut(spans.cutFrom, spans.cutTo, to.z) < float(0.0)) face = min(face, to.z);
    return face < spans.to ? face : float(FAR_MM);
}
