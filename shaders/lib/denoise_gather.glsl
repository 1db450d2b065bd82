// First step of denoising: collects each pixel's light from this view and its history.
//
// Needs from its host, by index of a pixel: fetchSums (radiance and coverage), fetchCount, fetchSquares (of
// luminance), fetchSurface, fetchMatter, fetchMotion as guides.comp writes them; and of the previous view:
// fetchOldMean, fetchOldMoments, fetchOldSurface, fetchOldMatter.

// A pixel's mean light and mean square of luminance over so many samples.
struct Record {
    vec4 mean;
    float square;
    float samples;
};

// Temporal accumulation: adds to the film of this view the record of the previous view where that shows the
// same matter. The history counts for less the more samples this view has: matter seen from elsewhere never
// looks quite the same.
Record gatherPixel(ivec2 pixel) {
    int index = indexOf(pixel);
    vec4 sums = fetchSums(index);
    float square = fetchSquares(index);
    float samples = float(fetchCount(index));
    if (!isFinite(vec4(square, samples, sums.w, float(0.0))) || !isFinite(sums) || samples < float(1.0)) {
        sums = vec4(0.0);
        square = float(0.0);
        samples = float(0.0);
    }
    Record record;
    record.mean = clamp(sums / max(samples, float(1.0)), vec4(0.0), vec4(MOST_LIGHT));
    record.mean.w = min(record.mean.w, float(1.0));
    record.square = min(square / max(samples, float(1.0)), float(MOST_LIGHT * MOST_LIGHT));
    record.samples = samples;

    vec4 surface = fetchSurface(index);
    vec4 matter = fetchMatter(index);
    vec4 motion = fetchMotion(index);
    float trust = denoise.historySamples > float(0.0)
                      ? max(float(1.0) - samples / (float(4.0) * denoise.historySamples), float(0.0))
                      : float(0.0);
    if (motion.w < float(0.0) || trust <= float(0.0)) return record;

    // Of the four pixels around the position in the previous view, uses those that show the same matter.
    vec2 place = vec2(pixel) + vec2(motion.x, motion.y);
    place = clamp(place, vec2(-2.0), vec2(denoise.imageSize) + vec2(2.0));
    vec2 low = floor(place);
    vec2 f = place - low;
    float footprintMm = footprintMmAt(pixel, motion.w);
    float spreadMm = float(4.0) * footprintMm * (float(1.0) / max(motion.z, float(0.05)) - float(1.0));
    float toleranceMm = float(4.0) * footprintMm + float(0.5) * spreadMm;
    vec4 oldMean = vec4(0.0);
    float oldSquare = float(0.0);
    float oldSamples = float(0.0);
    float total = float(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 at = ivec2(low) + ivec2(i & 1, i >> 1);
        if (!isInside(at)) continue;
        int old = indexOf(at);
        vec4 oldSurface = fetchOldSurface(old);
        vec4 oldMatter = fetchOldMatter(old);
        vec2 oldMoments = fetchOldMoments(old);
        bool sameDepth = surface.w >= float(0.0)
                             ? oldSurface.w >= float(0.0) && abs(oldSurface.w - motion.w) <= toleranceMm
                             : oldSurface.w < float(0.0);
        vec3 across = vec3(surface.x - oldSurface.x, surface.y - oldSurface.y, surface.z - oldSurface.z);
        vec3 colour = vec3(matter.x - oldMatter.x, matter.y - oldMatter.y, matter.z - oldMatter.z);
        bool same = sameDepth && dot(across, across) < float(1.0) && dot(colour, colour) < float(0.03) &&
                    abs(matter.w - oldMatter.w) < float(0.2);
        float weight = ((i & 1) == 0 ? float(1.0) - f.x : f.x) * ((i >> 1) == 0 ? float(1.0) - f.y : f.y);
        weight = same && oldMoments.y > float(0.0) ? weight : float(0.0);
        oldMean += fetchOldMean(old) * weight;
        oldSquare += oldMoments.x * weight;
        oldSamples += oldMoments.y * weight;
        total += weight;
    }
    if (total < float(0.01)) return record;
    oldSamples = min(oldSamples, denoise.historySamples) * trust;
    float all = samples + oldSamples;
    record.mean = (record.mean * samples + oldMean * (oldSamples / total)) / all;
    record.square = (record.square * samples + oldSquare * (oldSamples / total)) / all;
    record.samples = all;
    return record;
}
