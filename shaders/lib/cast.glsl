// Ray casting: one deterministic march along each ray, by the walk of brick_walk.glsl. It skips what the clip
// removes.
//
// Needs, besides path.glsl, cell_walk.glsl and spline.glsl: params.windowLow and windowHigh, in table
// entries, params.entryCount, params.stepsPerEntry, params.ambient and params.diffuse.

// The most steps in one cell, and the most once a ray has taken MANY_ROUNDS, because lavapipe ends long
// loops.
#define CAST_STEPS 64
#define CAST_STEPS_LATE 4
#define MANY_ROUNDS 8000
// Below this transmittance a ray ends.
#define CAST_OPAQUE 0.00390625

// Moves on to the next stretch of the ray that the clip leaves in a brick with a bound above `least`:
// walk.distanceMm to toMm. On entry toMm is the end of the previous stretch, at first walk.distanceMm. False
// at the end.
bool nextPiece(INOUT(BrickWalk) walk, float least, INOUT(float) toMm, INOUT(int) rounds) {
    walk.distanceMm = toMm;
    do {
        rounds += 1;
        if (useClip()) {
            // One cut may end inside another.
            for (int i = 0; i < walk.cutFrom.length(); ++i)
                walk.distanceMm = max(walk.distanceMm, endOfCut(walk.cutFrom, walk.cutTo, walk.distanceMm));
        }
        if (walk.majorant > least && walk.distanceMm < walk.segmentEndMm) {
            toMm = walk.segmentEndMm;
            if (useClip()) toMm = nextCut(walk.cutFrom, walk.cutTo, walk.distanceMm, toMm);
            return true;
        }
        if (walk.distanceMm > walk.segmentEndMm) leap(walk, walk.distanceMm);
    } while (nextSegment(walk, rounds));
    return false;
}

// The factor of a headlight on a colour: ambient + diffuse |cos| of the angle between the ray and the
// gradient (Lambert, both sides alike). Where the gradient is 0 there is no surface: shaded as if it faced
// the light.
float headlight(vec3 gradient, vec3 worldDirection) {
    float length2 = dot(gradient, gradient);
    float cosine = length2 > float(0.0) ? abs(dot(gradient, worldDirection)) / sqrt(length2) : float(1.0);
    return params.ambient + params.diffuse * cosine;
}

// Albedo, and extinction per mm.
vec4 matterOfEntry(float entry) {
    int low = int(entry);
    vec4 matter = fetchMatter(low);
    return matter + (fetchMatter(low + 1) - matter) * (entry - float(low));
}
vec4 steepMatterOfEntry(float entry) {
    int low = int(entry);
    vec4 matter = fetchSteepMatter(low);
    return matter + (fetchSteepMatter(low + 1) - matter) * (entry - float(low));
}

// The steep part at each corner of a cell, from which it is interpolated, as for paths. A spline has its own
// gradient everywhere, and needs no corners.
Corners steepOfCell(CellWalk cells, CellGradient gradient) {
    Corners part;
    part.fraction = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        part.near[i] = steepPart(
            worldGradient(vec3(gradient.x.near[i], gradient.y.near[i], gradient.z.near[i]) * cells.side));
        part.far[i] = steepPart(
            worldGradient(vec3(gradient.x.far[i], gradient.y.far[i], gradient.z.far[i]) * cells.side));
    }
    return part;
}

// Mixes flat and steep matter, of which `part` is steep: extinction by parts, colour by shares of the
// extinction.
vec4 mixedMatter(vec4 usual, vec4 steep, float part) {
    float extinction = mix(usual.w, steep.w, part);
    float share = steep.w * part / max(extinction, float(1e-20));
    return vec4(mix(vec3(usual), vec3(steep), share), extinction);
}

// The steps through the cell that the second volume needs: for the change of its value under its transfer
// function, and two for each of its voxels that the ray crosses.
float secondSteps(CellWalk cells, float transmittance) {
    vec3 begin = inSecond(positionIn(cells, fractionIn(cells, float(0.0))));
    vec3 end = inSecond(positionIn(cells, fractionIn(cells, float(1.0))));
    float middle = secondEntry((begin + end) * float(0.5));
    float change = abs(middle - secondEntry(begin)) + abs(secondEntry(end) - middle);
    return max(change * params.secondStepsPerEntry * transmittance, float(2.0) * length(end - begin));
}

// Mixes emission and extinction of the second volume at `at` into those of the volume.
void addSecond(vec3 at, EyeRay eye, bool masked, INOUT(vec3) emitted, INOUT(float) extinction) {
    vec4 second = secondMatter(at);
    Mixture mixture = Mixture(extinction, masked ? float(0.0) : second.w);
    if (useShading()) second *= vec4(vec3(headlight(secondGradient(at), eye.direction)), float(1.0));
    emitted = mix(emitted, vec3(second), secondShareOf(mixture));
    extinction = totalOf(mixture);
}

