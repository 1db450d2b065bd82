// Handles of the lights in the 3D picture.
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "viewer/lights/lights_editing.h"
#include "viewer/overlay/picture_tool.h"

namespace macula::viewer {

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
