// The coat of a rough surface (shaders/lib/scattering.glsl): how much of the light it reflects.
#pragma once

#include <array>

#include "pipeline/volume/transfer_function.h"
#include "shared/trace_params.h"

namespace macula {

struct Coat {
    // Of light that falls from one direction, by the root of its cosine to the normal, from 0 to 1 in even
    // steps; 0 to 1.
    std::array<double, shared::kCoatPlaces> albedo{};
    double mean = 0.0;  // of light from all sides alike: over the hemisphere with the cosine

    bool operator==(const Coat&) const = default;
};

// The width of the distribution of facets (GGX).
inline double alphaOf(const Surface& surface) {
    return surface.roughness * surface.roughness;
}
Coat coatOf(const Surface& surface);

}  // namespace macula
