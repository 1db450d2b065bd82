// All numbers of a model in one array, as kernels and files use them. Their order: shared/splat_layout.h.
#pragma once

#include <span>
#include <vector>

#include "pipeline/splat/model/splats.h"
#include "shared/splat_layout.h"

namespace macula::splat {

// Numbers for each splat: 14, 23, 38 or 59.
constexpr int componentCount(int shDegree) {
    return shared::kSplatSh + 3 * static_cast<int>(shCount(shDegree));
}
static_assert(componentCount(kMaxShDegree) == shared::kMaxSplatComponents);

// componentsOf returns all parameters of a model, component k of splat i at k * size + i; splatsOf makes a
// model of them, with the origin, axes, colour space, low-pass and degree of `like`. components.size() must
// be a multiple of componentCount.
std::vector<float> componentsOf(const Splats& splats);
Splats splatsOf(std::span<const float> components, const Splats& like);

}  // namespace macula::splat
