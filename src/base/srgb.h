// The transfer curve of sRGB (IEC 61966-2-1). Shaders have their own in shaders/lib/picture.glsl.
#pragma once

#include <cmath>
#include <concepts>

namespace macula {

// Both extend the curve above 1, and linearly below 0. The caller clamps to [0, 1] where it needs that.
template <std::floating_point T>
T decodedSrgb(T encoded) {
    return encoded <= T(0.04045) ? encoded / T(12.92) : std::pow((encoded + T(0.055)) / T(1.055), T(2.4));
}

template <std::floating_point T>
T encodedSrgb(T linear) {
    return linear <= T(0.0031308) ? T(12.92) * linear : T(1.055) * std::pow(linear, T(1) / T(2.4)) - T(0.055);
}

}  // namespace macula
