// How matter scatters light at a vertex of a path: like a cloud, like a surface, or as a mixture of both
// (Kroes, Post and Botha 2012, "Exposure Render: An Interactive Photo-Realistic Volume Rendering Framework").
// A surface is a white body under a thin rough coat: microfacets (GGX, Walter et al. 2007; their shadows by
// Smith, as Heitz 2014 has them) with Schlick's Fresnel term, and below it Lambert's law for light that the
// coat lets in and out again, so that a white body loses no light (Kelemen and Szirmay-Kalos 2001). A surface
// has two sides, and its normal points against the path.
//
// Needs, besides phase.glsl: params.anisotropy, params.surface*, and from src/pipeline/volume/coat.h
// params.coatAlbedo and params.coatMean.

struct Matter {
    vec3 albedo;
    vec3 normal;    // world, unit, against the path; 0 if surface is 0
    float surface;  // 0 to 1: the share of scattering that is a surface's
};

// Scattering of light from a path into one direction.
struct Scattering {
    vec3 perSr;      // fraction of the light, per steradian
    float pdfPerSr;  // of scatteredDirection() for this direction
};

// Cosines are clamped to this at grazing angles.
#define GRAZING 1e-4

// The fraction of light that a facet of the coat reflects at this cosine (Schlick).
float facetReflectance(float cosine) {
    float c = float(1.0) - clamp(cosine, float(0.0), float(1.0));
    float c2 = c * c;
    return params.surfaceReflectance + (float(1.0) - params.surfaceReflectance) * c2 * c2 * c;
}

// The fraction of light arriving at this cosine that the coat reflects, over all directions.
float coatAlbedo(float cosine) {
    float at = sqrt(clamp(cosine, float(0.0), float(1.0))) * float(kCoatSteps);
    int low = min(int(at), kCoatSteps - 1);
    return mix(params.coatAlbedo[low], params.coatAlbedo[low + 1], at - float(low));
}

// The probability that a path arriving at this cosine continues by reflection at the coat, not by scattering
// in the body below.
float coatChance(float cosine) {
    return clamp(coatAlbedo(cosine), float(0.05), float(0.95));
}

// Smith's auxiliary function Lambda for one direction: 1 / (1 + Lambda) of the facets' area is visible.
float smithLambda(float cosine) {
    float a2 = params.surfaceAlpha * params.surfaceAlpha;
    float tangent2 = float(1.0) / (cosine * cosine) - float(1.0);
    return float(0.5) * (sqrt(float(1.0) + a2 * max(tangent2, float(0.0))) - float(1.0));
}

// Scattering from a path along `from` into `to`, both unit, world.
Scattering scattering(Matter m, vec3 from, vec3 to) {
    float phase = phaseHenyeyGreenstein(dot(from, to), params.anisotropy);
    Scattering s = Scattering(m.albedo * phase, phase);
    for (bool asks = m.surface > float(0.0); asks; asks = false) {
        float before = max(-dot(from, m.normal), float(GRAZING));
        float after = dot(to, m.normal);
        vec3 between = to - from;
        vec3 facet = between / max(sqrt(dot(between, between)), float(1e-6));
        float cosine = max(dot(facet, m.normal), float(0.0));
        // 1 - cosine^2 (1 - alpha^2), without cancellation where the coat is smooth.
        vec3 across = facet - m.normal * cosine;
        float a2 = params.surfaceAlpha * params.surfaceAlpha;
        float d = dot(across, across) + cosine * cosine * a2;
        float facets = cosine > float(0.0) ? a2 / (float(PI) * d * d) : float(0.0);
        float hidden = smithLambda(before);
        float byCoat = coatChance(before);
        float coatPdf = facets / (float(4.0) * before * (float(1.0) + hidden));
        float bodyPdf = max(after, float(0.0)) * float(1.0 / PI);
        vec3 bySurface = vec3(0.0);
        if (after > float(GRAZING)) {
            float coat = facetReflectance(dot(facet, to)) * facets /
                         (float(4.0) * before * (float(1.0) + hidden + smithLambda(after)));
            float enters = (float(1.0) - coatAlbedo(before)) * (float(1.0) - coatAlbedo(after)) /
                           max(float(1.0) - params.coatMean, float(1e-3));
            bySurface = m.albedo * (enters * bodyPdf) + vec3(coat);
        }
        s.perSr = mix(s.perSr, bySurface, m.surface);
        s.pdfPerSr = mix(s.pdfPerSr, mix(bodyPdf, coatPdf, byCoat), m.surface);
    }
    return s;
}

// Samples the normal of a facet visible along `from` (Dupuy and Benyoub 2023, "Sampling visible GGX normals
// with spherical caps"); `a` and `b` complete `normal` to a frame.
vec3 facetSeen(vec3 normal, vec3 a, vec3 b, vec3 from, vec2 u) {
    float before = max(-dot(from, normal), float(GRAZING));
    vec3 stretched =
        normalize(vec3(-dot(from, a) * params.surfaceAlpha, -dot(from, b) * params.surfaceAlpha, before));
    float azimuth = float(2.0 * PI) * (u.x - float(0.5));  // as in samplePhase
    float z = (float(1.0) - u.y) * (float(1.0) + stretched.z) - stretched.z;
    float sine = sqrt(clamp(float(1.0) - z * z, float(0.0), float(1.0)));
    vec3 h = vec3(sine * cos(azimuth), sine * sin(azimuth), z) + stretched;
    h = normalize(vec3(h.x * params.surfaceAlpha, h.y * params.surfaceAlpha, max(h.z, float(1e-6))));
    return a * h.x + b * h.y + normal * h.z;
}

// Samples the direction after the vertex from cloud, coat or body; `u` in the unit square, `choice` in [0,
// 1).
vec3 scatteredDirection(Matter m, vec3 from, vec2 u, float choice) {
    vec3 to = vec3(0.0);
    // Loops, because lavapipe skips a loop that no lane enters, but executes the body of every if.
    for (bool cloud = choice >= m.surface; cloud; cloud = false) to = samplePhase(from, params.anisotropy, u);
    for (bool surface = choice < m.surface; surface; surface = false) {
        vec3 a;
        vec3 b;
        orthonormalFrame(m.normal, a, b);
        if (choice < m.surface * coatChance(max(-dot(from, m.normal), float(GRAZING)))) {
            vec3 facet = facetSeen(m.normal, a, b, from, u);
            to = from - facet * (float(2.0) * dot(from, facet));
        } else {
            float azimuth = float(2.0 * PI) * (u.x - float(0.5));  // as in samplePhase
            float radius = sqrt(u.y);
            to = a * (radius * cos(azimuth)) + b * (radius * sin(azimuth)) +
                 m.normal * sqrt(max(float(1.0) - u.y, float(0.0)));
        }
        to = normalize(to);
    }
    return to;
}
