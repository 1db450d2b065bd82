#include "viewer/clip/clip_editing.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "scene/clip/eye_cut.h"
#include "scene/clip/scissor_cut.h"

namespace macula::viewer {

namespace {

constexpr int kWheelPauseMs = 600;      // turns of the wheel until then are one undo step
constexpr double kStepsThrough = 50.0;  // of the wheel, from one end of the volume to the other

Error noStudy() {
    return {ErrorCode::usage,
            Text::verbatim(ClipEditing::tr("No study is open.").toStdString()),
            {},
            Text::verbatim(ClipEditing::tr("Open a study first.").toStdString())};
}

}  // namespace

ClipEditing::ClipEditing(StudyEditor& session, QObject* parent) : QObject(parent), session_(session) {
    wheelEnds_.setSingleShot(true);
    wheelEnds_.setInterval(kWheelPauseMs);
    // By then, a person may be dragging something else, whose step must go on.
    connect(&wheelEnds_, &QTimer::timeout, this, [this] {
        if (session_.undoText() == tr("Depth of the cut")) session_.endDrag();
    });
}

void ClipEditing::setShowsOnSlices(bool shows) {
    if (std::exchange(showsOnSlices_, shows) != shows) Q_EMIT changed();
}

void ClipEditing::setPanelOpen(bool open) {
    if (std::exchange(isPanelOpen_, open) != open) Q_EMIT changed();
}

void ClipEditing::setHandlesAskedFor(bool asked) {
    if (std::exchange(areAskedFor_, asked) != asked) Q_EMIT changed();
}

void ClipEditing::drag(const scene::ClipHandle& handle, const glm::dvec3& mm) {
    if (!session_.hasStudy()) return;
    const auto moved = scene::withHandleAt(state().clip, state().cuts, handle, mm, volume());
    if (!moved) return;
    session_.drag(tr("Clip"), [&](scene::StudyState& next) {
        next.clip = moved->clip;
        next.cuts = moved->cuts;
    });
}

Result<scene::EyeCut> ClipEditing::newEyeCut() const {
    if (!session_.hasStudy()) return noStudy();
    if (!scene::hasRoomForEyeCut(state().clip))
        return Error{ErrorCode::usage,
                     Text::verbatim(tr("The clip has six planes and no more.").toStdString()),
                     {},
                     Text::verbatim(tr("Remove one of them first, or begin without a clip.").toStdString())};
    return scene::eyeCut(camera_, 0.0, true, volume());
}

Result<void> ClipEditing::setEyeCut(bool cuts) {
    std::optional<scene::EyeCut> cut;
    if (cuts) {
        MACULA_TRY(cut, newEyeCut());
        if (const auto& crosshair = state().slices.crosshairMm)
            cut = scene::through(*cut, *crosshair, volume());
    }
    session_.change(tr("Cut from the eye"), [&](scene::StudyState& next) { next.cuts.eye = cut; });
    return {};
}

void ClipEditing::setFollowsCamera(bool follows) {
    if (!state().cuts.eye) return;
    session_.change(tr("Cut from the eye"),
                    [&](scene::StudyState& next) { next.cuts.eye->followsCamera = follows; });
    if (follows) setCamera(camera_);
}

void ClipEditing::dragEyeCut(double fromMiddleMm) {
    if (state().cuts.eye && session_.hasStudy())
        putEyeCut(scene::at(*state().cuts.eye, fromMiddleMm, volume()));
}

Result<void> ClipEditing::stepEyeCut(double steps) {
    std::optional<scene::EyeCut> cut = state().cuts.eye;
    const bool isNew = !cut;
    if (isNew) {
        MACULA_TRY(cut, newEyeCut());
    }
    if (!session_.hasStudy()) return noStudy();
    const ValueRange range = scene::eyeCutRangeMm(cut->plane.normal, volume());
    const double fromMm = isNew ? range.low : std::clamp(cut->fromMiddleMm, range.low, range.high);
    const double toMm = fromMm + steps * (range.high - range.low) / kStepsThrough;
    putEyeCut(scene::at(*cut, std::clamp(toMm, range.low, range.high), volume()));
    wheelEnds_.start();
    return {};
}

void ClipEditing::putEyeCut(const scene::EyeCut& cut) {
    session_.drag(tr("Depth of the cut"), [&](scene::StudyState& next) { next.cuts.eye = cut; });
}

void ClipEditing::setCamera(const Camera& camera) {
    camera_ = camera;
    const auto& eye = state().cuts.eye;
    if (!eye || !eye->followsCamera || !session_.hasStudy()) return;
    const auto cut = scene::eyeCut(camera_, eye->fromMiddleMm, true, volume());
    if (!cut || cut->plane.normal == eye->plane.normal) return;
    session_.follow([&](scene::StudyState& next) { next.cuts.eye = *cut; });
}

Result<void> ClipEditing::addScissorCut(scene::ScissorCut cut) {
    if (!session_.hasStudy()) return noStudy();
    MACULA_TRY_VOID(scene::validate(cut));
    if (state().cuts.scissors.size() >= scene::kMostScissorCuts)
        return Error{ErrorCode::usage,
                     Text::verbatim(tr("There are %1 cuts with the scissors, and no more are possible.")
                                        .arg(scene::kMostScissorCuts)
                                        .toStdString()),
                     {},
                     Text::verbatim(tr("Undo one of them first.").toStdString())};
    session_.change(tr("Scissors"),
                    [&](scene::StudyState& next) { next.cuts.scissors.push_back(std::move(cut)); });
    return {};
}

void ClipEditing::removeScissorCuts() {
    session_.change(tr("Remove cuts"), [](scene::StudyState& next) { next.cuts.scissors.clear(); });
}

}  // namespace macula::viewer
