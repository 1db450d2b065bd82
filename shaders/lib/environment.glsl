// Light from all directions: see src/pipeline/trace/environment.h for the frame and the layout.
//
// Needs from its host: params.environmentSize, fetchEnvironment(texel) = radiance and pdf per steradian, and
// fetchAlias(texel) = probability to stay, and the other texel.

struct EnvironmentSample {
    vec3 direction;  // unit, in the environment's frame
    vec3 radiance;
    float pdfPerSr;  // 0 when there is no light at all
};

// A texel by its power, then a direction in it uniform in solid angle, so that the pdf is the same all over the texel.
EnvironmentSample sampleEnvironment(INOUT(Rng) rng) {
    int texels = params.environmentSize.x * params.environmentSize.y;
    int texel = min(int(random01(rng) * float(texels)), texels - 1);
    vec2 alias = fetchAlias(texel);
    texel = random01(rng) < alias.x ? texel : int(alias.y);
    vec4 light = fetchEnvironment(texel);

    int row = texel / params.environmentSize.x;
    int column = texel - row * params.environmentSize.x;
    float angle = float(PI) / float(params.environmentSize.y);
    float cosine = mix(cos(float(row) * angle), cos(float(row + 1) * angle), random01(rng));
    float sine = sqrt(max(float(0.0), float(1.0) - cosine * cosine));
    float azimuth =
        float(2.0 * PI) * ((float(column) + random01(rng)) / float(params.environmentSize.x) - float(0.5));
    return EnvironmentSample(vec3(-sine * sin(azimuth), cosine, sine * cos(azimuth)), vec3(light.x, light.y, light.z), light.w);
}

int environmentTexel(vec3 direction) {
    float polar = acos(clamp(direction.y, float(-1.0), float(1.0))) * float(1.0 / PI);
    float azimuth = atan(-direction.x, direction.z) * float(0.5 / PI) + float(0.5);
    int row = clamp(int(polar * float(params.environmentSize.y)), 0, params.environmentSize.y - 1);
    int column = clamp(int(azimuth * float(params.environmentSize.x)), 0, params.environmentSize.x - 1);
    return row * params.environmentSize.x + column;
}
