#include "viewer/clip/voxel_cutting.h"

#include <algorithm>
#include <utility>

#include "scene/clip/scissor_mask.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

VoxelCutting::VoxelCutting(QObject* parent)
    : QObject(parent),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          Q_EMIT progressed(inWindowsLanguage(update.stage), update.fraction);
                      },
                  .ended = [this](const Result<std::optional<Mask>>& outcome) { onEnded(outcome); }}) {}

void VoxelCutting::setVolume(std::shared_ptr<const Volume> volume) {
    volume_ = std::move(volume);
    wanted_ = {};
    made_ = {};
    if (job_.cancel()) Q_EMIT ended();
}

void VoxelCutting::want(const std::vector<scene::ScissorCut>& scissors) {
    if (!volume_ || scissors == wanted_) return;
    wanted_ = scissors;
    if (job_.cancel()) Q_EMIT ended();
    if (wanted_ == made_.of) return;
    if (wanted_.empty()) {
        made_ = {};
        Q_EMIT changed();
        return;
    }
    // If cuts were only appended, continues from the mask of the earlier ones.
    const std::vector<scene::ScissorCut>& had = made_.of;
    const bool goesOn = had.size() < scissors.size() && std::equal(had.begin(), had.end(), scissors.begin());
    std::optional<Mask> from = goesOn ? made_.mask : std::nullopt;
    std::vector<scene::ScissorCut> cuts(scissors.begin() + std::ptrdiff_t(goesOn ? had.size() : 0),
                                        scissors.end());
    job_.start([volume = volume_, from = std::move(from), cuts = std::move(cuts)](Progress& progress) {
        return scene::scissorMask(from, cuts, *volume, progress);
    });
    Q_EMIT began();
}

void VoxelCutting::cancel() {
    if (!job_.cancel()) return;
    Q_EMIT ended();
    Q_EMIT refused(made_.of);
}

void VoxelCutting::onEnded(const Result<std::optional<Mask>>& outcome) {
    Q_EMIT ended();
    if (!outcome) {
        if (outcome.error().code != ErrorCode::cancelled) Q_EMIT failed(outcome.error());
        Q_EMIT refused(made_.of);
        return;
    }
    made_ = {.of = wanted_, .mask = *outcome};
    Q_EMIT changed();
}

}  // namespace macula::viewer
