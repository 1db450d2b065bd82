#include "viewer/viewport/picture_tools.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace macula::viewer {

void PictureTools::set(std::vector<PictureTool*> tools) {
    giveUp();
    std::erase(tools, nullptr);
    tools_ = std::move(tools);
}

bool PictureTools::wouldHold(const PicturePlace& place) const {
    return std::ranges::any_of(tools_, [&](PictureTool* tool) { return tool->point(place).has_value(); });
}

bool PictureTools::press(const PicturePlace& place) {
    const auto taker = std::ranges::find_if(tools_, [&](PictureTool* tool) { return tool->press(place); });
    if (taker == tools_.end()) return false;
    holder_ = *taker;
    return true;
}

void PictureTools::move(const PicturePlace& place) {
    if (holder_ != nullptr) holder_->move(place);
}

void PictureTools::release(const PicturePlace& place) {
    if (holder_ != nullptr) std::exchange(holder_, nullptr)->release(place);
}

void PictureTools::giveUp() {
    if (holder_ != nullptr) std::exchange(holder_, nullptr)->giveUp();
}

std::optional<Qt::CursorShape> PictureTools::cursorAt(const PicturePlace& place) const {
    std::optional<Qt::CursorShape> shape;
    for (PictureTool* tool : tools_) {
        if (!shape) shape = tool->point(place);
    }
    return shape;
}

bool PictureTools::turnWheel(double notches, const PictureGeometry& picture) const {
    return std::ranges::any_of(tools_, [&](PictureTool* tool) { return tool->turnWheel(notches, picture); });
}

std::vector<ToolMark> PictureTools::marks(const PictureGeometry& picture) const {
    std::vector<ToolMark> marks;
    for (const PictureTool* tool : tools_) std::ranges::copy(tool->marks(picture), std::back_inserter(marks));
    return marks;
}

}  // namespace macula::viewer
