// Clips of every kind, and chance.
#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "pipeline/volume/clip.h"

namespace macula::scenes {

class Chance {
  public:
    explicit Chance(std::uint32_t seed) : engine_(seed) {}
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    bool coin() { return between(0, 1) < 0.5; }
    glm::dvec3 inBox(const Box& box) {
        return {between(box.low.x, box.high.x), between(box.low.y, box.high.y),
                between(box.low.z, box.high.z)};
    }
    glm::dvec3 direction() {
        const double z = between(-1, 1);
        const double azimuth = between(0, 6.283185307179586);
        return {std::sqrt(1 - z * z) * std::cos(azimuth), std::sqrt(1 - z * z) * std::sin(azimuth), z};
    }

  private:
    std::mt19937 engine_;
};

// Somewhere around `box`, with some of the parts.
inline Clip anyClip(Chance& chance, const Box& box) {
    Clip clip;
    const double size = box.diagonal();
    const auto keep = [&] { return chance.coin() ? Keep::inside : Keep::outside; };
    if (chance.coin()) {
        const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), chance.between(0, 3), chance.direction());
        clip.box =
            OrientedBox{.centreMm = chance.inBox(box),
                        .axes = glm::dmat3(turn),
                        .halfSizeMm = {chance.between(0.05, 0.4) * size, chance.between(0.05, 0.4) * size,
                                       chance.between(0.05, 0.4) * size}};
        clip.ofBox = keep();
    }
    for (int i = 0; i < 6 && chance.between(0, 1) < 0.3; ++i) {
        const glm::dvec3 normal = chance.direction();
        clip.planes.push_back({normal, glm::dot(normal, chance.inBox(box)) - 0.1 * size});
    }
    if (chance.coin()) {
        const auto sign = [&] { return chance.coin() ? 1.0 : -1.0; };
        clip.cut = Octant{.pointMm = chance.inBox(box), .towards = {sign(), sign(), sign()}};
    }
    if (chance.coin()) {
        clip.ball = Ball{.centreMm = chance.inBox(box), .radiusMm = chance.between(0.1, 0.5) * size};
        clip.ofBall = keep();
    }
    return clip;
}

}  // namespace macula::scenes
