#include "viewer/volume/hidden_voxels.h"

#include <utility>
#include <vector>

#include "scene/clip/combined_mask.h"

namespace macula::viewer {

HiddenVoxels::HiddenVoxels(QObject* parent)
    : QObject(parent), job_(this, {.ended = [this](const Result<std::optional<Mask>>& outcome) {
                                if (outcome) {
                                    mask_ = *outcome;
                                    Q_EMIT changed();
                                } else {
                                    Q_EMIT failed(outcome.error());
                                }
                            }}) {}

void HiddenVoxels::setVolume(std::shared_ptr<const Volume> volume) {
    job_.cancel();
    volume_ = std::move(volume);
    parts_ = {};
    mask_.reset();
}

void HiddenVoxels::set(Part part, std::optional<Mask> mask) {
    std::optional<Mask>& place = parts_.at(std::size_t(part));
    const bool isSame = place == mask;
    place = std::move(mask);
    if (isSame && job_.running()) return;
    join();
}

void HiddenVoxels::join() {
    job_.cancel();
    std::vector<Mask> masks;
    for (const auto& part : parts_) {
        if (part) masks.push_back(*part);
    }
    if (masks.size() < 2 || !volume_) {
        mask_.reset();
        if (!masks.empty()) mask_ = masks.front();
        Q_EMIT changed();
        return;
    }
    job_.start([volume = volume_, masks = std::move(masks)](Progress& progress) {
        return scene::combinedMask(masks, *volume, progress);
    });
}

}  // namespace macula::viewer
