// Before and after the filter: limits single pixels that stand out. The brightest of few samples is many
// times as bright as all around it: the filter would not mix such a pixel with its neighbours, and a white
// dot would stay. So before the filter a pixel above four times its brightest neighbour gives light away;
// from seven times on, everything beyond that neighbour. After the filter, in soft tissue, normals are so
// uncertain that they separate a pixel from all its neighbours; it keeps the noise of its few samples and is
// brighter, or darker, than each of them. As far as its remaining noise explains the difference, it exchanges
// light with them whatever normals and light say, in flows like those of the filter: the sum of light is kept
// exactly, and the more samples, the less is exchanged.
//
// Depth and coverage still separate pixels. And after the filter only those neighbours take part whose light
// differs from the limit (the light of the nearest of them) hardly more than the pixel's own: in a line one
// pixel wide the limit is the line's light, and an excess smaller than the line's contrast spreads along the
// line.
//
// Alpha stays as it is: its randomness has a probability that the guides know, and where matter is opaque it
// has no noise.
//
// denoise.stride is 0 before the filter.
//
// Needs from its host, by index of a pixel: fetchColour and fetchNoise (of preparePixel or the last
// filterPixel), fetchMoments, fetchMass, fetchSurface; and denoise_filter.glsl.

// The excess that counts as noise, in standard deviations of the remaining noise. A larger number removes
// more, also from noisy lines (docs/measurements/tracer.md).
#define SPECK_DEVIATIONS 2.0
// Before the filter the noise is known from few pixels only, of which the bright one is the noisiest. From
// DOT_SAMPLES samples on, history included, less than half of DOT_DEVIATIONS applies: otherwise true detail,
// such as that of cut faces, would be lost.
#define DOT_DEVIATIONS 8.0
#define DOT_SAMPLES 8.0
#define DOT_TIMES 4.0  // a pixel up to so many times as bright as its brightest neighbour is no dot
// Marks a pixel that is empty or outside the picture; light is never negative.
#define NO_LIGHT -1.0

// How a pixel stands out from its eight neighbours, in light per mass.
struct Speck {
    float limit;  // the nearest light among its neighbours; before the filter that or more
    float over;   // how far its own light is beyond the limit
    float part;   // share that it exchanges with each of its neighbours, times eight: at most 1
};

// How much a neighbour with this light takes part, 0 to 1.
float takesPart(Speck speck, float light) {
    if (light < float(0.0)) return float(0.0);
    if (denoise.stride == 0) return float(1.0);
    return clamp(float(2.0) - abs(light - speck.limit) / max(speck.over, float(1e-30)), float(0.0),
                 float(1.0));
}

// The speck of one of the inner 3 x 3 of 5 x 5 pixels, row by row. Noise explains a difference of up to
// `explained`.
Speck speckAt(float lights[25], int place, float explained) {
    float light = lights[place];
    float low = float(1e30);
    float high = float(NO_LIGHT);
    float reach = float(0.0);  // how far a full exchange with all neighbours would move it
    for (int i = 0; i < 9; ++i) {
        float other = lights[place + 5 * (i / 3 - 1) + i % 3 - 1];
        bool counts = other >= float(0.0) && i != 4;
        low = counts ? min(low, other) : low;
        high = counts ? max(high, other) : high;
        reach += counts ? abs(other - light) * float(1.0 / 8.0) : float(0.0);
    }
    bool alone = light < float(0.0) || high < float(0.0);
    Speck speck;
    float brightest = float(DOT_TIMES) * high;  // brightest light that is no dot
    float ofDot = light > brightest ? max(high, float(2.0) * brightest - light) : light;
    speck.limit = alone ? light : denoise.stride == 0 ? ofDot : clamp(light, low, high);
    speck.over = abs(light - speck.limit);
    float move = min(speck.over, explained);
    speck.part = speck.over > float(0.0) ? min(move / max(reach, float(1e-30)), float(1.0)) : float(0.0);
    return speck;
}

// The difference from its neighbours that a pixel's noise explains.
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
        int nth = tap < 4 ? tap : tap + 1;  // of nine pixels, row by row, without the middle one
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
        // Symmetric in both pixels; the sum over neighbours is at most 1.
        float weight =
            max(own.part * takesPart(own, lights[place]), other.part * takesPart(other, lights[12])) *
            exp(-min(stop, float(80.0))) * float(1.0 / 8.0);
        weight = lights[place] >= float(0.0) ? weight : float(0.0);
        flow += (fetchColour(q) / max(massQ, vec4(LEAST_OF_CHANNEL)) - ratio) * min(mass, massQ) * weight;
    }
    vec4 light = clamp(colour + flow, vec4(0.0), vec4(MOST_LIGHT));
    return vec4(vec3(light.x, light.y, light.z), colour.w);
}
