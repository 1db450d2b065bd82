// Last step of denoising: pixels that the filter left alone. Where the guides of a pixel are unlike those of all around,
// nothing flows, and it keeps the noise of its few samples: it stands out, brighter or darker than each of its eight
// neighbours. As far as its own remaining noise explains that, it exchanges with them, in flows like those of the filter:
// so light is kept exactly here too, and as samples come in nothing is left to be exchanged.
//
// A line one pixel wide has neighbours like itself in it, and what stands out of them goes to these: of each pixel's
// neighbours, those take part that differ from the limit (the nearest of all neighbours) no more than the pixel itself.
// Alpha stays as it is: it is a coin whose odds the guides know, and where matter is opaque it has no noise.
//
// Needs from its host, by index of a pixel: fetchColour and fetchNoise (of the last filterPixel), fetchMass.

// How much of what stands out is taken for noise, in standard deviations of what the filter left.
#define SPECK_DEVIATIONS 2.0
// Stands for a pixel outside the picture, or one that is empty; light is 0 or more.
#define NO_LIGHT -1.0

// How a pixel stands out of its eight neighbours, in light per mass.
struct Speck {
    float limit;  // the neighbour's light that is nearest to its own
    float over;   // how far beyond
    float part;   // of the difference to each neighbour that takes part, times eight: what is exchanged
};

// How much a neighbour with this light takes part; it goes to nothing gradually.
float takesPart(Speck speck, float light) {
    if (light < float(0.0)) return float(0.0);
    return clamp(float(2.0) - abs(light - speck.limit) / max(speck.over, float(1e-30)), float(0.0), float(1.0));
}

// Of the place with this index among 5 times 5 pixels, row by row, that is not at their border. `variance` is its own.
Speck speckAt(float lights[25], int place, float variance) {
    float light = lights[place];
    float low = float(1e30);
    float high = float(NO_LIGHT);
    for (int y = -5; y <= 5; y += 5) {
        for (int x = -1; x <= 1; ++x) {
            float other = lights[place + y + x];
            bool counts = other >= float(0.0) && (x != 0 || y != 0);
            low = counts ? min(low, other) : low;
            high = counts ? max(high, other) : high;
        }
    }
    bool alone = light < float(0.0) || high < float(0.0);
    Speck speck;
    speck.limit = alone ? light : clamp(light, low, high);
    speck.over = abs(light - speck.limit);
    float reach = float(0.0);  // how far all would move it
    for (int y = -5; y <= 5; y += 5) {
        for (int x = -1; x <= 1; ++x) {
            float other = lights[place + y + x];
            reach += takesPart(speck, other) * abs(other - light) * float(1.0 / 8.0);
        }
    }
    float move = min(speck.over, float(SPECK_DEVIATIONS) * sqrt(max(float(0.0), variance)));
    speck.part = speck.over > float(0.0) ? min(move / max(reach, float(1e-30)), float(1.0)) : float(0.0);
    return speck;
}

vec4 withoutSpeck(ivec2 pixel) {
    vec4 colour = fetchColour(indexOf(pixel));
    vec4 mass = fetchMass(indexOf(pixel));
    float lights[25];
    for (int i = 0; i < 25; ++i) lights[i] = float(NO_LIGHT);
    bool empty = massOfLight(mass) < float(LEAST_MASS);  // nothing flows to or from it
    int around = empty ? 0 : 25;
    for (int i = 0; i < around; ++i) {
        int y = i / 5 - 2;
        int x = i - 5 * (y + 2) - 2;
        ivec2 at = pixel + ivec2(x, y);
        int q = indexOf(clamp(at, ivec2(0), denoise.imageSize - ivec2(1)));
        vec4 colourQ = fetchColour(q);
        float massQ = massOfLight(fetchMass(q));
        float light = luminance(vec3(colourQ.x, colourQ.y, colourQ.z)) / max(massQ, float(LEAST_MASS));
        lights[i] = isInside(at) && massQ >= float(LEAST_MASS) ? light : float(NO_LIGHT);
    }

    Speck own = speckAt(lights, 12, fetchNoise(indexOf(pixel)).x);
    vec4 ratio = colour / max(mass, vec4(LEAST_OF_CHANNEL));
    vec4 flow = vec4(0.0);
    int taps = empty ? 0 : 8;
    for (int tap = 0; tap < taps; ++tap) {
        int nth = tap < 4 ? tap : tap + 1;  // of nine, row by row, without the one in the middle
        int y = nth / 3 - 1;
        int x = nth - 3 * (y + 1) - 1;
        int place = 12 + 5 * y + x;
        if (lights[place] < float(0.0)) continue;
        int q = indexOf(pixel + ivec2(x, y));
        vec4 massQ = fetchMass(q);
        Speck other = speckAt(lights, place, fetchNoise(q).x);
        // The same seen from either; all weights of a pixel are 1 at most in sum.
        float weight = max(own.part * takesPart(own, lights[place]), other.part * takesPart(other, lights[12])) *
                       float(1.0 / 8.0);
        flow += (fetchColour(q) / max(massQ, vec4(LEAST_OF_CHANNEL)) - ratio) * min(mass, massQ) * weight;
    }
    vec4 light = clamp(colour + flow, vec4(0.0), vec4(MOST_LIGHT));
    return vec4(vec3(light.x, light.y, light.z), colour.w);
}
