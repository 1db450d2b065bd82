// What hands do with a clip in the pictures, and what of it the pictures show.
#pragma once

#include <QObject>
#include <QTimer>

#include "base/camera.h"
#include "base/result.h"
#include "scene/clip/clip_handles.h"
#include "viewer/session/viewer_session.h"

namespace macula::viewer {

// Handles are there while the clip panel is open, or while somebody asks for them. Proposes clips to the
// session, which outlives it.
class ClipEditing : public QObject {
    Q_OBJECT

  public:
    explicit ClipEditing(ViewerSession& session, QObject* parent = nullptr);

    bool showsOnSlices() const { return showsOnSlices_; }
    void setShowsOnSlices(bool shows);
    bool hasHandles() const { return isPanelOpen_ || areAskedFor_; }
    void setPanelOpen(bool open);
    void setHandlesAskedFor(bool asked);

    // A drag, one step until the session's endDrag. What the clip refuses leaves it where it is.
    void drag(const app::ClipHandle& handle, const glm::dvec3& mm);

    // A cut across the line of sight through the cross-hair, or none any more. usage without a study, or
    // where the clip has no room for a plane.
    Result<void> setEyeCut(bool cuts);
    void setFollowsCamera(bool follows);
    void dragEyeCut(double fromMiddleMm);  // a drag likewise
    // Deeper by so many steps; from before all of the volume where there is no cut yet.
    Result<void> stepEyeCut(double steps);
    // The camera that pictures are seen from has come to rest: a cut that follows it goes along.
    void setCamera(const Camera& camera);

    // Fails as validate, and with usage where there are too many cuts.
    Result<void> addScissorCut(app::ScissorCut cut);
    void removeScissorCuts();

  signals:
    void changed();  // what the pictures show of it

  private:
    Result<app::EyeCut> newEyeCut() const;
    void putEyeCut(const app::EyeCut& cut);
    const Volume& volume() const { return *session_.study().volume; }
    const app::StudyState& state() const { return session_.state(); }

    ViewerSession& session_;
    Camera camera_;
    bool showsOnSlices_ = true;
    bool isPanelOpen_ = false;
    bool areAskedFor_ = false;
    QTimer wheelEnds_;
};

}  // namespace macula::viewer
