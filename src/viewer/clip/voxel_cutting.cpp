#include "viewer/clip/voxel_cutting.h"

#include <algorithm>
#include <utility>

#include "scene/clip/scissor_mask.h"
#include "viewer/language/core_words.h"

namespace macula::viewer {

VoxelCutting::VoxelCutting(QObject* parent)
    : QObject(parent),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          emit progressed(inWindowsLanguage(update.stage), update.fraction);
                      },
                  .ended = [this](const Result<std::optional<Mask>>& outcome) { onEnded(outcome); }}) {}

void VoxelCutting::setVolume(std::shared_ptr<const Volume> volume) {
    volume_ = std::move(volume);
    wanted_ = {};
    made_ = {};
    if (job_.cancel()) emit ended();
}

void VoxelCutting::want(const std::vector<scene::ScissorCut>& scissors) {
    if (!volume_ || scissors == wanted_) return;
    wanted_ = scissors;
    if (job_.cancel()) emit ended();
    if (wanted_ == made_.of) return;
    if (wanted_.empty()) {
        made_ = {};
        emit changed();
        return;
    }
    // What the first cuts left is gone on with.
    const std::vector<scene::ScissorCut>& had = made_.of;
    const bool goesOn = had.size() < scissors.size() && std::equal(had.begin(), had.end(), scissors.begin());
    std::optional<Mask> from = goesOn ? made_.mask : std::nullopt;
    std::vector<scene::ScissorCut> cuts(scissors.begin() + std::ptrdiff_t(goesOn ? had.size() : 0),
                                        scissors.end());
    job_.start([volume = volume_, from = std::move(from), cuts = std::move(cuts)](Progress& progress) {
        return scene::scissorMask(from, cuts, *volume, progress);
    });
    emit began();
}

void VoxelCutting::cancel() {
    if (!job_.cancel()) return;
    emit ended();
    emit refused(made_.of);
}

void VoxelCutting::onEnded(const Result<std::optional<Mask>>& outcome) {
    emit ended();
    if (!outcome) {
        if (outcome.error().code != ErrorCode::cancelled) emit failed(outcome.error());
        emit refused(made_.of);
        return;
    }
    made_ = {.of = wanted_, .mask = *outcome};
    emit changed();
}

}  // namespace macula::viewer
