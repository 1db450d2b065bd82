// What the tests of models and their files share.
#pragma once

#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <random>
#include <string>
#include <vector>

#include "pipeline/splat/model/splats.h"

namespace macula::splat::testing {

// Within what an SPZ file can hold: positions within 300 mm, scales 0.01 to 50 mm, colours 0 to 1, higher
// coefficients within 0.07 (which stay in reach when linear colours are encoded). Quaternions of any length.
inline Splats randomModel(std::size_t count, int degree, unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() >> 8) / 16777216.0f;
    };
    const auto three = [&](float low, float high) {
        const float x = between(low, high);
        const float y = between(low, high);
        return glm::vec3(x, y, between(low, high));
    };
    Splats splats;
    splats.shDegree = degree;
    splats.originMm = glm::dvec3(-12.25, 1.0 / 3.0, 1e5 + 0.1);
    splats.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        splats.position[i] = three(-300.0f, 300.0f);
        splats.logScale[i] = three(std::log(0.01f), std::log(50.0f));
        splats.rotation[i] = between(0.1f, 10.0f) * glm::vec4(three(-1.0f, 1.0f), between(0.01f, 1.0f));
        splats.opacityLogit[i] = between(-6.0f, 6.0f);
        splats.dc[i] = three(-1.7f, 1.7f);
    }
    for (glm::vec3& sh : splats.sh) sh = three(-0.07f, 0.07f);
    return splats;
}

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

inline bool sameBits(const Splats& a, const Splats& b) {
    return a.originMm == b.originMm && a.axes == b.axes && a.colourSpace == b.colourSpace &&
           a.lowPass == b.lowPass && a.shDegree == b.shDegree && sameBits(a.position, b.position) &&
           sameBits(a.logScale, b.logScale) && sameBits(a.rotation, b.rotation) &&
           sameBits(a.opacityLogit, b.opacityLogit) && sameBits(a.dc, b.dc) && sameBits(a.sh, b.sh);
}

// Of a unit quaternion w, x, y, z, from the textbook.
inline glm::dmat3 matrixOf(const glm::vec4& rotation) {
    const glm::dvec4 q = glm::normalize(glm::dvec4(rotation));
    const double w = q[0];
    const double x = q[1];
    const double y = q[2];
    const double z = q[3];
    return glm::transpose(glm::dmat3(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                                     2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                                     2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)));
}

// In mm^2, in the axes of the model.
inline glm::dmat3 covariance(const Splats& splats, std::size_t i) {
    const glm::dmat3 rotation = matrixOf(splats.rotation[i]);
    glm::dmat3 squares(0.0);
    for (int a = 0; a < 3; ++a) squares[a][a] = std::exp(2.0 * splats.logScale[i][a]);
    return rotation * squares * glm::transpose(rotation);
}

// Along a unit direction, not clamped at 0: the formulas of splats.h.
inline glm::dvec3 colourAlong(const Splats& splats, std::size_t i, const glm::dvec3& d) {
    const double x = d.x;
    const double y = d.y;
    const double z = d.z;
    const double basis[15] = {-0.48860251 * y,
                              0.48860251 * z,
                              -0.48860251 * x,
                              1.09254843 * x * y,
                              -1.09254843 * y * z,
                              0.31539157 * (2 * z * z - x * x - y * y),
                              -1.09254843 * x * z,
                              0.54627422 * (x * x - y * y),
                              -0.59004359 * y * (3 * x * x - y * y),
                              2.89061144 * x * y * z,
                              -0.45704580 * y * (4 * z * z - x * x - y * y),
                              0.37317633 * z * (2 * z * z - 3 * x * x - 3 * y * y),
                              -0.45704580 * x * (4 * z * z - x * x - y * y),
                              1.44530572 * z * (x * x - y * y),
                              -0.59004359 * x * (x * x - 3 * y * y)};
    glm::dvec3 colour = 0.5 + 0.28209479 * glm::dvec3(splats.dc[i]);
    const std::size_t count = shCount(splats.shDegree);
    for (std::size_t k = 0; k < count; ++k) colour += basis[k] * glm::dvec3(splats.sh[i * count + k]);
    return colour;
}

// Changes one to four bytes, cuts off or repeats a part: what a bad line or disk does, and worse.
inline std::string mutated(std::string bytes, std::mt19937& random) {
    const auto place = [&] { return bytes.empty() ? 0 : random() % bytes.size(); };
    const unsigned kind = random() % 8;
    if (kind == 0) {
        bytes.resize(place());
    } else if (kind == 1) {
        const std::size_t from = place();
        bytes.insert(place(), bytes.substr(from, random() % 40));
    } else if (kind == 2) {
        bytes.erase(place(), random() % 40);
    } else {
        for (unsigned k = 0; k < 1 + random() % 4 && !bytes.empty(); ++k)
            bytes[place()] = static_cast<char>(random() % 3 == 0 ? 255 * (random() % 2) : random());
    }
    return bytes;
}

}  // namespace macula::splat::testing
