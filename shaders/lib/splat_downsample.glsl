// Makes a smaller picture, each of whose pixels is the mean over its area: sizes need not divide each other,
// and the mean of the picture is kept.
//
// Needs picture.glsl, and from its host: vec4 fetchSource(int index), premultiplied.

// The overlap of source pixel `at` and target pixel `to` along one axis, in units of 1 / toSize of a source
// pixel: a whole number, and so exact.
float downsampleOverlap(int at, int to, int fromSize, int toSize) {
    int low = max(at * toSize, to * fromSize);
    int high = min((at + 1) * toSize, (to + 1) * fromSize);
    return float(max(high - low, 0));
}

// Leaves out pixels that are not finite; if there are no others, the result is not finite either.
vec4 downsampledPixel(ivec2 to, ivec2 fromSize, ivec2 toSize) {
    ivec2 low = ivec2(to.x * fromSize.x / toSize.x, to.y * fromSize.y / toSize.y);
    ivec2 count =
        ivec2((fromSize.x + toSize.x - 1) / toSize.x + 1, (fromSize.y + toSize.y - 1) / toSize.y + 1);
    vec4 sum = vec4(0.0);
    float weights = float(0.0);
    vec4 bad = vec4(0.0);
    for (int j = 0; j < count.y; ++j) {
        for (int i = 0; i < count.x; ++i) {
            ivec2 at = ivec2(min(low.x + i, fromSize.x - 1), min(low.y + j, fromSize.y - 1));
            float weight = downsampleOverlap(low.x + i, to.x, fromSize.x, toSize.x) *
                           downsampleOverlap(low.y + j, to.y, fromSize.y, toSize.y);
            vec4 value = fetchSource(at.y * fromSize.x + at.x);
            bool finite = isFinite(value);
            bad = finite ? bad : value;
            weight = finite ? weight : float(0.0);
            sum += (finite ? value : vec4(0.0)) * weight;
            weights += weight;
        }
    }
    return weights > float(0.0) ? sum / weights : bad;
}
