// The drawing of the session's volume in 3D, with the voxels that are hidden.
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "base/result.h"
#include "scene/drawing/drawing.h"
#include "scene/drawing/projection_windows.h"
#include "viewer/editor/study_editor.h"

namespace macula::viewer {

class HiddenVoxels;
class SegmentationKeeper;
class ShownAdditions;
class TableRemoval;
class VoxelCutting;

// Follows the session: clip, masks of hidden voxels, and additions, some of them computed in the background.
// Create it before other listeners of the session, because it must learn of a study first. Lives on the UI
// thread.
class ShownVolume : public QObject {
    Q_OBJECT

  public:
    // The session must outlive it.
    explicit ShownVolume(StudyEditor& session, QObject* parent = nullptr);

    scene::Drawing drawing() const { return drawingOf(session_.state(), clip_); }
    // The drawing of another state of the study, with the voxels that are hidden now.
    scene::Drawing drawingOf(const scene::StudyState& other) const;
    // The drawing of another phase of the study, on the same grid: as drawing(), but coloured segments, which
    // are of the open phase, are left out.
    scene::Drawing drawingOfPhase() const;
    bool hidesSomething() const { return clip_ != nullptr; }

    // The session's state with the table's removal as requested, even while the search still runs.
    scene::StudyState state() const;
    // Takes over another state of the open study as one undo step, without its camera. usage without a study,
    // inputNotUsable if it was saved for another series, or if its JSON text could not be read again.
    Result<void> take(const scene::StudyState& state);

    TableRemoval& table() { return *table_; }
    VoxelCutting& cutting() { return *cutting_; }
    SegmentationKeeper& segments() { return *segments_; }
    HiddenVoxels& hidden() { return *hidden_; }
    ShownAdditions& additions() { return *additions_; }

  Q_SIGNALS:
    void changed();  // drawing(), of the same study

  private:
    scene::Drawing drawingOf(const scene::StudyState& state, std::shared_ptr<const Clip> clip) const;
    scene::Drawing withoutAdditions(const scene::StudyState& state, std::shared_ptr<const Clip> clip) const;
    void onStudyShown();
    void onChanged(const scene::StudyState& before);
    void updateClip();
    void onHidden();
    void onNotHidden();  // corrects the state to the voxels that are hidden

    StudyEditor& session_;
    TableRemoval* table_;
    VoxelCutting* cutting_;
    HiddenVoxels* hidden_;
    SegmentationKeeper* segments_;
    ShownAdditions* additions_;
    // The choices behind the voxels that are hidden now.
    struct HiddenBy {
        bool leavesTableOut = false;
        std::vector<scene::ScissorCut> scissors = {};
        std::vector<scene::In3dOf> in3d = {};
    };
    HiddenBy hiddenBy_;
    std::shared_ptr<const Clip> clip_;  // null: nothing is hidden
    scene::SeriesWindows seriesWindows_;
};

}  // namespace macula::viewer
