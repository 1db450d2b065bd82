// Text and marks that stand over the picture, as pixels.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <vector>

namespace macula::app {

// Each line, and each mark, has a box of its own, so that no more of the picture is covered than has to be. A
// native window can have no widgets on top of it: whoever shows the picture copies the boxes into it, and so
// a picture and its text are never seen without each other. Never changed after it was made.
struct PictureText {
    VkExtent2D size{};                    // of the image that holds all boxes
    std::vector<std::byte> rgba;          // 8 bits each, opaque; row by row
    std::vector<VkRect2D> boxes;          // in that image; not empty
    std::vector<VkOffset2D> places = {};  // of each from the top left of the picture; empty: as in the image
    // The picture that it means something for: over one of another size, but for rounding, it
    // is not shown. 0: over any.
    VkExtent2D of{};
};

}  // namespace macula::app
