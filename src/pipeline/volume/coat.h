// The coat of a rough surface (shaders/lib/scattering.glsl): how much light it reflects.
#pragma once

#include <array>

#include "pipeline/volume/transfer_function.h"
#include "shared/trace_params.h"

namespace macula {

struct Coat {
    // Directional albedo, 0 to 1, by the square root of the cosine between light and normal, in even steps
    // from 0 to 1.
    std::array<double, shared::kCoatPlaces> albedo{};
    double mean = 0.0;  // cosine-weighted mean of the albedo over the hemisphere

    bool operator==(const Coat&) const = default;
};

// The width of the distribution of facets (GGX).
inline double alphaOf(const Surface& surface) {
    return surface.roughness * surface.roughness;
}
Coat coatOf(const Surface& surface);

}  // namespace macula
