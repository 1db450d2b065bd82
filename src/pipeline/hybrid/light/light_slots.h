// A radiance cache (light_in_space.h) as shaders/lib/light_cells.glsl looks it up: one table of slots, and
// the cells of all. Made on all cores.
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

    // A power of two, at least one of them free; open addressing from LightInSpace::hashOf on.
    std::span<const shared::LightSlot> slots() const { return {slots_.get(), slotCount_}; }
    // Six for each cell, and six where there are no cells: what a shader reads must have some size.
    std::span<const glm::vec4> cells() const { return {cells_.get(), cellCount_}; }

  private:
    // Not zeroed when they are made: at a gigabyte a second and core that would take longer than all else.
    std::unique_ptr<shared::LightSlot[]> slots_;
    std::size_t slotCount_;
    std::unique_ptr<glm::vec4[]> cells_;
    std::size_t cellCount_;
};

}  // namespace macula::hybrid
