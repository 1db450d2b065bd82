// The scissors: an outline drawn over the 3D picture.
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "base/result.h"
#include "scene/clip/cuts.h"
#include "viewer/clip/clip_editing.h"
#include "viewer/overlay/picture_tool.h"

namespace macula::viewer {

// While the scissors are out, the left button draws. Its release removes everything behind the outline, or
// with Shift everything else. The editing outlives it.
class ScissorTool : public QObject, public PictureTool {
    Q_OBJECT

  public:
    explicit ScissorTool(ClipEditing& editing, QObject* parent = nullptr)
        : QObject(parent), editing_(editing) {}

    bool isOut() const { return isOut_; }
    void setOut(bool out);  // discards an unfinished outline

    bool press(const PicturePlace& place) override;
    void move(const PicturePlace& place) override;
    void release(const PicturePlace& place) override;
    void giveUp() override;
    bool changesPicture() const override { return false; }
    std::optional<Qt::CursorShape> point(const PicturePlace& place) override;
    bool turnWheel(double, const PictureGeometry&) override { return false; }
    std::vector<ToolMark> marks(const PictureGeometry& picture) const override;

  Q_SIGNALS:
    void drawn();  // the outline has changed
    void taken(bool out);
    void refused(const macula::Error& error);

  private:
    // In units of half the height of `picture`, over which it was begun.
    struct Outline {
        PictureGeometry picture;
        std::vector<glm::dvec2> points;
    };
    static glm::dvec2 halfHeights(const PicturePlace& place);
    bool isOver(const PictureGeometry& picture) const;

    ClipEditing& editing_;
    bool isOut_ = false;
    std::optional<Outline> outline_;
};

}  // namespace macula::viewer
