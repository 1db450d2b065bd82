#include "pipeline/splat/files/spz_codes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/srgb.h"

namespace macula::splat::spz {

namespace {

constexpr float kColourScale = 0.15f;
constexpr std::uint32_t kMagnitudes = 511;  // 9 bits
constexpr double kMostOfSmaller = 0.70710678118654752;

std::uint8_t rounded(float value, bool& held) {
    const float whole = std::round(value);
    held = held && whole >= 0.0f && whole <= 255.0f;
    return static_cast<std::uint8_t>(std::clamp(whole, 0.0f, 255.0f));
}

// The index in our order (w, x, y, z) of each component in the file's order (x, y, z, w).
constexpr std::array<int, 4> kOurs{1, 2, 3, 0};

}  // namespace

std::uint8_t alphaByte(float opacityLogit) {
    bool held = true;
    return rounded(255.0f / (1.0f + std::exp(-opacityLogit)), held);
}

float opacityLogit(std::uint8_t byte) {
    const float opacity = std::clamp(static_cast<float>(byte), 0.25f, 254.75f) / 255.0f;
    return std::log(opacity / (1.0f - opacity));
}

std::uint8_t scaleByte(float logScale, bool& held) {
    return rounded(16.0f * (logScale + 10.0f), held);
}

float logScale(std::uint8_t byte) {
    return static_cast<float>(byte) / 16.0f - 10.0f;
}

std::uint8_t colourByte(float dc, bool& held) {
    return rounded(255.0f * (kColourScale * dc + 0.5f), held);
}

float dcOf(std::uint8_t byte) {
    return (static_cast<float>(byte) / 255.0f - 0.5f) / kColourScale;
}

std::uint8_t shByte(float sh, bool& held) {
    return rounded(128.0f * sh + 128.0f, held);
}

float shOf(std::uint8_t byte) {
    return (static_cast<float>(byte) - 128.0f) / 128.0f;
}

std::uint32_t rotationBits(const glm::vec4& rotation) {
    const glm::dvec4 q = glm::normalize(glm::dvec4(rotation));
    const auto at = [&](std::uint32_t i) { return q[kOurs[i]]; };
    std::uint32_t largest = 0;
    for (std::uint32_t i = 1; i < 4; ++i) {
        if (std::abs(at(i)) > std::abs(at(largest))) largest = i;
    }
    std::uint32_t bits = largest;
    for (std::uint32_t i = 0; i < 4; ++i) {
        if (i == largest) continue;
        const bool negative = at(i) * at(largest) < 0.0;
        const double size = std::min(std::abs(at(i)) / kMostOfSmaller, 1.0);
        bits = bits << 10 | (negative ? 1u : 0u) << 9 |
               static_cast<std::uint32_t>(std::lround(size * kMagnitudes));
    }
    return bits;
}

glm::vec4 rotationOf(std::uint32_t bits) {
    const std::uint32_t largest = bits >> 30;
    glm::dvec4 q(0.0);
    double sum = 0.0;
    for (std::uint32_t i = 4; i-- > 0;) {
        if (i == largest) continue;
        const double size = kMostOfSmaller * (bits & kMagnitudes) / kMagnitudes;
        q[kOurs[i]] = (bits & (kMagnitudes + 1)) != 0 ? -size : size;
        sum += size * size;
        bits >>= 10;
    }
    q[kOurs[largest]] = std::sqrt(std::max(0.0, 1.0 - sum));
    return glm::vec4(q);
}

glm::vec4 rotationOf(std::uint8_t x, std::uint8_t y, std::uint8_t z) {
    const glm::vec3 v = glm::vec3(x, y, z) / 127.5f - 1.0f;
    return {std::sqrt(std::max(0.0f, 1.0f - glm::dot(v, v))), v};
}

float encoded(float linear) {
    return encodedSrgb(linear);
}

float linearOf(float encoded) {
    return decodedSrgb(encoded);
}

float slope(float linear) {
    if (linear <= 0.0031308f) return 12.92f;
    return 1.055f / 2.4f * std::pow(linear, 1.0f / 2.4f - 1.0f);
}

}  // namespace macula::splat::spz
