// The radiance cache as LightInSpace::at reads it (src/pipeline/hybrid/light/light_in_space.h), from a hash
// table of slots and six texels for each cell, one for each side: the mean light and its weight. The
// including file declares `slots`, `cells` and a LitPush `push`.

const int kFarthestCell = 1 << 20;  // LightInSpace::kFarthest

// LightInSpace::hashOf.
uint scatteredKey(uvec2 key) {
    uint h = key.x * 0x9e3779b1u ^ key.y;
    h ^= h >> 16;
    h *= 0x85ebca6bu;
    h ^= h >> 13;
    h *= 0xc2b2ae35u;
    return h ^ h >> 16;
}

// The texel of the cell's first side; -1 if the cache has no light there.
int cellAt(ivec3 at) {
    uvec3 part = uvec3(at + ivec3(kFarthestCell));
    uvec2 key = uvec2(part.y << 21 | part.z, part.x << 10 | part.y >> 11);
    uint slot = scatteredKey(key) & push.slotMask;
    for (uint n = 0u; n <= push.slotMask; ++n) {
        LightSlot found = slots[slot];
        if (found.high == kFreeSlot) return -1;
        if (found.low == key.x && found.high == key.y) return 6 * int(found.cell);
        slot = (slot + 1u) & push.slotMask;
    }
    return -1;
}

// The radiance that leaves a position (in cells, relative to the eye) against `direction`; w is 0 where the
// eight cells around have no light.
vec4 lightAt(vec3 fromEye, vec3 direction) {
    vec3 place = push.eyePart + fromEye - vec3(0.5);
    vec3 low = floor(place);
    vec3 part = place - low;
    ivec3 first = push.eyeCell + ivec3(low);
    if (any(greaterThanEqual(abs(first), ivec3(kFarthestCell - 1)))) return vec4(0.0);
    vec3 along = direction * direction;
    ivec3 side = ivec3(0, 2, 4) + ivec3(lessThan(direction, vec3(0.0)));
    vec4 sum = vec4(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        ivec3 step = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
        int cell = cellAt(first + step);
        if (cell < 0) continue;
        vec3 near = mix(vec3(1.0) - part, part, vec3(step));
        float weight = near.x * near.y * near.z;
        for (int axis = 0; axis < 3; ++axis) {
            vec4 mean = texelFetch(cells, cell + side[axis]);
            float counts = weight * along[axis] * mean.w;
            sum += counts * vec4(mean.rgb, 1.0);
        }
    }
    return sum.w > 0.0 ? vec4(sum.rgb / sum.w, 1.0) : vec4(0.0);
}
