// A picture that was traced from one eye, seen from another: inverse warping along epipolar lines.
//
// The depths of the traced picture are a height field. Each pixel's ray is followed through the ball around
// all visible matter; its image in the traced picture is a straight line. At its first point behind the
// height field the ray meets a surface. If the field has a step in depth there, the ray has passed behind
// something: the picture does not show what lies there, and the weight is 0. A ray that stays in front all
// along sees nothing, which is known too.
//
// Needs from its host: `reproject` (ReprojectPush), fetchLight (premultiplied, linear) and fetchSurface
// (distance from the previous eye in mm, negative where there is none; its uncertainty in mm) and fetchTrust
// (trust.glsl), all by index of a pixel of the traced picture; and fetchExpected, by index of a pixel of the
// new picture: the depth in mm, along the view's axis, at which splats show something there, negative where
// they have no depth.

// The most steps along an epipolar line, one for each pixel if that is enough, and bisections of the last
// step.
#define MOST_STEPS 24
#define HALVINGS 4
// A ray meets a depth if it passes within so many footprints of a pixel: enough for a surface so oblique that
// its depth changes by four footprints from pixel to pixel.
#define MET_FOOTPRINTS 4.0
// The relative error of the depth of splats, within which a surface is searched first. Where splats blend
// several layers, the surface may be anywhere on the ray.
#define EXPECTED_WITHIN 0.06
// The error of a position in pixels, from the uncertainty of its depth, at which the weight begins to fall,
// and at which it is 0.
#define SURE_PX 0.75
#define UNSURE_PX 3.0

struct Reprojected {
    vec4 light;    // premultiplied, linear
    float weight;  // 0 (unknown) to 1
    float trust;   // in `light`, 0 to 1 (trust.glsl)
};

// The position in the traced picture, in pixels, of the direction `v` (any length). False behind its eye.
bool placeBefore(vec3 v, OUT(vec2) place) {
    place = vec2(0.0);
    float along = dot(v, reproject.beforeForward);
    if (!(along > float(0.0)) || !(along * along > float(1e-4) * dot(v, v))) return false;
    float x = dot(v, reproject.beforeRight) / (along * dot(reproject.beforeRight, reproject.beforeRight));
    float y = dot(v, reproject.beforeUp) / (along * dot(reproject.beforeUp, reproject.beforeUp));
    place = vec2((float(0.5) + float(0.5) * x) * float(reproject.beforeSize.x),
                 (float(0.5) - float(0.5) * y) * float(reproject.beforeSize.y));
    return true;
}

bool isBefore(vec2 place) {
    return place.x >= float(0.0) && place.y >= float(0.0) && place.x < float(reproject.beforeSize.x) &&
           place.y < float(reproject.beforeSize.y);
}

int indexBefore(ivec2 pixel) {
    ivec2 inside = clamp(pixel, ivec2(0), reproject.beforeSize - ivec2(1));
    return inside.y * reproject.beforeSize.x + inside.x;
}

// 1 up to `low`, 0 from `high` on, with a continuous derivative.
float fallingFrom(float low, float high, float x) {
    float t = clamp((x - low) / (high - low), float(0.0), float(1.0));
    return float(1.0) - t * t * (float(3.0) - float(2.0) * t);
}

float insideEdges(vec2 place) {
    if (!(reproject.edgeFade > float(0.0))) return float(1.0);
    float x = place.x / float(reproject.beforeSize.x);
    float y = place.y / float(reproject.beforeSize.y);
    return fallingFrom(float(0.0), reproject.edgeFade, reproject.edgeFade - min(x, float(1.0) - x)) *
           fallingFrom(float(0.0), reproject.edgeFade, reproject.edgeFade - min(y, float(1.0) - y));
}

