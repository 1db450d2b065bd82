#include "viewer/segmenting/segment_stroke.h"

#include <array>
#include <memory>
#include <new>
#include <utility>

#include "scene/segments/segmentation_settings.h"
#include "segment/brush.h"
#include "segment/voxel_sets.h"

namespace macula::viewer {

namespace {

constexpr std::array<std::uint8_t, 3> kEraseRgb{0, 0, 0};
constexpr double kStrokeOpacity = 0.6;

}  // namespace

bool SegmentStroke::press(const BrushTouch& at) {
    if (!session_.hasStudy() || work_.isEditing()) return false;
    if (work_.brush().mode == BrushMode::grow) {
        work_.growAt(at.mm);
        return false;
    }
    work_.dropPreview();
    const bool paints = work_.brush().mode == BrushMode::paint;
    if (paints && work_.segment() == nullptr) work_.addSegment({});
    if (work_.segment() == nullptr) return false;
    stroke_ = {};
    atMm_ = at.mm;
    drag(at);
    return true;
}

void SegmentStroke::drag(const BrushTouch& to) {
    if (!atMm_) return;
    segment::Stroke stroke{.fromMm = *atMm_, .toMm = to.mm, .radiusMm = work_.brush().radiusMm};
    if (work_.brush().inOneSlice) stroke.sliceNormal = to.normal;
    try {
        stroke_ = segment::united(stroke_,
                                  segment::voxelsUnder(stroke, volume().worldFromVoxel(), volume().size()));
    } catch (const std::bad_alloc&) {
        work_.refuseForMemory();
        return drop();
    }
    atMm_ = to.mm;
    showStroke();
}

void SegmentStroke::showStroke() {
    const study::LoadedSegment* now = work_.segment();
    slices::ShownSegment shown{.voxels = std::make_shared<const VoxelSet>(stroke_),
                               .label = {},
                               .rgb = kEraseRgb,
                               .opacity = kStrokeOpacity};
    if (work_.brush().mode == BrushMode::paint && now != nullptr) {
        const auto choice = scene::choiceOf(session_.state().segmentations, keeper_.own()->digest);
        shown.rgb = scene::choiceOf(choice, *work_.selected()).rgb.value_or(study::usualRgb(now->segment));
    }
    keeper_.setPreview(std::move(shown));
}

void SegmentStroke::release() {
    if (!atMm_) return;
    atMm_.reset();
    const VoxelSet stroke = std::exchange(stroke_, {});
    if (const study::LoadedSegment* now = work_.segment()) {
        try {
            if (work_.brush().mode == BrushMode::paint) {
                work_.commitVoxels(tr("Paint"), segment::united(*now->voxels, stroke), true);
            } else {
                work_.commitVoxels(tr("Erase"), segment::without(*now->voxels, stroke), true);
            }
        } catch (const std::bad_alloc&) {
            work_.refuseForMemory();
        }
    }
    keeper_.setPreview(std::nullopt);
}

void SegmentStroke::drop() {
    if (!atMm_) return;
    atMm_.reset();
    stroke_ = {};
    keeper_.setPreview(std::nullopt);
}

double SegmentStroke::radiusMm() const {
    return work_.brush().mode == BrushMode::grow ? 0.0 : work_.brush().radiusMm;
}

}  // namespace macula::viewer
