// One light path from the eye: free flights, and at every vertex next-event estimation to the environment. Background
// is not part of the answer: a path that leaves the volume adds nothing, the light it could have met was added at its
// vertices.
//
// Needs, beside medium, walk, phase and environment: fetchAlbedo(entry), params.voxelFromWorld*, params.worldFrom*,
// params.bounces, params.anisotropy.

vec3 voxelsPerMm(vec3 worldDirection) {
    return params.voxelFromWorldX * worldDirection.x + params.voxelFromWorldY * worldDirection.y +
           params.voxelFromWorldZ * worldDirection.z;
}

vec3 worldFromEnvironment(vec3 direction) {
    return params.worldFromEnvironmentX * direction.x + params.worldFromEnvironmentY * direction.y +
           params.worldFromEnvironmentZ * direction.z;
}

// Visitor: to the first real collision (Woodcock tracking). Returns false when there is none.
bool freeFlight(INOUT(BrickWalk) walk, INOUT(Rng) rng, OUT(float) entry) {
    bool real = false;
    bool tentative = true;
    entry = float(0.0);
    while (tentative && !real) {
        tentative = nextTentative(walk, rng);
        if (tentative) {
            entry = entryAt(walkPosition(walk), rng);
            real = random01(rng) * walk.majorant < extinctionOfEntry(entry);
        }
    }
    return real;
}

// Below this a shadow ray goes on only with a probability in proportion, and its weight is made good.
#define ROULETTE_BELOW 0.1

// Visitor: an unbiased estimate of the transmittance to the end of the walk (ratio tracking).
float transmittance(INOUT(BrickWalk) walk, INOUT(Rng) rng) {
    float through = float(1.0);
    bool going = true;
    while (going) {
        going = nextTentative(walk, rng);
        if (going) {
            float extinction = extinctionOfEntry(entryAt(walkPosition(walk), rng));
            through *= float(1.0) - min(extinction / walk.majorant, float(1.0));
            if (through < float(ROULETTE_BELOW)) {
                going = random01(rng) * float(ROULETTE_BELOW) < through;
                through = going ? float(ROULETTE_BELOW) : float(0.0);
            }
        }
    }
    return through;
}

// Visitor: the distance in mm at which transmittance falls to one half, by a deterministic march of `stepMm`; negative
// when it does not.
float halfTransmittanceDistance(INOUT(BrickWalk) walk, float stepMm) {
    float remaining = float(0.69314718055994531);  // optical depth of one half
    float found = float(-1.0);
    bool inside = nextSegment(walk);
    while (inside && found < float(0.0)) {
        float length = walk.segmentEndMm - walk.distanceMm;
        int steps = max(int(ceil(length / stepMm)), 1);
        float step = length / float(steps);
        for (int i = 0; i < steps && found < float(0.0); ++i) {
            float atMm = walk.distanceMm + (float(i) + float(0.5)) * step;
            float depth = extinctionOfEntry(trilinearEntry(walk.origin + walk.direction * atMm)) * step;
            if (depth >= remaining) {
                found = walk.distanceMm + (float(i) + remaining / depth) * step;
            } else {
                remaining -= depth;
            }
        }
        inside = nextSegment(walk);
    }
    return found;
}

struct PathSample {
    vec3 radiance;   // premultiplied: 0 where nothing was met
    float coverage;  // 1 when the eye ray met matter
};

PathSample tracePath(vec3 origin, vec3 worldDirection, INOUT(Rng) rng) {
    PathSample result = PathSample(vec3(0.0), float(0.0));
    vec3 throughput = vec3(1.0);
    bool alive = true;
    for (int vertex = 0; alive && vertex < params.bounces; ++vertex) {
        BrickWalk walk = startWalk(origin, voxelsPerMm(worldDirection));
        float entry;
        alive = freeFlight(walk, rng, entry);
        if (alive) {
            result.coverage = float(1.0);
            origin = walkPosition(walk);
            throughput *= fetchAlbedo(int(entry + float(0.5)));

            EnvironmentSample light = sampleEnvironment(rng);
            vec3 toLight = worldFromEnvironment(light.direction);
            float visible = float(0.0);
            if (light.pdfPerSr > float(0.0)) {
                BrickWalk shadow = startWalk(origin, voxelsPerMm(toLight));
                visible = transmittance(shadow, rng) / light.pdfPerSr;
            }
            float phase = phaseHenyeyGreenstein(dot(worldDirection, toLight), params.anisotropy);
            result.radiance += throughput * light.radiance * (phase * visible);

            float strength = max(throughput.x, max(throughput.y, throughput.z));
            if (strength < float(ROULETTE_BELOW)) {
                alive = random01(rng) * float(ROULETTE_BELOW) < strength;
                throughput *= float(ROULETTE_BELOW) / max(strength, float(1e-30));
            }
            float u = random01(rng);
            worldDirection = samplePhase(worldDirection, params.anisotropy, u, random01(rng));
        }
    }
    return result;
}

// The eye ray through a point of the picture, in pixels from its top left corner: unit, world frame.
vec3 eyeDirection(vec2 pixel) {
    vec2 p = vec2(float(2.0) * pixel.x / float(params.imageSize.x) - float(1.0),
                  float(1.0) - float(2.0) * pixel.y / float(params.imageSize.y));
    return normalize(params.forward + params.right * p.x + params.up * p.y);
}
