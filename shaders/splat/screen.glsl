// Splats projected into the picture, as project.comp writes them.
layout(binding = 1) uniform samplerBuffer screenTexels;

struct Shown {
    ScreenSplat screen;
    vec3 colour;
};

Shown fetchShown(int splat) {
    vec4 a = texelFetch(screenTexels, splat * kScreenTexels);
    vec4 b = texelFetch(screenTexels, splat * kScreenTexels + 1);
    vec4 c = texelFetch(screenTexels, splat * kScreenTexels + 2);
    Shown shown;
    shown.screen.mean = a.xy;
    shown.screen.conic = vec3(a.zw, b.x);
    shown.screen.opacity = b.y;
    shown.screen.depthMm = b.z;
    shown.screen.extent = vec2(b.w, c.w);
    shown.colour = c.xyz;
    return shown;
}
