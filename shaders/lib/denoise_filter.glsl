// Third step of denoising, several times with growing stride: pixels that show the same matter exchange
// light.
//
// Needs from its host, by index of a pixel: fetchColour and fetchNoise (the mean and the noise of
// preparePixel, then those of the previous pass), fetchMass, fetchSurface.

// The cost of a unit of difference, in the exponent of a weight.
#define DEPTH_STOP 0.15    // squared difference of depth over the one that slope and spread explain
#define NORMAL_STOP 2.0    // of 1 - cosine
#define COVERAGE_STOP 8.0  // of coverage, squared
#define LIGHT_STOP 0.1     // squared difference over its variance

struct Filtered {
    vec4 colour;
    vec2 variance;
};

// The cost of the depths of two pixels that are `apart` pixels apart.
float stopOfDepth(vec4 surface, vec4 noise, vec4 surfaceQ, vec4 noiseQ, float apart) {
    float toleranceMm = float(0.5) * ((noise.z + noiseQ.z) * apart + noise.w + noiseQ.w);
    bool depths = surface.w >= float(0.0) && surfaceQ.w >= float(0.0);
    float deviation = (surface.w - surfaceQ.w) / max(toleranceMm, float(1e-12));
    return depths ? float(DEPTH_STOP) * deviation * deviation : float(0.0);
}

// One pass: eight taps denoise.stride apart, with the weights of a binomial filter; light that no tap takes
// stays.
Filtered filterPixel(ivec2 pixel) {
    int index = indexOf(pixel);
    vec4 colour = fetchColour(index);
    vec4 mass = fetchMass(index);
    vec4 noise = fetchNoise(index);
    vec4 surface = fetchSurface(index);
    vec3 normal = vec3(surface.x, surface.y, surface.z);
    vec4 inverse = vec4(float(1.0)) / max(mass, vec4(LEAST_OF_CHANNEL));
    vec4 ratio = colour * inverse;
    float light = luminance(vec3(colour.x, colour.y, colour.z)) / max(massOfLight(mass), float(LEAST_MASS));

    vec4 flow = vec4(0.0);
    vec2 given = vec2(0.0);
    vec2 variance = vec2(0.0);
    int taps = isEmpty(mass) ? 0 : 8;
    for (int tap = 0; tap < taps; ++tap) {
        int place = tap < 4 ? tap : tap + 1;  // of nine pixels, row by row, without the middle one
        int y = place / 3 - 1;
        int x = place - 3 * (y + 1) - 1;
        ivec2 at = pixel + ivec2(x, y) * denoise.stride;
        bool inside = isInside(at);
        int q = indexOf(clamp(at, ivec2(0), denoise.imageSize - ivec2(1)));
        vec4 colourQ = fetchColour(q);
        vec4 massQ = fetchMass(q);
        vec4 noiseQ = fetchNoise(q);
        vec4 surfaceQ = fetchSurface(q);

        float apart = sqrt(float(x * x + y * y)) * float(denoise.stride);
        bool depths = surface.w >= float(0.0) && surfaceQ.w >= float(0.0);
        float stop = stopOfDepth(surface, noise, surfaceQ, noiseQ, apart);
        vec3 across = normal - vec3(surfaceQ.x, surfaceQ.y, surfaceQ.z);
        stop += depths ? float(0.5 * NORMAL_STOP) * dot(across, across) : float(0.0);
        float thicker = mass.w - massQ.w;
        stop += float(COVERAGE_STOP) * thicker * thicker;

        vec4 inverseQ = vec4(float(1.0)) / max(massQ, vec4(LEAST_OF_CHANNEL));
        vec4 difference = colourQ * inverseQ - ratio;
        difference.w = (colourQ.w - massQ.w) - (colour.w - mass.w);
        float brighter =
            luminance(vec3(colourQ.x, colourQ.y, colourQ.z)) / max(massOfLight(massQ), float(LEAST_MASS)) -
            light;
        float stopLight = float(LIGHT_STOP) * (brighter * brighter / max(noise.x + noiseQ.x, float(1e-30)));
        float stopAlpha =
            float(LIGHT_STOP) * (difference.w * difference.w / max(noise.y + noiseQ.y, float(1e-30)));

        float kernel = x == 0 || y == 0 ? float(1.0 / 6.0) : float(1.0 / 12.0);
        kernel = inside ? kernel : float(0.0);
        vec2 weight =
            vec2(exp(-min(stop + stopLight, float(80.0))), exp(-min(stop + stopAlpha, float(80.0)))) * kernel;
        // All colours flow or none: otherwise the rest would change its hue.
        vec4 both =
            min(mass, massQ) *
            (min(massOfLight(mass), massOfLight(massQ)) < float(LEAST_MASS) ? float(0.0) : float(1.0));
        both.w = min(chanceOf(mass.w), chanceOf(massQ.w));
        flow += difference * both * vec4(weight.x, weight.x, weight.x, weight.y);
        vec2 share =
            vec2(weight.x * massOfLight(both) / max(massOfLight(mass), float(LEAST_MASS)), weight.y * both.w);
        given += share;
        variance += share * share * vec2(noiseQ.x, noiseQ.y);
    }
    Filtered filtered;
    filtered.colour = colour + flow;
    vec2 left = vec2(float(1.0)) - given;
    filtered.variance = left * left * vec2(noise.x, noise.y) + variance;
    if (denoise.last == 1)
        filtered.colour = clamp(filtered.colour, vec4(0.0), vec4(vec3(MOST_LIGHT), float(1.0)));
    return filtered;
}
