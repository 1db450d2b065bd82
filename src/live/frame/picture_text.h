// Text and marks that stand over the picture, as pixels.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <vector>

namespace macula::live {

// Each line and each mark has its own box, so that little of the picture is covered. A native window can have
// no widgets on top, so the code that shows the picture copies the boxes into it: a picture and its text
// always appear together. Never changes once made.
struct PictureText {
    VkExtent2D size{};                    // size of the image that holds all boxes
    std::vector<std::byte> rgba;          // 8 bits each, opaque; row by row
    std::vector<VkRect2D> boxes;          // in that image; not empty
    std::vector<VkOffset2D> places = {};  // where each box is in the picture; empty: as in the image
    // The picture size that this text is for: over a picture of another size (by more than 2 pixels) it is
    // not drawn. 0: over any size.
    VkExtent2D of{};
};

}  // namespace macula::live
