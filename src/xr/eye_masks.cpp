#include "xr/eye_masks.h"

#include <algorithm>
#include <utility>

namespace macula::xr {

namespace {

constexpr int kMostBands = 64;

bool hasSameField(const Eye& a, const Eye& b) {
    return a.left == b.left && a.right == b.right && a.up == b.up && a.down == b.down;
}

}  // namespace

Result<void> EyeMasks::refresh(Session& session) {
    if (!session.hasNewMasks()) return {};
    std::vector<View> views(session.runtime().viewCount());
    for (std::size_t i = 0; i < views.size(); ++i) {
        MACULA_TRY(views[i].mask, session.maskOf(static_cast<std::uint32_t>(i)));
    }
    views_ = std::move(views);
    return {};
}

void EyeMasks::narrow(std::span<Eye> eyes) {
    for (std::size_t i = 0; i < std::min(eyes.size(), views_.size()); ++i) {
        View& view = views_[i];
        if (view.mask.isEmpty()) continue;
        if (!hasSameField(view.asked, eyes[i])) {
            view.asked = eyes[i];
            view.part = view.mask.visiblePartOf(eyes[i]);
        }
        const Pose pose = eyes[i].pose;
        eyes[i] = view.part;
        eyes[i].pose = pose;
    }
}

std::vector<std::vector<VisiblePart>> EyeMasks::partsOf(const EyePictures& pictures, std::size_t firstView) {
    std::vector<std::vector<VisiblePart>> parts;
    for (std::size_t i = 0; i < pictures.eyes.size() && firstView + i < views_.size(); ++i) {
        View& view = views_[firstView + i];
        const EyePicture& picture = pictures.eyes[i];
        if (!hasSameField(view.shown, picture.eye) || view.shownPx != picture.partPx) {
            view.shown = picture.eye;
            view.shownPx = picture.partPx;
            view.visible = bandsOf(view.mask.rowsOf(picture.eye, picture.partPx),
                                   (picture.partPx.y + kMostBands - 1) / kMostBands);
            // An empty mask must be an error of the headset: shows everything.
            if (view.visible.empty()) view.visible = {{glm::ivec2(0), picture.partPx}};
        }
        parts.push_back(view.visible);
    }
    return parts;
}

}  // namespace macula::xr
