// What of the volume of a session is shown in 3D, and how.
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "base/result.h"
#include "scene/drawing/drawing.h"
#include "scene/drawing/projection_windows.h"
#include "viewer/session/viewer_session.h"

namespace macula::viewer {

class HiddenVoxels;
class SegmentationKeeper;
class ShownAdditions;
class TableRemoval;
class VoxelCutting;

// Follows the session: clip, what hides single voxels, and what is beside the volume, which are looked for in
// the background. Make it before whoever else listens to the session: it is the first to know of a study.
// Lives on the UI thread.
class ShownVolume : public QObject {
    Q_OBJECT

  public:
    // The session must outlive it.
    explicit ShownVolume(ViewerSession& session, QObject* parent = nullptr);

    app::Drawing drawing() const { return drawingOf(session_.state(), clip_); }
    // As another state of the study would be drawn, with the voxels hidden that are hidden now.
    app::Drawing drawingOf(const app::StudyState& other) const;
    bool hidesSomething() const { return clip_ != nullptr; }

    // The state of the session, with the table as it was asked for: it may still be searched.
    app::StudyState state() const;
    // Another state of the study that is open, as one step of undo; its camera is for who has one. usage when
    // none is open, inputNotUsable when it was saved of another series, or its text could not be read again.
    Result<void> take(const app::StudyState& state);

    TableRemoval& table() { return *table_; }
    VoxelCutting& cutting() { return *cutting_; }
    SegmentationKeeper& segments() { return *segments_; }
    HiddenVoxels& hidden() { return *hidden_; }
    ShownAdditions& additions() { return *additions_; }

  signals:
    void changed();  // drawing(), of the same study

  private:
    app::Drawing drawingOf(const app::StudyState& state, std::shared_ptr<const Clip> clip) const;
    void onStudyShown();
    void onChanged(const app::StudyState& before);
    void updateClip();
    void onHidden();
    void onNotHidden();  // what was asked for

    ViewerSession& session_;
    TableRemoval* table_;
    VoxelCutting* cutting_;
    HiddenVoxels* hidden_;
    SegmentationKeeper* segments_;
    ShownAdditions* additions_;
    // What the voxels are hidden by that are hidden now.
    struct HiddenBy {
        bool leavesTableOut = false;
        std::vector<app::ScissorCut> scissors = {};
        std::vector<app::In3dOf> in3d = {};
    };
    HiddenBy hiddenBy_;
    std::shared_ptr<const Clip> clip_;  // null: nothing is hidden
    app::SeriesWindows seriesWindows_;
};

}  // namespace macula::viewer
