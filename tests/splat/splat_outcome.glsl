// All functions of shaders/lib/splat_*.glsl on one splat, for a device (splat_outcome.comp) and for C++
// (splat_maths_device_test.cpp).

struct Outcome {
    ScreenSplat screen;
    vec3 colour;
    ivec2 first;
    ivec2 end;
    int shows;
    vec3 blended;
    float transmittance;
    ScreenGradient byScreen;
    SplatGradient bySplat;
    vec3 byPositionOfColour;
    Band1Gradient byBand;
};

Outcome outcomeOf(Splat splat, SplatView view) {
    Outcome o;
    o.screen = projectSplat(splat, view);

    vec3 s1 = vec3(0.1, 0.2, -0.1);
    vec3 s2 = vec3(-0.2, 0.1, 0.3);
    vec3 s3 = vec3(0.2, -0.3, 0.1);
    vec3 d = directionTo(splat.position, view);
    vec3 sum = colourOfBand0(vec3(0.7, 0.1, -0.5)) + colourOfBand1(d, s1, s2, s3) +
               colourOfBand2(d, s1, s2, s3, s1, s2) + colourOfBand3(d, s1, s2, s3, s1, s2, s3, s1);
    o.colour = visibleColour(sum);

    // A block at a quarter of the extent.
    pixelsOf(o.screen, view.sizePx, o.first, o.end);
    ivec2 block = o.first + (o.end - o.first) / 4;
    o.shows = showsIn(o.screen, block, block + ivec2(8), view) ? 1 : 0;

    // Nine points within two deviations, spread unevenly so that derivatives do not cancel; before something
    // worth 0.3.
    PixelGradient g;
    g.rgba = vec4(0.5, -0.2, 0.8, 0.4);
    g.depth = float(0.001);
    o.blended = vec3(0.0);
    o.transmittance = float(0.8);
    o.byScreen = noGradient();
    for (int k = 0; k < 9; ++k) {
        float u = (float(k % 3) - float(0.6)) / sqrt(o.screen.conic.x);
        float y = (float(k / 3) - float(0.7)) / sqrt(o.screen.conic.z);
        vec2 pixel = o.screen.mean + vec2(u - o.screen.conic.y * y, y);
        float alpha = limitedAlpha(rawAlphaAt(o.screen, pixel), view);
        float before = o.transmittance;
        float remaining = before * (alpha * worthOf(o.colour, o.screen.depthMm, g) + float(0.3));
        addPixelGradient(o.screen, o.colour, pixel, g, view, before, remaining, o.byScreen);
        o.blended += o.colour * takeWeight(o.transmittance, alpha, view);
    }
    o.bySplat = noSplatGradient();
    if (o.screen.opacity > float(0.0)) o.bySplat = projectionGradient(splat, view, o.screen, o.byScreen);
    vec3 bySum = sumGradient(sum, o.byScreen.colour) + vec3(float(1.0));
    o.byPositionOfColour = colourPositionGradient(splat.position, view, s1, s2, s3, bySum);
    o.byBand = band1Gradient(d, bySum);
    return o;
}
