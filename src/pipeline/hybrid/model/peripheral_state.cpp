#include "pipeline/hybrid/model/peripheral_state.h"

#include <algorithm>
#include <cmath>

namespace macula::hybrid {

namespace {

// Whether PicturePyramid::upload accepts it.
bool isPicture(const std::shared_ptr<const splat::TrainingView>& picture) {
    if (!picture || !splat::validate(picture->view).ok()) return false;
    const glm::ivec2& sizePx = picture->view.sizePx;
    return picture->pixels.size() ==
               static_cast<std::size_t>(sizePx.x) * static_cast<std::size_t>(sizePx.y) &&
           picture->weight > 0.0f && picture->weight <= splat::kMaxViewWeight;
}

bool areValidOrNone(const std::shared_ptr<const splat::Splats>& splats) {
    return !splats || splats->validate().ok();
}

}  // namespace

bool areUsable(const Box& seenMm, double gain) {
    const glm::dvec3 extentMm = seenMm.high - seenMm.low;
    return extentMm.x >= 0.0 && extentMm.y >= 0.0 && extentMm.z >= 0.0 && seenMm.diagonal() > 0.0 &&
           std::isfinite(seenMm.diagonal()) && std::isfinite(gain) && gain > 0.0;
}

Result<void> PeripheralState::validate() const {
    MACULA_TRY_VOID(training.validate());
    if (std::all_of(heldOut.begin(), heldOut.end(), isPicture) && areValidOrNone(shown) &&
        areValidOrNone(best) && areUsable(seenMm, gain) &&
        (first.capacity == 0 || first.key == training.options.key))
        return {};
    return Error{ErrorCode::inputNotUsable,
                 Text("The state of the peripheral model is damaged: its parts do not belong together."),
                 {},
                 Text("Load it again, or have it learnt anew.")};
}

}  // namespace macula::hybrid
