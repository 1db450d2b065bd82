// A picture that was traced from one eye, seen from another: inverse warping along epipolar lines.
//
// The depths of the picture are a height field. Each pixel's ray is followed from where it enters the ball around all that
// can be seen to where it leaves it; its image in the picture before is a straight line. The first point behind the height
// field is where the ray meets what was seen. Where the field steps back there, the ray has gone behind something: nothing
// is known of what lies there, and the weight is 0. A ray that stays in front all along sees nothing, which is known too.
//
// Needs from its host: `reproject` (ReprojectPush), fetchLight (premultiplied, linear) and fetchSurface (distance from the eye
// before in mm, negative where there is none; its uncertainty in mm), both by index of a pixel of the picture before; and
// fetchExpected, by index of a pixel of the picture that is made: the depth in mm, along the middle of the view, at which
// splats show something there, negative where they do not tell.

// Steps along an epipolar line, a pixel each where that is enough, and halvings of the last one.
#define MOST_STEPS 32
#define HALVINGS 4
// A depth is met when the ray passes within so many footprints of a pixel: a surface of which the eye sees 1 in 4.
#define MET_FOOTPRINTS 4.0
// The part of a distance by which splats may be wrong about it: no surface is sought beyond that.
#define EXPECTED_WITHIN 0.1
// Pixels by which a place may be wrong, for the uncertainty of its depth: from full weight to none.
#define SURE_PX 0.75
#define UNSURE_PX 3.0

struct Reprojected {
    vec4 light;    // premultiplied, linear
    float weight;  // 0: not known, to 1
};

// Where the direction `v` (any length) meets the picture before, in pixels. False behind its eye.
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

// 1 up to `low`, 0 from `high` on, with a derivative that has no step.
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

// What the four pixels around `place` show of what lies at `distanceMm` from the eye before; negative: of nothing. The part
// of them that agrees is the weight. `placesPerMm`: how far along its line the place moves for each mm of depth; a depth that
// is off by less than half a pixel of that agrees, however far that is.
Reprojected gathered(vec2 place, float distanceMm, float footprintMm, float placesPerMm) {
    float toleranceMm = max(float(MET_FOOTPRINTS) * footprintMm, float(0.5) / max(placesPerMm, float(1e-20)));
    vec2 low = floor(place - vec2(0.5));
    vec2 f = place - vec2(0.5) - low;
    vec4 light = vec4(0.0);
    float agreed = float(0.0);
    float offPx = float(0.0);
    for (int i = 0; i < 4; ++i) {
        int index = indexBefore(ivec2(low) + ivec2(i & 1, i >> 1));
        vec2 surface = vec2(fetchSurface(index));
        float share = ((i & 1) == 0 ? float(1.0) - f.x : f.x) * ((i >> 1) == 0 ? float(1.0) - f.y : f.y);
        float off = abs(surface.x - distanceMm) / toleranceMm;
        float agrees = distanceMm < float(0.0) ? (surface.x < float(0.0) ? float(1.0) : float(0.0))
                       : surface.x < float(0.0) ? float(0.0) : fallingFrom(float(1.0), float(2.0), off);
        light += fetchLight(index) * (share * agrees);
        offPx += surface.y * placesPerMm * (share * agrees);
        agreed += share * agrees;
    }
    Reprojected result;
    result.light = light / max(agreed, float(1e-6));
    result.weight = agreed * fallingFrom(float(SURE_PX), float(UNSURE_PX), offPx / max(agreed, float(1e-6)));
    return result;
}

