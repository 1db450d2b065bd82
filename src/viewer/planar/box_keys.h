// Carries out the keys that a person presses over a box of images.
#pragma once

#include "viewer/planar/planar_keys.h"

namespace macula::viewer {

class ImageBox;

// Of an empty box only those that concern all boxes act.
void pressKey(ImageBox& box, PlanarKey key);

}  // namespace macula::viewer
