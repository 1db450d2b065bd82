// Edits the lights, from the panel and by handles in the 3D picture.
#pragma once

#include <QObject>
#include <QTimer>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "scene/lights/edited_rig.h"
#include "viewer/editor/study_editor.h"
#include "viewer/overlay/picture_tool.h"

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

// Each light is a handle on the dome over the picture (light_direction.h): in the middle the light shines
// from the viewer, on the dotted circle from the side, beyond it from behind. A drag moves the light; Shift
// and the wheel change the strength of the chosen one. Session and editing outlive it.
class LightsTool : public QObject, public PictureTool {
  public:
    LightsTool(StudyEditor& session, LightsEditing& editing, QObject* parent = nullptr)
        : QObject(parent), session_(session), editing_(editing) {}

    bool press(const PicturePlace& place) override;
    void move(const PicturePlace& place) override;
    void release(const PicturePlace& place) override;
    void giveUp() override;
    bool changesPicture() const override { return true; }
    std::optional<Qt::CursorShape> point(const PicturePlace& place) override;
    bool turnWheel(double notches, const PictureGeometry& picture) override;
    std::vector<ToolMark> marks(const PictureGeometry& picture) const override;

  private:
    std::optional<std::size_t> lightAt(const PicturePlace& place) const;
    std::vector<glm::dvec2> places(const PictureGeometry& picture) const;  // of the handles of all lights

    StudyEditor& session_;
    LightsEditing& editing_;
    std::optional<glm::dvec2> grabbed_;  // from the handle to the pointer, when it was grabbed
    glm::dvec2 pressedAt_{0.0};
};

}  // namespace macula::viewer