// Of a pixel of the picture that is made.
Reprojected reprojectedAt(ivec2 pixel) {
    Reprojected unknown;
    unknown.light = vec4(0.0);
    unknown.weight = float(0.0);
    vec2 p = vec2(float(2 * pixel.x + 1) / float(reproject.size.x) - float(1.0),
                  float(1.0) - float(2 * pixel.y + 1) / float(reproject.size.y));
    vec3 ray = normalize(reproject.forward + reproject.right * p.x + reproject.up * p.y);

    // The ball, seen from the eye. What misses it is taken where it passes.
    float along = dot(reproject.middleMm, ray);
    float inside2 = reproject.radiusMm * reproject.radiusMm - dot(reproject.middleMm, reproject.middleMm) + along * along;
    float halfMm = sqrt(max(inside2, float(0.0)));
    float leastMm = float(1e-3) * reproject.radiusMm;
    float nearMm = max(along - halfMm, leastMm);
    float farMm = along + halfMm;
    float expectedMm = fetchExpected(pixel.y * reproject.size.x + pixel.x) / max(dot(ray, reproject.forward), float(1e-3));
    if (expectedMm > float(0.0)) {
        nearMm = max(nearMm, expectedMm * float(1.0 - EXPECTED_WITHIN));
        farMm = min(farMm, expectedMm * float(1.0 + EXPECTED_WITHIN));
    }
    farMm = max(farMm, float(1.001) * nearMm);

    // A point at distance s lies, from the eye before, in the direction ray + ours / s: its image moves evenly with 1 / s
    // as long as the eye has not moved far along the ray.
    float nearest = float(1.0) / nearMm;
    float farthest = float(1.0) / farMm;
    vec2 first;
    vec2 last;
    bool begins = placeBefore(ray + reproject.oursMm * nearest, first);
    bool ends = placeBefore(ray + reproject.oursMm * farthest, last);
    if (!begins || !ends) return unknown;
    vec2 across = last - first;
    float lengthPx = sqrt(dot(across, across));
    int steps = int(clamp(ceil(lengthPx), float(1.0), float(MOST_STEPS)));
    float perStep = (farthest - nearest) / float(steps);

    // What is nearer to the eye than where the line enters the picture is not known; it is taken for empty, as it mostly is.
    int crossed = -1;  // the first step behind the height field
    for (int i = 0; i <= steps && crossed < 0; ++i) {
        float nearness = nearest + perStep * float(i);
        vec3 v = ray + reproject.oursMm * nearness;
        vec2 place;
        if (placeBefore(v, place) && isBefore(place)) {
            float depthMm = vec2(fetchSurface(indexBefore(ivec2(floor(place))))).x;
            if (depthMm >= float(0.0) && sqrt(dot(v, v)) / nearness >= depthMm) crossed = i;
        }
    }

    float placesPerMm = lengthPx / max(nearest - farthest, float(1e-30));
    float pixelAngle = float(2.0) * sqrt(dot(reproject.beforeUp, reproject.beforeUp)) / float(reproject.beforeSize.y);
    if (crossed < 0) {
        if (!isBefore(last)) return unknown;
        float nearness = float(1.0) / max(along, nearMm);
        vec2 place;
        if (!placeBefore(ray + reproject.oursMm * nearness, place) || !isBefore(place)) return unknown;
        Reprojected nothing = gathered(place, float(-1.0), float(1.0), placesPerMm * nearness * nearness);
        nothing.weight *= insideEdges(place);
        return nothing;
    }

    float front = nearest + perStep * float(max(crossed - 1, 0));
    float behind = nearest + perStep * float(crossed);
    for (int i = 0; i < HALVINGS; ++i) {
        float nearness = float(0.5) * (front + behind);
        vec3 v = ray + reproject.oursMm * nearness;
        vec2 place;
        placeBefore(v, place);
        float depthMm = vec2(fetchSurface(indexBefore(ivec2(floor(place))))).x;
        if (depthMm >= float(0.0) && sqrt(dot(v, v)) / nearness >= depthMm)
            behind = nearness;
        else
            front = nearness;
    }
    vec3 v = ray + reproject.oursMm * behind;
    vec2 place;
    placeBefore(v, place);
    float reachedMm = sqrt(dot(v, v)) / behind;
    // Where the eye has not moved the line is a point, and every depth on it is right.
    float ownMm = vec2(fetchSurface(indexBefore(ivec2(floor(place))))).x;
    if (lengthPx < float(0.5) && ownMm >= float(0.0)) reachedMm = ownMm;
    Reprojected met = gathered(place, reachedMm, reachedMm * pixelAngle, placesPerMm * behind * behind);
    met.weight *= insideEdges(place);
    return met;
}
