#include "viewer/clip/voxel_cutting.h"

#include <algorithm>
#include <span>
#include <utility>

#include "app/study/shown_voxels.h"

namespace macula::viewer {

VoxelCutting::VoxelCutting(QObject* parent)
    : QObject(parent),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          emit progressed(QString::fromStdString(update.stage), update.fraction);
                      },
                  .ended = [this](const Result<std::optional<Mask>>& outcome) { onEnded(outcome); }}) {}

void VoxelCutting::setVolume(std::shared_ptr<const Volume> volume) {
    volume_ = std::move(volume);
    wanted_ = {};
    made_ = {};
    if (job_.cancel()) emit ended();
}

bool VoxelCutting::want(const std::optional<Mask>& others, const std::vector<app::ScissorCut>& scissors) {
    Wanted wanted{.others = others, .scissors = scissors};
    if (!volume_ || wanted == wanted_) return false;
    wanted_ = std::move(wanted);
    if (job_.cancel()) emit ended();
    if (wanted_ == made_.of) return false;
    if (scissors.empty()) {
        made_ = {.of = wanted_, .mask = others};
        return true;
    }
    // What the first cuts left is gone on with.
    const std::vector<app::ScissorCut>& had = made_.of.scissors;
    const bool goesOn = made_.of.others == others && had.size() < scissors.size() &&
                        std::equal(had.begin(), had.end(), scissors.begin());
    std::optional<Mask> from = goesOn ? made_.mask : others;
    std::vector<app::ScissorCut> cuts(scissors.begin() + std::ptrdiff_t(goesOn ? had.size() : 0),
                                      scissors.end());
    job_.start([volume = volume_, from = std::move(from), cuts = std::move(cuts)](Progress& progress) {
        return app::shownVoxels(from, cuts, *volume, progress);
    });
    emit began();
    // Until it is done, what is hidden besides is.
    if (!had.empty() || made_.of.others == others) return false;
    made_ = {.of = {.others = others, .scissors = {}}, .mask = others};
    return true;
}

void VoxelCutting::cancel() {
    if (!job_.cancel()) return;
    emit ended();
    refuse();
}

void VoxelCutting::onEnded(const Result<std::optional<Mask>>& outcome) {
    emit ended();
    if (!outcome) {
        if (outcome.error().code != ErrorCode::cancelled) emit failed(outcome.error());
        return refuse();
    }
    made_ = {.of = wanted_, .mask = *outcome};
    emit changed();
}

// Cuts that belong to what else was hidden before are not those of now.
void VoxelCutting::refuse() {
    const bool fits = made_.of.others == wanted_.others;
    emit refused(fits ? made_.of.scissors : std::vector<app::ScissorCut>());
}

}  // namespace macula::viewer
