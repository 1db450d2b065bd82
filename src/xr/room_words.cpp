#include "xr/room_words.h"

#include <algorithm>

namespace macula::xr {

namespace {

constexpr std::string_view kMark = " (edited";  // " 2" from the second copy on; ")": see scene::ownCopy

// Where the mark of a copy begins; npos in other titles, such as a person's own.
std::size_t markOfCopy(std::string_view title) {
    const auto markAt = title.rfind(kMark);
    if (markAt == std::string_view::npos || !title.ends_with(')')) return std::string_view::npos;
    std::string_view number = title.substr(markAt + kMark.size());
    number.remove_suffix(1);
    const bool isCopy = number.empty() || (number.size() > 1 && number.front() == ' ' &&
                                           number.find_first_not_of("0123456789", 1) == number.npos);
    return isCopy ? markAt : std::string_view::npos;
}

}  // namespace

const std::string& RoomWords::of(RoomQuality chosen) const {
    if (chosen == RoomQuality::fast) return fast;
    return chosen == RoomQuality::fine ? fine : balanced;
}

std::string RoomWords::of(ClipTool tool) const {
    const scene::HandTool* shape = shapeOf(tool);
    return shape != nullptr ? say(shape->name) : nothing;
}

std::string RoomWords::ofTitle(std::string_view title) const {
    const auto markAt = markOfCopy(title);
    const std::string preset(title.substr(0, markAt));
    const auto known = titles.find(preset);
    std::string text = known == titles.end() ? preset : known->second;
    if (markAt != std::string_view::npos)
        text.append(" (").append(edited).append(title.substr(markAt + kMark.size()));
    return text;
}

std::string RoomWords::ofNumber(std::string number) const {
    std::ranges::replace(number, '.', decimalSign);
    return number;
}

std::string filled(std::string pattern, std::string_view what) {
    if (const auto place = pattern.find("%1"); place != std::string::npos) pattern.replace(place, 2, what);
    return pattern;
}

}  // namespace macula::xr