// The light of a ray whose matter ends, before a grey face with the light `face` if that is above 0.
vec4 endOfMatter(vec3 colour, float transmittance, float face) {
    // Early termination: sets the remaining transmittance to 0, so that opaque matter is fully opaque.
    if (transmittance < float(CAST_OPAQUE)) return vec4(colour / (float(1.0) - transmittance), float(1.0));
    if (face > float(0.0)) return vec4(colour + vec3(transmittance * face), float(1.0));
    return vec4(colour, float(1.0) - transmittance);
}

// Emission and absorption: the integral over the ray of transmittance * extinction * colour, premultiplied,
// and one minus the transmittance. A cell is crossed in as many steps as the transfer function needs over its
// values, and fewer the less light is left. Exact where extinction and colour are constant over each step.
// `phase`, 0 to 1, is the position within a step at which values are sampled; the mean over all phases has no
// first-order bias.
vec4 castMatter(EyeRay eye, float phase, INOUT(int) rounds) {
    vec3 directionVoxel = voxelsPerMm(eye.direction);
    BrickWalk walk = startEyeWalk(eye.originVoxel, directionVoxel);
    CellWalk cells = startCells(eye.originVoxel, directionVoxel);
    float face = float(0.0);
    if (useClip() && params.greyFaces != 0) face = stopAtFace(walk, eye.originVoxel, directionVoxel);
    int least = hasGradients() || useSecond() || useTints() ? 2 : 1;  // these vary within a cell too
    vec3 colour = vec3(0.0);
    float transmittance = float(1.0);
    float toMm = walk.distanceMm;
    while (transmittance >= float(CAST_OPAQUE) && nextPiece(walk, float(0.0), toMm, rounds)) {
        float atEnd = enterBrick(cells, walk, toMm);
        do {
            rounds += 1;
            Course value;
            CellGradient gradients;
            Corners steepParts;
            SplineCourse spline;
            if (useSpline()) {
                spline = splineCourse(cells);
                value = spline.value;
            } else {
                value = courseIn(cells, atEnd);
                if (hasGradients()) gradients = gradientOfCell(cells);
                if (useSteep()) steepParts = steepOfCell(cells, gradients);
            }
            float middle = valueOf(value, float(0.5));
            atEnd = valueOf(value, float(1.0));
            float change = abs(middle - value.start) + abs(atEnd - middle);
            int most = rounds < MANY_ROUNDS ? CAST_STEPS : CAST_STEPS_LATE;
            float wanted = change * params.stepsPerEntry * transmittance;
            if (useSecond()) wanted = max(wanted, secondSteps(cells, transmittance));
            int steps = clamp(int(ceil(min(wanted, float(CAST_STEPS)))), least, most);
            float step = (cells.toMm - cells.fromMm) / float(steps);
            for (int i = 0; i < steps && transmittance >= float(CAST_OPAQUE); ++i) {
                rounds += 1;
                float part = (float(i) + phase) / float(steps);
                vec3 fraction = fractionIn(cells, part);
                float entry = max(valueOf(value, part), float(0.0));
                if (useSpline()) entry = clamp(entry, spline.least, spline.most);
                vec4 matter = matterOfEntry(entry);
                vec3 at = positionIn(cells, fraction);
                bool masked = isMasked(at);
                float shade = float(1.0);
                if (hasGradients()) {
                    vec3 gradient = useSpline() ? gradientOn(cells, spline, part)
                                                : gradientIn(cells, gradients, fraction);
                    if (useGradientOpacity()) matter.w = thinnedByGradient(matter.w, gradient);
                    if (useSteep()) {
                        vec4 steep = steepMatterOfEntry(entry);
                        if (useGradientOpacity()) steep.w = thinnedByGradient(steep.w, gradient);
                        matter = mixedMatter(
                            matter, steep,
                            useSpline() ? steepPart(gradient) : interpolated(steepParts, fraction));
                    }
                    if (useShading()) shade = headlight(gradient, eye.direction);
                }
                vec3 emitted = vec3(matter);
                float extinction = masked ? float(0.0) : matter.w;
                if (useTints()) {
                    Tint tint = tintAt(at);
                    emitted = tinted(emitted, tint);
                    extinction *= tint.opacity;
                }
                if (useShading()) emitted *= shade;
                if (useSecond()) addSecond(at, eye, masked, emitted, extinction);
                float through = exp(-extinction * step);
                colour += emitted * (transmittance * (float(1.0) - through));
                transmittance *= through;
            }
        } while (transmittance >= float(CAST_OPAQUE) && nextCell(cells, toMm));
    }
    return endOfMatter(colour, transmittance, face);
}

