// Edits the lights, from the panel and in the picture.
#pragma once

#include <QObject>
#include <QTimer>
#include <cstddef>
#include <memory>
#include <optional>

#include "scene/lights/edited_rig.h"
#include "viewer/editor/study_editor.h"

namespace macula::viewer {

// Holds which light is chosen, and proposes changed rigs to the session, which outlives it. A rig of the
// catalogue never changes: the first edit gives the state a rig of its own.
class LightsEditing : public QObject {
    Q_OBJECT

  public:
    explicit LightsEditing(StudyEditor& session, QObject* parent = nullptr);

    // Whether a study is open whose look has lights.
    bool isUsable() const;
    // The rig of the state, or the default rig of its look. Never null.
    std::shared_ptr<const trace::LightRig> rig() const;
    std::size_t chosen() const;  // 0 without a light
    void choose(std::size_t light);
    const trace::SoftLight* light() const;  // the chosen one; null: the rig has none

    // Handles are shown over the picture while the panel is open.
    bool hasHandles() const { return isPanelOpen_ && isUsable(); }
    void setPanelOpen(bool open);

    // The rig's frame and rotation as seen by that camera. Nothing for an unusable camera.
    std::optional<scene::LightStand> stand(const Camera& camera) const;
    void setCamera(const Camera& camera) { camera_ = camera; }

    // Replaces the chosen light; one undo step until the session's endDrag.
    Result<void> drag(const trace::SoftLight& light);
    void strengthen(double factor);        // an undo step, too, which ends after a pause
    Result<void> setSky(double radiance);  // an undo step, too; a black sky becomes grey
    // Returns to the rig that the state had when the drag began; null: the default lights.
    void dragBack(const std::shared_ptr<const trace::LightRig>& lights);
    // One step each.
    Result<void> add();  // adds and chooses a light from above the viewer's left shoulder
    Result<void> remove();
    Result<void> keepTo(trace::LightFrame frame);
    void use(std::shared_ptr<const trace::LightRig> rig);

  Q_SIGNALS:
    void changed();  // the rig, the chosen light, or whether handles are shown

  private:
    Result<void> propose(Result<trace::LightRig> rig, bool isDrag);

    StudyEditor& session_;
    Camera camera_;
    std::size_t chosen_ = 0;
    bool isPanelOpen_ = false;
    QTimer wheelEnds_;
};

}  // namespace macula::viewer
