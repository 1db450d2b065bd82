#include "viewer/volume/shown_volume.h"

#include <utility>

#include "scene/drawing/drawing_of.h"
#include "viewer/clip/voxel_cutting.h"
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/volume/hidden_voxels.h"
#include "viewer/volume/shown_additions.h"
#include "viewer/volume/table_removal.h"

namespace macula::viewer {

ShownVolume::ShownVolume(StudyEditor& session, QObject* parent)
    : QObject(parent),
      session_(session),
      table_(new TableRemoval(this)),
      cutting_(new VoxelCutting(this)),
      hidden_(new HiddenVoxels(this)) {
    connect(&session_, &StudyEditor::studyShown, this, &ShownVolume::onStudyShown);
    connect(&session_, &StudyEditor::changed, this, &ShownVolume::onChanged);
    segments_ = new SegmentationKeeper(session_, this);  // connected to the session after this
    additions_ = new ShownAdditions(session_, *segments_, this);
    connect(additions_, &ShownAdditions::changed, this, &ShownVolume::changed);
    // The state changes once the table is found.
    connect(table_, &TableRemoval::changed, this, [this] {
        session_.change(tr("Table"), [this](scene::StudyState& next) {
            next.leavesTableOut = table_->action().isChecked();
        });
        hidden_->set(HiddenVoxels::Part::table, table_->mask());
    });
    connect(cutting_, &VoxelCutting::changed, this,
            [this] { hidden_->set(HiddenVoxels::Part::scissors, cutting_->mask()); });
    // Corrects the state to the old mask: pictures and state agree, and an undo does not request the failed
    // one again.
    connect(cutting_, &VoxelCutting::refused, this, [this](const std::vector<scene::ScissorCut>& had) {
        const std::vector<scene::ScissorCut> asked = session_.state().cuts.scissors;
        session_.correct([&](scene::StudyState& each) {
            if (each.cuts.scissors == asked) each.cuts.scissors = had;
        });
    });
    connect(segments_, &SegmentationKeeper::maskMade, this,
            [this](const std::optional<Mask>& mask) { hidden_->set(HiddenVoxels::Part::segments, mask); });
    connect(hidden_, &HiddenVoxels::changed, this, &ShownVolume::onHidden);
    connect(hidden_, &HiddenVoxels::failed, this, &ShownVolume::onNotHidden);
}

scene::Drawing ShownVolume::drawingOf(const scene::StudyState& other) const {
    const auto& volume = session_.study().volume;
    return drawingOf(other, volume ? scene::clipOf(other, *volume, hidden_->mask()) : nullptr);
}

scene::Drawing ShownVolume::withoutAdditions(const scene::StudyState& state,
                                             std::shared_ptr<const Clip> clip) const {
    return scene::drawingOf(state, session_.catalogue(), seriesWindows_, session_.study().volume,
                            std::move(clip));
}

scene::Drawing ShownVolume::drawingOf(const scene::StudyState& state,
                                      std::shared_ptr<const Clip> clip) const {
    scene::Drawing drawing = withoutAdditions(state, std::move(clip));
    scene::setAdditions(drawing, additions_->additions());
    return drawing;
}

scene::Drawing ShownVolume::drawingOfPhase() const {
    scene::Drawing drawing = withoutAdditions(session_.state(), clip_);
    scene::setAdditions(drawing, additions_->ofPhases());
    return drawing;
}

scene::StudyState ShownVolume::state() const {
    scene::StudyState state = session_.state();
    state.leavesTableOut = table_->action().isChecked();
    return state;
}

Result<void> ShownVolume::take(const scene::StudyState& state) {
    if (!session_.hasStudy())
        return Error{ErrorCode::usage,
                     Text("No study is open."),
                     {},
                     Text("Open the study that the view is of first.")};
    const study::OpenedStudy& study = session_.study();
    MACULA_TRY_VOID(scene::checkSeries(state, study.seriesDigest, *study.volume, {}));
    // A state that cannot be read again would be lost as a whole the next time the study is opened.
    MACULA_TRY_VOID(scene::studyStateFromJson(toJson(state), {}));
    session_.change(tr("Open view"), [&](scene::StudyState& next) {
        const bool leavesTableOut = next.leavesTableOut;
        next = state;
        next.seriesDigest = study.seriesDigest;
        next.grid.reset();  // the state is for this grid now
        next.camera.reset();
        next.leavesTableOut = leavesTableOut;  // unchanged until the table is found
        if (!next.preset) next.preset = scene::presetFor(session_.catalogue(), *study.volume);
    });
    table_->ask(state.leavesTableOut);
    return {};
}

void ShownVolume::onStudyShown() {
    const auto& volume = session_.study().volume;
    table_->setVolume(volume);
    cutting_->setVolume(volume);
    hidden_->setVolume(volume);
    additions_->forget();
    hiddenBy_ = {};
    seriesWindows_.forget();
    clip_ = volume ? scene::clipOf(session_.state(), *volume, std::nullopt) : nullptr;
    cutting_->want(session_.state().cuts.scissors);
}

void ShownVolume::onChanged(const scene::StudyState& before) {
    const scene::StudyState now = session_.state();  // copied: the calls below may change it
    if (now.leavesTableOut != before.leavesTableOut) table_->ask(now.leavesTableOut);
    cutting_->want(now.cuts.scissors);
    if (now.clip != before.clip || now.cuts.eye != before.cuts.eye) return updateClip();
    Q_EMIT changed();
}

void ShownVolume::onHidden() {
    hiddenBy_ = {.leavesTableOut = session_.state().leavesTableOut,
                 .scissors = cutting_->madeOf(),
                 .in3d = segments_->madeIn3d()};
    updateClip();
}

// The old mask stays, and the state is corrected to it: menus and panels agree with the picture.
void ShownVolume::onNotHidden() {
    const scene::StudyState asked = session_.state();
    const std::vector<scene::In3dOf> askedIn3d = scene::in3dOf(asked.segmentations);
    session_.correct([&](scene::StudyState& each) {
        if (each.leavesTableOut != asked.leavesTableOut || each.cuts.scissors != asked.cuts.scissors ||
            scene::in3dOf(each.segmentations) != askedIn3d)
            return;
        each.leavesTableOut = hiddenBy_.leavesTableOut;
        each.cuts.scissors = hiddenBy_.scissors;
        each.segmentations = scene::withIn3d(each.segmentations, hiddenBy_.in3d);
    });
}

void ShownVolume::updateClip() {
    const auto& volume = session_.study().volume;
    clip_ = volume ? scene::clipOf(session_.state(), *volume, hidden_->mask()) : nullptr;
    Q_EMIT changed();
}

}  // namespace macula::viewer
