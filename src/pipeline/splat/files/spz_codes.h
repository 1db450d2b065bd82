// How SPZ stores single numbers: 8 bits for most, 24 for positions, 32 for a rotation. Each encoder accepts
// any finite number; `held` becomes false when the number had to be clamped.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace macula::splat::spz {

// Byte = 255 * opacity. 0 and 255 are read as opacities a quarter of a step inside, so that logits stay
// finite.
std::uint8_t alphaByte(float opacityLogit);
float opacityLogit(std::uint8_t byte);

// Byte = 16 * (ln scale + 10): from -10 to 5.9375 in steps of 1/16.
std::uint8_t scaleByte(float logScale, bool& held);
float logScale(std::uint8_t byte);

// Byte = 255 * (0.15 * dc + 0.5): dc from -3.33 to 3.33.
std::uint8_t colourByte(float dc, bool& held);
float dcOf(std::uint8_t byte);

// Byte = 128 * sh + 128: from -1 to 127/128.
std::uint8_t shByte(float sh, bool& held);
float shOf(std::uint8_t byte);

// Quaternions in the order w, x, y, z, of any length but 0. Three bytes (versions 1 and 2): x, y, z as 127.5
// * q + 127.5; w >= 0 follows from the unit length. 32 bits (version 3): bits 30 and 31 say which of x, y, z,
// w is the largest, which is positive and follows from the unit length; the others come in that order from
// the high bits down, each as a sign bit above 9 bits of magnitude in units of sqrt(1/2) / 511.
std::uint32_t rotationBits(const glm::vec4& rotation);
glm::vec4 rotationOf(std::uint32_t bits);
glm::vec4 rotationOf(std::uint8_t x, std::uint8_t y, std::uint8_t z);

// A linear colour as SPZ's readers expect colours, sRGB-encoded (IEC 61966-2-1, its line extended below 0 and
// its curve above 1), and back. `slope` is the derivative of `encoded` at the linear colour.
float encoded(float linear);
float linearOf(float encoded);
float slope(float linear);

}  // namespace macula::splat::spz
