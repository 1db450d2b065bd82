// A radiance cache (light_in_space.h) in the form that shaders/lib/light_cells.glsl reads: one table of slots
// and one array of cells. Making it uses all cores.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <memory>
#include <span>

#include "pipeline/hybrid/light/light_in_space.h"
#include "shared/light_params.h"

namespace macula::hybrid {

class LightSlots {
  public:
    explicit LightSlots(const LightInSpace& light);

    // A hash table with open addressing that begins at LightInSpace::hashOf. Its size is a power of two, and
    // at least one slot is free.
    std::span<const shared::LightSlot> slots() const { return {slots_.get(), slotCount_}; }
    // Six means for each cell; six zeros without cells, because a shader's buffer must not be empty.
    std::span<const glm::vec4> cells() const { return {cells_.get(), cellCount_}; }

  private:
    // Made without zeroing: at a gigabyte a second and core that would take longer than all the rest.
    std::unique_ptr<shared::LightSlot[]> slots_;
    std::size_t slotCount_;
    std::unique_ptr<glm::vec4[]> cells_;
    std::size_t cellCount_;
};

}  // namespace macula::hybrid