// Padding, voxels outside the scan, has its own entry below all measured ones (entry_map.cpp), so that air in
// a trachea still counts. Padding lowers the values interpolated with it: for a minimum or a mean, a cell
// with any padding does not count. It cannot raise a maximum, for which only a cell of nothing but padding is
// left out.
bool isCounted(Corners corners) {
    vec4 near = abs(corners.near - vec4(params.paddingEntry));
    vec4 far = abs(corners.far - vec4(params.paddingEntry));
    if (castLook() == kCastMaximum) return dot(near, vec4(1.0)) + dot(far, vec4(1.0)) > float(0.5);
    return min(min(min(near.x, near.y), min(near.z, near.w)), min(min(far.x, far.y), min(far.z, far.w))) >
           float(0.5);
}

// Only bricks with a bound above this can change the result: half an entry of slack is for rounding.
float leastBound(float best) {
    if (castLook() == kCastMaximum) return max(best + float(0.5), float(0.0));
    if (castLook() == kCastMinimum) return max(best + float(params.entryCount) - float(0.5), float(0.0));
    return float(0.0);
}

// The grey of a ray with these values; `best` is -1e9 where it met none, and the negative of a minimum.
vec4 endOfValues(float best, float sum, float lengthMm) {
    if (best <= float(-1e9)) return vec4(0.0);
    float entry = castLook() == kCastMinimum ? -best : best;
    if (castLook() == kCastMean && lengthMm > float(0.0)) entry = sum / lengthMm;
    float grey =
        clamp((entry - params.windowLow) / (params.windowHigh - params.windowLow), float(0.0), float(1.0));
    return vec4(vec3(greyBeforeToneMap(grey, params.keepsHue == 1) / params.exposure), float(1.0));
}

// The largest, smallest or mean value along the part of the ray that the clip shows, as the grey that the
// window gives it; 0 where the ray meets no values. The mean is exact, by Simpson's rule on cubics; an
// extreme is taken at the faces of cells, where most lie, or at three points between. The mask at the middle
// of the ray's stretch counts for the whole cell. A projection's medium bounds how much a brick can change
// the result (src/pipeline/volume/medium.h): bricks that cannot are skipped.
vec4 castValues(EyeRay eye, INOUT(int) rounds) {
    vec3 directionVoxel = voxelsPerMm(eye.direction);
    BrickWalk walk = startEyeWalk(eye.originVoxel, directionVoxel);
    CellWalk cells = startCells(eye.originVoxel, directionVoxel);
    float sign = castLook() == kCastMinimum ? float(-1.0) : float(1.0);
    float best = float(-1e9);  // sign times the value
    float sum = float(0.0);
    float lengthMm = float(0.0);
    float toMm = walk.distanceMm;
    float least = leastBound(best);
    while (nextPiece(walk, least, toMm, rounds)) {
        float atEnd = enterBrick(cells, walk, toMm);
        do {
            rounds += 1;
            Course value = courseIn(cells, atEnd);
            float middle = valueOf(value, float(0.5));
            atEnd = valueOf(value, float(1.0));
            float here = max(max(sign * value.start, sign * atEnd), sign * middle);
            here = max(here, max(sign * valueOf(value, float(0.25)), sign * valueOf(value, float(0.75))));
            vec3 centre = walkPositionAt(walk, float(0.5) * (cells.fromMm + cells.toMm));
            bool counts = isCounted(cells.corners) && !isMasked(centre);
            float length = counts ? cells.toMm - cells.fromMm : float(0.0);
            best = counts ? max(best, here) : best;
            sum += (value.start + float(4.0) * middle + atEnd) * (length * float(1.0 / 6.0));
            lengthMm += length;
        } while (nextCell(cells, toMm));
        least = leastBound(best);
    }
    return endOfValues(best, sum, lengthMm);
}

// An additive recurrence (Roberts 2018, in three dimensions): the position of a sample within its pixel and
// of values within their steps, 0 to 1. The first is the centre. The same for all pixels, so that a smooth
// picture stays smooth.
vec3 castOffset(uint sampleIndex) {
    uint centre = 0x80000000u;
    return vec3(float((centre + sampleIndex * 3518319155u) >> 8u),
                float((centre + sampleIndex * 2882110345u) >> 8u),
                float((centre + sampleIndex * 2360945575u) >> 8u)) *
           float(1.0 / 16777216.0);
}

// One sample of a pixel: premultiplied, with coverage.
vec4 castSample(ivec2 pixel, uint sampleIndex, INOUT(int) rounds) {
    vec3 offset = castOffset(sampleIndex);
    EyeRay eye = eyeRay(vec2(float(pixel.x) + offset.x, float(pixel.y) + offset.y));
    if (castLook() == kCastMatter) return castMatter(eye, offset.z, rounds);
    return castValues(eye, rounds);
}
