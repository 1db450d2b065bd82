// Handles of the clip in the 3D picture.
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "scene/camera/picture_rays.h"
#include "scene/clip/clip_handles.h"
#include "viewer/clip/clip_editing.h"
#include "viewer/overlay/picture_tool.h"

namespace macula::viewer {

// Faces and planes move along their normal, centre and corner across the line of sight; the handle of a
// radius is right of its centre. Nothing hides a handle. Session and editing outlive it.
class ClipHandlesTool : public QObject, public PictureTool {
  public:
    ClipHandlesTool(StudyEditor& session, ClipEditing& editing, QObject* parent = nullptr)
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
    struct Held {
        scene::PlacedHandle handle;
        glm::dvec3 grabbedMm;  // from the handle to the pointer, when it was grabbed
    };
    bool isUsable() const { return editing_.hasHandles() && session_.hasStudy(); }
    std::vector<scene::PlacedHandle> handles(const scene::PictureRays& rays) const;
    std::optional<scene::PlacedHandle> handleAt(const PicturePlace& place) const;
    std::optional<glm::dvec3> draggedTo(const scene::PlacedHandle& handle, const PicturePlace& place) const;
    void addLines(std::vector<ToolMark>& marks, const scene::PictureRays& rays) const;

    StudyEditor& session_;
    ClipEditing& editing_;
    std::optional<Held> held_;
    std::optional<scene::ClipHandle> pointed_;
};

}  // namespace macula::viewer
