// The border of what is known, made soft: a reprojected picture ends at pixels, an eye sees no steps in it.
//
// Needs from its host: fetchWeight, by a pixel of the picture, 0 to 1; beyond the border as at the border.

#define FEATHER_RADIUS 2

// A pixel keeps its weight where all around it is known as well as itself, and loses it where half is not:
// what is known alone is no surface.
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
