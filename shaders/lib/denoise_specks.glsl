// Before and after the filter: pixels that stand out alone. The brightest of few samples are many times as
// bright as all around them: the filter would keep such a pixel apart for its light, and a white dot would
// stay. So before the filter it gives light away, from four times its brightest neighbour on, and from seven
// times on all that is beyond that neighbour. After the filter, in soft tissue, normals are so uncertain that
// they tell a pixel from all around it; it keeps the noise of its few samples and is brighter, or darker,
// than each of its eight neighbours. As far as the noise that is left to it explains that, it exchanges with
// them whatever normals and light say, in flows like those of the filter: light is kept exactly, and the more
// samples, the less is exchanged.
//
// Depth and coverage still tell pixels apart. And after the filter those neighbours take part that differ
// from the limit (the light of the nearest of them) hardly more than the pixel does itself: in a line one
// pixel wide the limit is that of the line, and what stands out of the line by less than the line does of its
// sides goes along it.
//
// Alpha stays as it is: it is a coin whose odds the guides know, and where matter is opaque it has no noise.
//
// denoise.stride is 0 before the filter.
//
// Needs from its host, by index of a pixel: fetchColour and fetchNoise (of preparePixel or the last
// filterPixel), fetchMoments, fetchMass, fetchSurface; and denoise_filter.glsl.

// How much of what stands out is taken for noise, in standard deviations of what is left. More takes more
// away, of noisy lines too (docs/measurements/tracer.md).
#define SPECK_DEVIATIONS 2.0
// Before the filter: noise is known by few pixels, of which the bright one is the noisiest. From so many
// samples on, with those of the view before, less than half of that is taken, or true detail, as of cut
// faces, would go too.
#define DOT_DEVIATIONS 8.0
#define DOT_SAMPLES 8.0
#define DOT_TIMES 4.0  // what is so many times as bright as its brightest neighbour is none
// Stands for a pixel outside the picture, or one that is empty; light is 0 or more.
#define NO_LIGHT -1.0

// How a pixel stands out of its eight neighbours, in light per mass.
struct Speck {
    float limit;  // the neighbour's light that is nearest to its own; before the filter that, or more
    float over;   // how far beyond
    float part;   // what it exchanges with each of its neighbours, times eight: at most 1
};

// How much a neighbour with this light takes part.
float takesPart(Speck speck, float light) {
    if (light < float(0.0)) return float(0.0);
    if (denoise.stride == 0) return float(1.0);
    return clamp(float(2.0) - abs(light - speck.limit) / max(speck.over, float(1e-30)), float(0.0),
                 float(1.0));
}

// Of one of 5 times 5 pixels, row by row, that is not at their border. `explained` is how far noise explains
// that it stands out.
Speck speckAt(float lights[25], int place, float explained) {
    float light = lights[place];
    float low = float(1e30);
    float high = float(NO_LIGHT);
    float reach = float(0.0);  // how far all neighbours together would move it
    for (int i = 0; i < 9; ++i) {
        float other = lights[place + 5 * (i / 3 - 1) + i % 3 - 1];
        bool counts = other >= float(0.0) && i != 4;
        low = counts ? min(low, other) : low;
        high = counts ? max(high, other) : high;
        reach += counts ? abs(other - light) * float(1.0 / 8.0) : float(0.0);
    }
    bool alone = light < float(0.0) || high < float(0.0);
    Speck speck;
    float brightest = float(DOT_TIMES) * high;  // that is no dot
    float ofDot = light > brightest ? max(high, float(2.0) * brightest - light) : light;
    speck.limit = alone ? light : denoise.stride == 0 ? ofDot : clamp(light, low, high);
    speck.over = abs(light - speck.limit);
    float move = min(speck.over, explained);
    speck.part = speck.over > float(0.0) ? min(move / max(reach, float(1e-30)), float(1.0)) : float(0.0);
    return speck;
}

// How far the noise of a pixel explains that it stands out.
float explainedBy(int index, vec4 noise) {
    float deviation = sqrt(max(float(0.0), noise.x));
    if (denoise.stride > 0) return float(SPECK_DEVIATIONS) * deviation;
    float trust = float(DOT_SAMPLES) / (float(DOT_SAMPLES) + fetchMoments(index).y);
    return float(DOT_DEVIATIONS) * trust * deviation;
}

vec4 withoutSpeck(ivec2 pixel) {
    int index = indexOf(pixel);
    vec4 colour = fetchColour(index);
    vec4 mass = fetchMass(index);
    vec4 noise = fetchNoise(index);
    vec4 surface = fetchSurface(index);
    bool empty = massOfLight(mass) < float(LEAST_MASS);  // nothing flows to or from it
    float lights[25];
    for (int i = 0; i < 25; ++i) lights[i] = float(NO_LIGHT);
    int around = empty ? 0 : 25;
    for (int i = 0; i < around; ++i) {
        ivec2 at = pixel + ivec2(i % 5 - 2, i / 5 - 2);
        int q = indexOf(clamp(at, ivec2(0), denoise.imageSize - ivec2(1)));
        vec4 colourQ = fetchColour(q);
        float massQ = massOfLight(fetchMass(q));
        float light = luminance(vec3(colourQ.x, colourQ.y, colourQ.z)) / max(massQ, float(LEAST_MASS));
        lights[i] = isInside(at) && massQ >= float(LEAST_MASS) ? light : float(NO_LIGHT);
    }

    Speck own = speckAt(lights, 12, explainedBy(index, noise));
    vec4 ratio = colour / max(mass, vec4(LEAST_OF_CHANNEL));
    vec4 flow = vec4(0.0);
    int taps = empty ? 0 : 8;
    for (int tap = 0; tap < taps; ++tap) {
        int nth = tap < 4 ? tap : tap + 1;  // of nine, row by row, without the one in the middle
        int y = nth / 3 - 1;
        int x = nth - 3 * (y + 1) - 1;
        int place = 12 + 5 * y + x;
        int q = indexOf(clamp(pixel + ivec2(x, y), ivec2(0), denoise.imageSize - ivec2(1)));
        vec4 massQ = fetchMass(q);
        vec4 noiseQ = fetchNoise(q);
        Speck other = speckAt(lights, place, explainedBy(q, noiseQ));
        float thicker = mass.w - massQ.w;
        float stop = stopOfDepth(surface, noise, fetchSurface(q), noiseQ, sqrt(float(x * x + y * y))) +
                     float(COVERAGE_STOP) * thicker * thicker;
        // The same seen from either side; in sum 1 at most.
        float weight =
            max(own.part * takesPart(own, lights[place]), other.part * takesPart(other, lights[12])) *
            exp(-min(stop, float(80.0))) * float(1.0 / 8.0);
        weight = lights[place] >= float(0.0) ? weight : float(0.0);
        flow += (fetchColour(q) / max(massQ, vec4(LEAST_OF_CHANNEL)) - ratio) * min(mass, massQ) * weight;
    }
    vec4 light = clamp(colour + flow, vec4(0.0), vec4(MOST_LIGHT));
    return vec4(vec3(light.x, light.y, light.z), colour.w);
}
