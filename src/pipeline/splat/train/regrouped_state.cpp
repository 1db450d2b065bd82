#include "pipeline/splat/train/regrouped_state.h"

#include <cstdint>
#include <vector>

namespace macula::splat {

OptimizerState regroupedState(const OptimizerState& known, const Regrouped& regrouped,
                              std::size_t components) {
    const std::size_t before = known.steps.size();
    const std::size_t count = regrouped.source.size();
    OptimizerState state{.stepsDone = known.stepsDone,
                         .steps = std::vector<std::uint32_t>(count, 0),
                         .first = std::vector<float>(count * components, 0.0f),
                         .second = std::vector<float>(count * components, 0.0f)};
    for (std::size_t i = 0; i < count; ++i) {
        if (regrouped.isNew[i] != 0) continue;
        const std::size_t from = regrouped.source[i];
        state.steps[i] = known.steps[from];
        for (std::size_t k = 0; k < components; ++k) {
            state.first[k * count + i] = known.first[k * before + from];
            state.second[k * count + i] = known.second[k * before + from];
        }
    }
    return state;
}

}  // namespace macula::splat
