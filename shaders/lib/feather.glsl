// Softens the border of the known part of a reprojected picture, so that it does not end in steps of pixels.
//
// Needs from its host: fetchWeight, by a pixel of the picture, 0 to 1; beyond the border as at the border.

#define FEATHER_RADIUS 2

// A pixel keeps its weight where its surroundings have at least the same weight, and loses all where their
// mean is half of it or less: a known pixel among unknown ones is no surface.
float feathered(ivec2 pixel) {
    float sum = float(0.0);
    for (int y = -FEATHER_RADIUS; y <= FEATHER_RADIUS; ++y) {
        for (int x = -FEATHER_RADIUS; x <= FEATHER_RADIUS; ++x) sum += fetchWeight(pixel + ivec2(x, y));
    }
    float mean = sum / float((2 * FEATHER_RADIUS + 1) * (2 * FEATHER_RADIUS + 1));
    float own = fetchWeight(pixel);
    float t = clamp(float(2.0) * mean / max(own, float(1e-6)) - float(1.0), float(0.0), float(1.0));
    return own * (t * t * (float(3.0) - float(2.0) * t));
}
