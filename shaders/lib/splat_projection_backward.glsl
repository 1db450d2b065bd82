// The backward pass of splat_projection.glsl: from the derivative of the loss with respect to the projected
// splat to that with respect to its parameters. The extent has no derivative.
//
// Needs splat_projection.glsl.

struct SplatGradient {
    vec3 position;
    vec3 logScale;
    vec4 rotation;
    float opacityLogit;
};

SplatGradient noSplatGradient() {
    SplatGradient g;
    g.position = vec3(float(0.0));
    g.logScale = vec3(float(0.0));
    g.rotation = vec4(float(0.0));
    g.opacityLogit = float(0.0);
    return g;
}

// With respect to the position, for parallel rays: through the mean and the depth.
vec3 parallelPositionGradient(SplatView view, ScreenGradient g) {
    return view.right * (g.mean.x * view.focalPx.x) + view.down * (g.mean.y * view.focalPx.y) +
           view.forward * g.depthMm;
}

// With respect to the position, for rays from the eye: through the mean, the depth, and J, whose rows and
// normal have the given derivatives.
vec3 perspectivePositionGradient(SplatView view, SplatSight sight, ScreenGradient g, vec3 byRowX, vec3 byRowY,
                                 vec3 byNormal) {
    float z = sight.inCamera.z;
    vec2 scale = overDepth(view.focalPx, z);
    float bySlopeX = scale.x * (scale.y * dot(view.right, byNormal) - dot(view.forward, byRowX));
    float bySlopeY = scale.y * (scale.x * dot(view.down, byNormal) - dot(view.forward, byRowY));
    bySlopeX = mix(bySlopeX, float(0.0), sight.slope.x != sight.slopeClamped.x);
    bySlopeY = mix(bySlopeY, float(0.0), sight.slope.y != sight.slopeClamped.y);
    bySlopeX += g.mean.x * view.focalPx.x;
    bySlopeY += g.mean.y * view.focalPx.y;
    float bySlopeAndRows = dot(sight.rowX, byRowX) + dot(sight.rowY, byRowY) +
                           float(2.0) * dot(sight.normal, byNormal) + sight.slope.x * bySlopeX +
                           sight.slope.y * bySlopeY;
    vec2 across = overDepth(vec2(bySlopeX, bySlopeY), z);
    float byZ = g.depthMm - overDepth(vec2(bySlopeAndRows, float(0.0)), z).x;
    return view.right * across.x + view.down * across.y + view.forward * byZ;
}

// `screen` is projectSplat(splat, view), with an opacity above 0; ignores the colour in `g`, see
// splat_colour.glsl.
SplatGradient projectionGradient(Splat splat, SplatView view, ScreenSplat screen, ScreenGradient g) {
    float two = float(2.0);
    SplatSight sight = sightOf(splat, view);
    float s = sight.lowPass;
    SplatGradient result;

    // Opacity.
    float compensation = compensationOf(sight, view);
    result.opacityLogit = g.opacity * compensation * opacitySlope(splat.opacityLogit);
    float byCompensation = view.compensated == 0 ? float(0.0) : g.opacity * opacityOf(splat.opacityLogit);

    // Conic and compensation as functions of xx, xy, yy and the area A, with det = A^2 + s (xx + yy) + s^2
    // with xx and yy before the low-pass. conic = (yy / det, -xy / yy, 1 / yy), compensation = A / sqrt(det).
    float perYy = screen.conic.z;
    float perDet = screen.conic.x * perYy;
    float perRootDet = sqrt(screen.conic.x) * sqrt(perYy);
    float byDet = -(g.conic.x * screen.conic.x + float(0.5) * byCompensation * compensation) * perDet;
    float byArea = byCompensation * perRootDet + two * sight.area * byDet;
    float byXx = s * byDet;
    float byYy = s * byDet + g.conic.x * perDet - (g.conic.y * screen.conic.y + g.conic.z * perYy) * perYy;
    float byXy = -g.conic.y * perYy;

    // The low-pass is a function of the smaller variance, which is A^2 over the larger one, and so of A, xx,
    // xy and yy. For a circle the larger variance has no derivative; that of half the sum, (xx + yy) / 2, is
    // one of its subgradients.
    float byLowPass = byYy + byDet * (sight.xx + sight.yy - s);
    float byMinor = byLowPass * lowPassSlope(sight.minor, view);
    float perMajor = mix(float(0.0), float(1.0) / sight.major, sight.major > float(0.0));
    byArea += byMinor * two * sight.area * perMajor;
    float byMajor = -byMinor * sight.minor * perMajor;
    float halfGap = float(0.5) * (sight.xx - sight.yy);
    float radius = lengthOf(vec3(halfGap, sight.xy, float(0.0)));
    float perRadius = mix(float(0.0), float(1.0) / radius, radius > float(0.0));
    byXx += byMajor * float(0.5) * (float(1.0) + halfGap * perRadius);
    byYy += byMajor * float(0.5) * (float(1.0) - halfGap * perRadius);
    byXy += byMajor * sight.xy * perRadius;

    vec3 bySpreadX = sight.spreadX * (two * byXx) + sight.spreadY * byXy;
    vec3 bySpreadY = sight.spreadY * (two * byYy) + sight.spreadX * byXy;
    // At area 0 (a splat without volume, seen along its plane) the length has no derivative; 0 is one of its
    // subgradients.
    vec3 byAreas = mix(vec3(float(0.0)), sight.areas * (byArea / sight.area), bvec3(sight.area > float(0.0)));

    // Scale: a spread is proportional to one of the three deviations, an area to two of them.
    vec3 ofAreas = byAreas * sight.areas;
    vec3 byLog = bySpreadX * sight.spreadX + bySpreadY * sight.spreadY +
                 vec3(ofAreas.y + ofAreas.z, ofAreas.z + ofAreas.x, ofAreas.x + ofAreas.y);
    result.logScale =
        vec3(gateOfLogScale(splat.logScale.x, byLog.x), gateOfLogScale(splat.logScale.y, byLog.y),
             gateOfLogScale(splat.logScale.z, byLog.z));

    // Rotation: the rows of J and their normal, taken along the splat's axes.
    vec3 d = sight.deviations;
    vec3 byAlongX = bySpreadX * d;
    vec3 byAlongY = bySpreadY * d;
    vec3 byAlongN = byAreas * vec3(d.y * d.z, d.z * d.x, d.x * d.y);
    SplatAxes byAxes;
    byAxes.x = sight.rowX * byAlongX.x + sight.rowY * byAlongY.x + sight.normal * byAlongN.x;
    byAxes.y = sight.rowX * byAlongX.y + sight.rowY * byAlongY.y + sight.normal * byAlongN.y;
    byAxes.z = sight.rowX * byAlongX.z + sight.rowY * byAlongY.z + sight.normal * byAlongN.z;
    result.rotation = quaternionGradient(splat.rotation, byAxes);

    // Position. With parallel rays J is the same everywhere.
    if (view.parallel != 0) {
        result.position = parallelPositionGradient(view, g);
        return result;
    }
    vec3 byRowX = fromAxes(sight.axes, byAlongX);
    vec3 byRowY = fromAxes(sight.axes, byAlongY);
    vec3 byNormal = fromAxes(sight.axes, byAlongN);
    result.position = perspectivePositionGradient(view, sight, g, byRowX, byRowY, byNormal);
    return result;
}