// The light of those of the four pixels around `place` that show a surface at `distanceMm` from the previous
// eye, or nothing if it is negative. Their share is the weight. `placesPerMm` is the movement of the position
// along its line, in pixels, for each mm of depth; a depth whose error moves it by less than half a pixel
// always agrees.
Reprojected gathered(vec2 place, float distanceMm, float footprintMm, float placesPerMm) {
    float toleranceMm = max(float(MET_FOOTPRINTS) * footprintMm, float(0.5) / max(placesPerMm, float(1e-20)));
    vec2 low = floor(place - vec2(0.5));
    vec2 f = place - vec2(0.5) - low;
    vec4 light = vec4(0.0);
    float agreed = float(0.0);
    float offPx = float(0.0);
    float trust = float(0.0);
    for (int i = 0; i < 4; ++i) {
        int index = indexBefore(ivec2(low) + ivec2(i & 1, i >> 1));
        vec2 surface = vec2(fetchSurface(index));
        float share = ((i & 1) == 0 ? float(1.0) - f.x : f.x) * ((i >> 1) == 0 ? float(1.0) - f.y : f.y);
        float off = abs(surface.x - distanceMm) / toleranceMm;
        float agrees = distanceMm < float(0.0)  ? (surface.x < float(0.0) ? float(1.0) : float(0.0))
                       : surface.x < float(0.0) ? float(0.0)
                                                : fallingFrom(float(1.0), float(2.0), off);
        light += fetchLight(index) * (share * agrees);
        offPx += surface.y * placesPerMm * (share * agrees);
        trust += fetchTrust(index) * (share * agrees);
        agreed += share * agrees;
    }
    Reprojected result;
    result.light = light / max(agreed, float(1e-6));
    result.trust = trust / max(agreed, float(1e-6));
    result.weight = agreed * fallingFrom(float(SURE_PX), float(UNSURE_PX), offPx / max(agreed, float(1e-6)));
    return result;
}

// The part of a pixel's ray on which something may be visible, from its nearest to its farthest point. Seen
// from the previous eye, a point at distance s lies in the direction ray + ours / s: its image moves evenly
// with the nearness 1 / s unless the eye has moved far along the ray.
struct EpipolarLine {
    vec3 ray;        // unit
    float nearest;   // 1/mm, of its beginning
    float farthest;  // 1/mm, of its end
    float middleMm;  // where it passes the middle of the ball around visible matter
    vec2 last;       // image of its end
    float lengthPx;  // length of its image
    bool isPart;     // it covers only the surroundings of the splats' depth
};

vec3 towardsAt(EpipolarLine line, float nearness) {
    return line.ray + reproject.oursMm * nearness;
}

// The whole line, or the part around the depth of splats if they have one. False if an end of it is behind
// the previous eye.
bool findLine(ivec2 pixel, bool isAll, OUT(EpipolarLine) line) {
    vec2 p = vec2(float(2 * pixel.x + 1) / float(reproject.size.x) - float(1.0),
                  float(1.0) - float(2 * pixel.y + 1) / float(reproject.size.y));
    line.ray = normalize(reproject.forward + reproject.right * p.x + reproject.up * p.y);
    // The ray's interval in the ball; for a ray that misses the ball, the point nearest to its middle.
    line.middleMm = dot(reproject.middleMm, line.ray);
    float inside2 = reproject.radiusMm * reproject.radiusMm - dot(reproject.middleMm, reproject.middleMm) +
                    line.middleMm * line.middleMm;
    float halfMm = sqrt(max(inside2, float(0.0)));
    float nearMm = max(line.middleMm - halfMm, float(1e-3) * reproject.radiusMm);
    float farMm = line.middleMm + halfMm;
    float expectedMm = fetchExpected(pixel.y * reproject.size.x + pixel.x) /
                       max(dot(line.ray, reproject.forward), float(1e-3));
    line.isPart = !isAll && expectedMm > float(0.0);
    if (line.isPart) {
        nearMm = max(nearMm, expectedMm * float(1.0 - EXPECTED_WITHIN));
        farMm = min(farMm, expectedMm * float(1.0 + EXPECTED_WITHIN));
    }
    line.nearest = float(1.0) / nearMm;
    line.farthest = float(1.0) / max(farMm, float(1.001) * nearMm);
    vec2 first;
    bool begins = placeBefore(towardsAt(line, line.nearest), first);
    bool ends = placeBefore(towardsAt(line, line.farthest), line.last);
    vec2 across = line.last - first;
    line.lengthPx = sqrt(dot(across, across));
    return begins && ends;
}

