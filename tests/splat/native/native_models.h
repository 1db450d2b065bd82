// Splats in the layout of the device, for native kernels without a device.
#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/splat/model/splat_components.h"
#include "shared/splat_frame.h"
#include "splat/draw/splat_kinds.h"

namespace macula::splat {

// As a SplatBuffer that has room for a few splats more.
struct NativeModel {
    explicit NativeModel(const Splats& splats)
        : degree(splats.shDegree), count(splats.size()), capacity(count + 3) {
        const std::vector<float> components = componentsOf(splats);
        parameters.assign(std::size_t(componentCount(degree)) * capacity, 0.0f);
        for (std::size_t k = 0; k < std::size_t(componentCount(degree)); ++k)
            for (std::size_t i = 0; i < count; ++i) parameters[k * capacity + i] = components[k * count + i];
    }

    shared::SplatFrame frameOf(const RasterView& view, const Blending& blending) const {
        return {.view = splatView(view, blending),
                .count = static_cast<std::uint32_t>(count),
                .capacity = static_cast<std::uint32_t>(capacity),
                .tiles = {},
                .tileRows = 0};
    }

    int degree;
    std::size_t count;
    std::size_t capacity;
    std::vector<float> parameters;
};

// A model of these splats, with colours of all kinds.
inline Splats modelOf(const std::vector<SingleSplat>& kinds, int degree) {
    Dice dice(23);
    Splats splats;
    splats.resize(kinds.size());
    splats.setShDegree(degree);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        splats.position[i] = kinds[i].position;
        splats.logScale[i] = kinds[i].logScale;
        splats.rotation[i] = kinds[i].rotation;
        splats.opacityLogit[i] = kinds[i].opacityLogit;
        splats.dc[i] = dice.vec3(-3, 3);
    }
    for (glm::vec3& sh : splats.sh) sh = dice.vec3(-0.3, 0.3);
    return splats;
}

}  // namespace macula::splat
