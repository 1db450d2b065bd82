#include "pipeline/splat/train/training_state.h"

#include <algorithm>
#include <cmath>

#include "pipeline/splat/model/splat_components.h"

namespace macula::splat {

Result<void> TrainingState::validate() const {
    if (trainerVersion != kTrainerVersion)
        return Error{
            ErrorCode::inputNotUsable,
            Text("The training was begun by version {} of the trainer, and would go on otherwise "
                 "with version {}.",
                 trainerVersion, kTrainerVersion),
            {},
            Text("Go on with the Macula it was begun with, or train anew; its model can still be drawn.")};
    MACULA_TRY_VOID(splats.validate());
    const std::size_t count = splats.size();
    const std::size_t numbers = count * static_cast<std::size_t>(componentCount(splats.shDegree));
    const auto isView = [](const View& view) {
        return view.given != nullptr && std::isfinite(view.loss) && std::isfinite(view.l1);
    };
    const auto isMoment = [](float moment) { return std::isfinite(moment); };
    const auto isSquare = [](float moment) { return std::isfinite(moment) && moment >= 0.0f; };
    const auto isStatistic = [](const shared::SplatStatistics& s) {
        return std::isfinite(s.views) && std::isfinite(s.weight) && std::isfinite(s.pull) &&
               std::isfinite(s.mostWeight);
    };
    if (optimizer.steps.size() != count || optimizer.first.size() != numbers ||
        optimizer.second.size() != numbers || statistics.size() != count || options.capacity < count ||
        !std::all_of(optimizer.first.begin(), optimizer.first.end(), isMoment) ||
        !std::all_of(optimizer.second.begin(), optimizer.second.end(), isSquare) ||
        !std::all_of(statistics.begin(), statistics.end(), isStatistic) ||
        !std::all_of(views.begin(), views.end(), isView))
        return Error{ErrorCode::inputNotUsable,
                     Text("The state of the training is damaged: its parts do not belong together."),
                     {},
                     Text("Load it again, or train anew.")};
    return {};
}

}  // namespace macula::splat