// Whether the point of the line is behind the height field; false where that is unknown.
bool isBehind(EpipolarLine line, float nearness) {
    vec3 towards = towardsAt(line, nearness);
    vec2 place;
    if (!placeBefore(towards, place) || !isBefore(place)) return false;
    float depthMm = vec2(fetchSurface(indexBefore(ivec2(floor(place))))).x;
    return depthMm >= float(0.0) && sqrt(dot(towards, towards)) / nearness >= depthMm;
}

// The nearest point of the line behind the height field, as a nearness; negative if the line stays in front.
// The part of the line outside the traced picture is unknown, and counts as empty, which it mostly is.
float firstBehind(EpipolarLine line) {
    int steps = int(clamp(ceil(line.lengthPx), float(1.0), float(MOST_STEPS)));
    float perStep = (line.farthest - line.nearest) / float(steps);
    int crossed = -1;
    for (int i = 0; i <= steps && crossed < 0; ++i) {
        if (isBehind(line, line.nearest + perStep * float(i))) crossed = i;
    }
    if (crossed < 0) return float(-1.0);
    float front = line.nearest + perStep * float(max(crossed - 1, 0));
    float behind = line.nearest + perStep * float(crossed);
    for (int i = 0; i < HALVINGS; ++i) {
        float middle = float(0.5) * (front + behind);
        bool isMiddleBehind = isBehind(line, middle);
        front = isMiddleBehind ? front : middle;
        behind = isMiddleBehind ? middle : behind;
    }
    return behind;
}

// The light of a pixel of the new picture.
Reprojected reprojectedAt(ivec2 pixel) {
    Reprojected unknown;
    unknown.light = vec4(0.0);
    unknown.weight = float(0.0);
    unknown.trust = float(0.0);
    EpipolarLine line;
    if (!findLine(pixel, false, line)) return unknown;
    float behind = firstBehind(line);
    // A partial line that begins behind the height field has missed the surface in front: searches the whole
    // line.
    if (line.isPart && (behind < float(0.0) || behind >= line.nearest)) {
        if (!findLine(pixel, true, line)) return unknown;
        behind = firstBehind(line);
    }
    bool meets = behind > float(0.0);
    // If the eye has not moved, the line is a point, and shows the traced pixel there at any depth.
    bool isPoint = !line.isPart && line.lengthPx < float(0.5);
    if (!meets && !isBefore(line.last)) return unknown;  // it may have met something outside that picture
    float nearness = meets ? behind : min(float(1.0) / max(line.middleMm, float(1e-20)), line.nearest);
    vec3 towards = towardsAt(line, nearness);
    vec2 place;
    if (!placeBefore(towards, place) || !isBefore(place)) return unknown;
    float reachedMm = sqrt(dot(towards, towards)) / nearness;
    float ownMm = vec2(fetchSurface(indexBefore(ivec2(floor(place))))).x;
    if (isPoint) meets = ownMm >= float(0.0);
    if (line.lengthPx < float(0.5) && ownMm >= float(0.0)) reachedMm = ownMm;
    float pixelAngle =
        float(2.0) * sqrt(dot(reproject.beforeUp, reproject.beforeUp)) / float(reproject.beforeSize.y);
    float placesPerMm = line.lengthPx / max(line.nearest - line.farthest, float(1e-30)) * nearness * nearness;
    Reprojected seen = gathered(place, meets ? reachedMm : float(-1.0), reachedMm * pixelAngle, placesPerMm);
    seen.weight *= insideEdges(place);
    return seen;
}
