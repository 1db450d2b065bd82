// Names for pictures of cameras that a file from elsewhere names.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace macula::app {

// One name for each wish, without ending, that is safe in any folder: no path, nothing but letters, digits,
// "._-" and what is not ASCII, at most 120 bytes. "left/0001.JPG" becomes "left_0001"; of a path from the
// root only the last part stays. A wish of which nothing is left becomes "camera_" and its number from 0.
// Names are different from each other, also for who does not tell upper case from lower: the second gets
// "_2".
std::vector<std::string> pictureNames(std::span<const std::string> wishes);

}  // namespace macula::app
