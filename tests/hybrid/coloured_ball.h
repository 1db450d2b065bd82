// A ball, half of it red and half of it blue, under one light from the patient's left.
#pragma once

#include <memory>
#include <vector>

#include "pipeline/trace/environment.h"
#include "trace/extreme_scenes.h"

namespace macula::coloured_ball {

inline constexpr glm::ivec3 kSize{24, 24, 24};
inline constexpr glm::ivec2 kPicture{48, 40};

inline std::shared_ptr<const Volume> ball(std::uint16_t right, std::uint16_t left) {
    return scenes::volumeOf(kSize, scenes::grid(glm::dvec3(1.0), kSize), [=](int i, int j, int k) {
        const glm::dvec3 p = glm::dvec3(i, j, k) + 0.5 - glm::dvec3(kSize) / 2.0;
        if (glm::length(p) > 8.0) return std::uint16_t(0);
        return i < kSize.x / 2 ? right : left;
    });
}

inline TransferFunction matter(double opacity) {
    TransferFunction function = scenes::ramp(100, 200, opacity, 1.0);
    function.colour = {{400, {0.9, 0.2, 0.1}}, {600, {0.1, 0.2, 0.9}}};
    return function;
}

inline trace::Environment fromLeft() {
    std::vector<glm::vec3> sky(16 * 8, glm::vec3(0.2f));
    for (int row = 2; row < 6; ++row)
        for (int column = 0; column < 4; ++column) sky[std::size_t(row * 16 + column)] = glm::vec3(3.0f);
    return *trace::Environment::fromImage(16, 8, sky);
}

}  // namespace macula::coloured_ball
