// The structs of the splat maths. The host declares SplatView, as in shaders/shared/splat_view.h.

// One Gaussian.
struct Splat {
    vec3 position;  // mm, relative to the model's origin
    vec3 logScale;  // ln of the standard deviation in mm, along its own axes
    vec4 rotation;  // quaternion in the order w, x, y, z, that is w in .x; of any length
    float opacityLogit;
};

// One Gaussian in the picture. At the offset (x, y) from its mean its alpha is opacity * exp(-q / 2), where
//
//   q = conic.x (x + conic.y y)^2 + conic.z y^2
//
// That is the inverse of the 2D covariance, factored: it cannot become indefinite by rounding, and a needle a
// thousand pixels long keeps its width in float, where the three numbers of the inverse itself would cancel.
struct ScreenSplat {
    vec2 mean;      // px
    vec3 conic;     // 1/px^2, 1, 1/px^2
    float opacity;  // at the centre, with compensation; 0: it is not in the picture
    float depthMm;  // of the centre along the camera's z
    vec2 extent;    // half width and half height, px, of the box in which alpha exceeds minAlpha
};

// The derivative of a loss with respect to a ScreenSplat and its colour.
struct ScreenGradient {
    vec2 mean;
    vec3 conic;
    float opacity;
    vec3 colour;
    float depthMm;
};

ScreenGradient noGradient() {
    ScreenGradient g;
    g.mean = vec2(float(0.0));
    g.conic = vec3(float(0.0));
    g.opacity = float(0.0);
    g.colour = vec3(float(0.0));
    g.depthMm = float(0.0);
    return g;
}
