// What the keys over a box of images do.
#pragma once

#include "viewer/planar/planar_keys.h"

namespace macula::viewer {

class ImageBox;

// Of an empty box only those that concern all boxes act.
void pressKey(ImageBox& box, PlanarKey key);

}  // namespace macula::viewer
