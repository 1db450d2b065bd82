// Safe file names for pictures of cameras that are named in a file of another program.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace macula::pictures {

// A distinct file name without extension for each request: only letters, digits, "._-" and non-ASCII
// characters, at most 120 bytes before the suffix. "left/0001.JPG" becomes "left_0001"; an absolute path
// keeps only its last part. A request without a usable character becomes "camera_" and its index from 0.
// Names that differ only in case count as equal: the second gets "_2".
std::vector<std::string> pictureNames(std::span<const std::string> requests);

}  // namespace macula::pictures
