// Boxes of images that scroll together: by the place in the patient where images say it, across studies by
// the places at which a person linked them, and by counting images where they say none.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "dicom/stack/stack.h"

namespace macula::viewer {

class ImageBox;

class BoxLinks {
  public:
    bool isOn() const { return isOn_; }
    // What lies at one place is what the boxes show now; while they show the same series as when they were
    // linked, what they showed then.
    void link(const std::vector<ImageBox*>& boxes);
    void unlink();
    // The other boxes go where `moved` is. Does nothing while they are not linked.
    void follow(const ImageBox& moved, const std::vector<ImageBox*>& boxes) const;

  private:
    struct Start {
        const dicom::Stack* stack = nullptr;
        std::size_t place = 0;
    };
    const Start* startOf(const ImageBox& box) const;  // null: not linked

    bool isOn_ = false;
    std::map<const ImageBox*, Start> starts_;
};

}  // namespace macula::viewer
