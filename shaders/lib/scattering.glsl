// How matter scatters light at a vertex of a path: like a cloud, like a surface, or like both, each with its
// share (Kroes, Post and Botha 2012, "Exposure Render: An Interactive Photo-Realistic Volume Rendering
// Framework"). A surface is a white body under a thin rough coat: microfacets (GGX, Walter et al. 2007; their
// shadows by Smith, as Heitz 2014 has them) with Schlick's Fresnel term, and below them Lambert's law for
// what the coat lets in and out again, so that both together keep all light of a white body (Kelemen and
// Szirmay-Kalos 2001). It has two sides, and its normal points to where the path comes from.
//
// Needs, beside phase.glsl: params.anisotropy, params.surface*, and of src/pipeline/volume/coat.h
// params.coatAlbedo and params.coatMean.

struct Matter {
    vec3 albedo;
    vec3 normal;    // world, unit, against the path; 0 where surface is
    float surface;  // 0 to 1: what share of what is scattered is scattered by a surface
};

// Light that is scattered from a path into a direction.
struct Scattering {
    vec3 perSr;      // part of it, per steradian
    float pdfPerSr;  // with which scatteredDirection() finds the direction
};

// Cosines below this are grazing, and count as this.
#define GRAZING 1e-4

// What the coat reflects of light that falls on a facet with this cosine.
float facetReflectance(float cosine) {
    float c = float(1.0) - clamp(cosine, float(0.0), float(1.0));
    float c2 = c * c;
    return params.surfaceReflectance + (float(1.0) - params.surfaceReflectance) * c2 * c2 * c;
}

// The part of light that the coat reflects into all directions, of what falls on it with this cosine.
float coatAlbedo(float cosine) {
    float at = sqrt(clamp(cosine, float(0.0), float(1.0))) * float(kCoatSteps);
    int low = min(int(at), kCoatSteps - 1);
    return mix(params.coatAlbedo[low], params.coatAlbedo[low + 1], at - float(low));
}

// How likely a surface that is met with this cosine sends a path on by its coat, not by the body below.
float coatChance(float cosine) {
    return clamp(coatAlbedo(cosine), float(0.05), float(0.95));
}

// Smith's function of one direction: how many facets' areas stand in the way of what lies in the open,
// plus 1.
float smithLambda(float cosine) {
    float a2 = params.surfaceAlpha * params.surfaceAlpha;
    float tangent2 = float(1.0) / (cosine * cosine) - float(1.0);
    return float(0.5) * (sqrt(float(1.0) + a2 * max(tangent2, float(0.0))) - float(1.0));
}

// From a path along `from` into `to`, both unit, world.
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

// The normal of a facet, as often as it is seen along `from` (Dupuy and Benyoub 2023, "Sampling visible GGX
// normals with spherical caps"), in the frame of the normal and two across it.
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

// A direction after the vertex, by the shares of cloud, coat and body; `u` in the square, `choice` in [0, 1).
vec3 scatteredDirection(Matter m, vec3 from, vec2 u, float choice) {
    vec3 to = vec3(0.0);
    // lavapipe skips a loop that no lane enters, and executes the body of every if.
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
