#include "viewer/planar/box_links.h"

#include <algorithm>

#include "study/planar/linked_frames.h"
#include "viewer/planar/image_box.h"

namespace macula::viewer {

void BoxLinks::link(const std::vector<ImageBox*>& boxes) {
    const auto isStarted = [this](const ImageBox* box) {
        return !box->isShown() || startOf(*box) != nullptr;
    };
    const auto shown = std::ranges::count_if(boxes, &ImageBox::isShown);
    if (isOn_ && std::size_t(shown) == starts_.size() && std::ranges::all_of(boxes, isStarted)) return;
    isOn_ = true;
    starts_.clear();
    for (const ImageBox* box : boxes)
        if (box->isShown()) starts_[box] = {box->series().stack, box->place()};
}

void BoxLinks::unlink() {
    isOn_ = false;
    starts_.clear();
}

const BoxLinks::Start* BoxLinks::startOf(const ImageBox& box) const {
    const auto found = starts_.find(&box);
    const bool isSame = found != starts_.end() && box.isShown() && found->second.stack == box.series().stack;
    return isSame ? &found->second : nullptr;
}

void BoxLinks::follow(const ImageBox& moved, const std::vector<ImageBox*>& boxes) const {
    const Start* from = isOn_ ? startOf(moved) : nullptr;
    if (from == nullptr) return;
    for (ImageBox* box : boxes) {
        const Start* to = box == &moved ? nullptr : startOf(*box);
        if (to == nullptr) continue;
        const dicom::Frame& fromStart = from->stack->frames[from->place];
        const dicom::Frame& toStart = to->stack->frames[to->place];
        if (fromStart.plane && toStart.plane) {
            const auto shift = study::shiftMm(fromStart, toStart);
            if (!shift) continue;  // across each other: nothing to scroll to
            if (const auto place = study::linkedFrame(moved.placeFrame(), *to->stack, *shift))
                box->follow(*place);
        } else {
            const auto steps = std::ptrdiff_t(moved.place()) - std::ptrdiff_t(from->place);
            const auto last = std::ptrdiff_t(to->stack->frames.size()) - 1;
            box->follow(std::size_t(std::clamp(std::ptrdiff_t(to->place) + steps, std::ptrdiff_t{0}, last)));
        }
    }
}

}  // namespace macula::viewer
