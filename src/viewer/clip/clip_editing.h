// Edits the clip by drags in the pictures, and holds the handles and cuts that they show.
#pragma once

#include <QObject>
#include <QTimer>

#include "base/camera.h"
#include "base/result.h"
#include "scene/clip/clip_handles.h"
#include "viewer/editor/study_editor.h"

namespace macula::viewer {

// Handles are shown while the clip panel is open, or after setHandlesAskedFor(true). Proposes clips to the
// session, which outlives it.
class ClipEditing : public QObject {
    Q_OBJECT

  public:
    explicit ClipEditing(StudyEditor& session, QObject* parent = nullptr);

    bool showsOnSlices() const { return showsOnSlices_; }
    void setShowsOnSlices(bool shows);
    bool hasHandles() const { return isPanelOpen_ || areAskedFor_; }
    void setPanelOpen(bool open);
    void setHandlesAskedFor(bool asked);

    // Moves a handle to `mm` (patient LPS); a refused move does nothing. One undo step until endDrag.
    void drag(const scene::ClipHandle& handle, const glm::dvec3& mm);

    // Cuts across the line of sight through the cross-hair, or removes that cut. usage without a study, or
    // when the clip has no plane left.
    Result<void> setEyeCut(bool cuts);
    void setFollowsCamera(bool follows);
    void dragEyeCut(double fromMiddleMm);  // one undo step until endDrag, too
    // Moves the cut deeper by `steps`. A new cut starts in front of the whole volume.
    Result<void> stepEyeCut(double steps);
    // Call when the camera has come to rest: a cut that follows it turns with it.
    void setCamera(const Camera& camera);

    // Fails as scene::validate does, and with usage without a study or at kMostScissorCuts.
    Result<void> addScissorCut(scene::ScissorCut cut);
    void removeScissorCuts();

  Q_SIGNALS:
    void changed();  // whether the pictures show the clip or its handles

  private:
    Result<scene::EyeCut> newEyeCut() const;
    void putEyeCut(const scene::EyeCut& cut);
    const Volume& volume() const { return *session_.study().volume; }
    const scene::StudyState& state() const { return session_.state(); }

    StudyEditor& session_;
    Camera camera_;
    bool showsOnSlices_ = true;
    bool isPanelOpen_ = false;
    bool areAskedFor_ = false;
    QTimer wheelEnds_;
};

}  // namespace macula::viewer
