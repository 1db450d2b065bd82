// Windows that a person has kept under a name, for values of one unit.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/volume.h"

namespace macula::scene {

struct OwnWindow {
    std::string name;      // a person's words, 1 to kLongestWindowName bytes
    DisplayWindow window;  // its explanation is not kept
    std::string unit;      // Volume::unitName of the values that it is for

    bool operator==(const OwnWindow&) const = default;
};
inline constexpr std::size_t kMostOwnWindows = 50;
inline constexpr std::size_t kLongestWindowName = 60;  // in UTF-8

// Writes the windows as JSON and leaves out what the reader would refuse:
//     { "windows": [ { "name": "Kidney", "center": 60, "width": 300, "function": "LINEAR", "unit": "HU" } ] }
std::string toJson(const std::vector<OwnWindow>& windows);
// Error: inputNotUsable; the message names the line or the key, the hint what was expected.
Result<std::vector<OwnWindow>> ownWindowsFromJson(std::string_view text);

// The windows for the unit of the volume, in the same order.
std::vector<OwnWindow> ownWindowsFor(const std::vector<OwnWindow>& all, const Volume& volume);

// Appends the window, in place of one with the same name and unit. Its name is cut at kLongestWindowName and
// trimmed. Error: usage if name or window is then not usable, or there are kMostOwnWindows already.
Result<std::vector<OwnWindow>> withOwnWindow(std::vector<OwnWindow> all, OwnWindow added);

}  // namespace macula::scene
