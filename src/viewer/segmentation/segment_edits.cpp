#include "viewer/segmentation/segment_edits.h"

#include <array>
#include <utility>

namespace macula::viewer {

SegmentEdits::SegmentEdits(StudyEditor& session, const SegmentationKeeper& keeper)
    : session_(session), keeper_(keeper) {}

scene::SegmentSettings SegmentEdits::settings(const SegmentId& id) const {
    return scene::choiceOf(scene::choiceOf(session_.state().segmentations, id.digest), *id.number);
}

bool SegmentEdits::isShown(const SegmentId& id) const {
    if (id.number) return settings(id).isVisible;
    return scene::choiceOf(session_.state().segmentations, id.digest).isShown;
}

std::optional<Segment> SegmentEdits::segment(const SegmentId& id) const {
    if (const study::LoadedSegment* there = loaded(id)) return there->segment;
    for (const study::FoundSegmentation& found : keeper_.found()) {
        if (found.digest != id.digest) continue;
        for (const Segment& each : found.header.segments)
            if (each.number == id.number) return each;
    }
    return std::nullopt;
}

const study::LoadedSegment* SegmentEdits::loaded(const SegmentId& id) const {
    const study::LoadedSegmentation* there = keeper_.loaded(id.digest);
    return there != nullptr ? there->segment(*id.number) : nullptr;
}

QColor SegmentEdits::colour(const SegmentId& id) const {
    const auto own = settings(id).rgb;
    const std::array<std::uint8_t, 3> rgb = own ? *own : study::usualRgb(segment(id).value_or(Segment{}));
    return {rgb[0], rgb[1], rgb[2]};
}

void SegmentEdits::apply(scene::StudyState& next, const SegmentId& id, const Edit& edit) {
    scene::SegmentSettings one = scene::choiceOf(scene::choiceOf(next.segmentations, id.digest), *id.number);
    edit(one);
    scene::choose(next.segmentations, id.digest, one);
}

void SegmentEdits::show(const SegmentId& id, bool isShown) {
    session_.change(tr("Segmentations"), [&](scene::StudyState& next) {
        if (id.number) return apply(next, id, [&](scene::SegmentSettings& one) { one.isVisible = isShown; });
        scene::SegmentationSettings whole = scene::choiceOf(next.segmentations, id.digest);
        whole.isShown = isShown;
        scene::choose(next.segmentations, std::move(whole));
    });
}

void SegmentEdits::setColour(const SegmentId& id, const QColor& rgb) {
    session_.change(tr("Colour"), [&](scene::StudyState& next) {
        apply(next, id, [&](scene::SegmentSettings& one) {
            one.rgb = {std::uint8_t(rgb.red()), std::uint8_t(rgb.green()), std::uint8_t(rgb.blue())};
        });
    });
}

void SegmentEdits::dragOpacity(const SegmentId& id, double scene::SegmentSettings::*opacity, double to) {
    session_.drag(tr("Opacity"), [&](scene::StudyState& next) {
        apply(next, id, [&](scene::SegmentSettings& one) { one.*opacity = to; });
    });
}

void SegmentEdits::setIn3d(const SegmentId& id, scene::In3d in3d, bool on) {
    editIn3d(tr("Segments in 3D"), id, on,
             [&](scene::SegmentSettings& one) { one.in3d = on ? in3d : scene::In3d::asIs; });
}

void SegmentEdits::setColoured(const SegmentId& id, bool on) {
    editIn3d(tr("Segment in colour"), id, on, [&](scene::SegmentSettings& one) { one.isColouredIn3d = on; });
}

void SegmentEdits::editIn3d(const QString& what, const SegmentId& id, bool needsShown, const Edit& edit) {
    session_.change(what, [&](scene::StudyState& next) {
        apply(next, id, edit);
        if (!needsShown) return;
        scene::SegmentationSettings whole = scene::choiceOf(next.segmentations, id.digest);
        whole.isShown = true;
        scene::choose(next.segmentations, std::move(whole));
    });
}

void SegmentEdits::centreOn(const SegmentId& id) {
    const study::LoadedSegment* there = loaded(id);
    if (there == nullptr || !there->centroidMm) return;
    const glm::dvec3 mm = *there->centroidMm;
    session_.change(tr("Cross-hair"), [&](scene::StudyState& next) { next.slices.crosshairMm = mm; });
}

}  // namespace macula::viewer
