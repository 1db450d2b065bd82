// The tools of the 3D picture, and the tool that has taken hold of the drag.
#pragma once

#include <QCursor>
#include <optional>
#include <vector>

#include "viewer/overlay/picture_tool.h"

namespace macula::viewer {

// Asks the tools in their order; the caller owns them.
class PictureTools {
  public:
    void set(std::vector<PictureTool*> tools);  // null entries are ignored; gives up a hold

    bool isHolding() const { return holder_ != nullptr; }
    bool changesPicture() const { return holder_->changesPicture(); }  // whether the holding tool does
    bool wouldHold(const PicturePlace& place) const;                   // by their cursors; no tool takes hold
    bool press(const PicturePlace& place);                             // returns whether a tool took hold
    // The next three do nothing without a hold.
    void move(const PicturePlace& place);
    void release(const PicturePlace& place);
    void giveUp();

    // The cursor of the first tool that has one. Later tools do not see the pointer.
    std::optional<Qt::CursorShape> cursorAt(const PicturePlace& place) const;
    bool turnWheel(double notches, const PictureGeometry& picture) const;  // returns whether a tool used it
    std::vector<ToolMark> marks(const PictureGeometry& picture) const;

  private:
    std::vector<PictureTool*> tools_;
    PictureTool* holder_ = nullptr;
};

}  // namespace macula::viewer
