// The film of shaders/trace/film.glsl, as the host writes it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "pipeline/gpu/native_kernel.h"
#include "shared/trace_params.h"

namespace macula::trace {

struct NativeFilm {
    explicit NativeFilm(const gpu::NativeDispatch& dispatch)
        : sums(dispatch.binding<glm::vec4>(16)),
          lost(dispatch.binding<glm::vec4>(17)),
          counts(dispatch.binding<std::uint32_t>(18)),
          faults(dispatch.binding<std::uint32_t>(19)),
          squares(dispatch.binding<glm::vec2>(20)),
          plan(dispatch.binding<const shared::PlannedBlock>(21).first(dispatch.groups()[0])) {}

    std::span<glm::vec4> sums;
    std::span<glm::vec4> lost;
    std::span<std::uint32_t> counts;
    std::span<std::uint32_t> faults;  // as Film::Faults
    std::span<glm::vec2> squares;
    std::span<const shared::PlannedBlock> plan;
};

}  // namespace macula::trace
