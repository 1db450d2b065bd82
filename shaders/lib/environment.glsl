// Light from all directions: see src/pipeline/trace/environment.h for the frame and the layout.
//
// Needs from its host: params.environmentSize, fetchEnvironment(texel) = radiance and pdf per steradian, and
// fetchCumulative(i): for each row where its share of the unit interval begins; after them, for each texel,
// where its share of its row begins.

struct EnvironmentSample {
    vec3 direction;  // unit, in the environment's frame
    vec3 radiance;
    float pdfPerSr;  // 0 when there is no light at all
};

// The share that holds u: the last of `count` shares, whose begins are stored from index `first` on, that
// begins at or below u. `within` is the position of u in it, 0 to 1.
int shareAt(int first, int count, float u, OUT(float) within) {
    int low = 0;
    int high = count;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (fetchCumulative(first + middle) <= u) {
            low = middle;
        } else {
            high = middle;
        }
    }
    float begin = fetchCumulative(first + low);
    float end = high < count ? fetchCumulative(first + high) : float(1.0);
    within = (u - begin) / (end - begin);
    return low;
}

// Importance sampling: draws a row by its power, a texel of the row likewise, and a direction in it uniform
// in solid angle, so that the pdf is constant over the texel. Near points of the square mostly map to near
// directions, so that stratified points give stratified light.
EnvironmentSample sampleEnvironment(vec2 u) {
    float down;
    float along;
    int row = shareAt(0, params.environmentSize.y, u.x, down);
    int column = shareAt(params.environmentSize.y + row * params.environmentSize.x, params.environmentSize.x,
                         u.y, along);
    vec4 light = fetchEnvironment(row * params.environmentSize.x + column);
    float angle = float(PI) / float(params.environmentSize.y);
    float cosine = mix(cos(float(row) * angle), cos(float(row + 1) * angle), down);
    float sine = sqrt(max(float(0.0), float(1.0) - cosine * cosine));
    float azimuth =
        float(2.0 * PI) * ((float(column) + along) / float(params.environmentSize.x) - float(0.5));
    return EnvironmentSample(vec3(-sine * sin(azimuth), cosine, sine * cos(azimuth)),
                             vec3(light.x, light.y, light.z), light.w);
}

int environmentTexel(vec3 direction) {
    float polar = acos(clamp(direction.y, float(-1.0), float(1.0))) * float(1.0 / PI);
    float azimuth = atan(-direction.x, direction.z) * float(0.5 / PI) + float(0.5);
    int row = clamp(int(polar * float(params.environmentSize.y)), 0, params.environmentSize.y - 1);
    int column = clamp(int(azimuth * float(params.environmentSize.x)), 0, params.environmentSize.x - 1);
    return row * params.environmentSize.x + column;
}
