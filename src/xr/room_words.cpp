#include "xr/room_words.h"

#include <algorithm>

namespace macula::xr {

const std::string& RoomWords::of(RoomQuality chosen) const {
    if (chosen == RoomQuality::fast) return fast;
    return chosen == RoomQuality::fine ? fine : balanced;
}

const std::string& RoomWords::of(ClipTool tool) const {
    if (tool == ClipTool::ball) return ball;
    return tool == ClipTool::box ? box : nothing;
}

std::string RoomWords::ofTitle(std::string_view title) const {
    constexpr std::string_view kMark = " (edited";  // and a number, see app::ownCopy
    const auto mark = title.rfind(kMark);
    const std::string preset(title.substr(0, mark));
    const auto known = titles.find(preset);
    std::string text = known == titles.end() ? preset : known->second;
    if (mark != std::string_view::npos)
        text.append(" (").append(edited).append(title.substr(mark + kMark.size()));
    return text;
}

std::string RoomWords::ofError(const std::string& sentence) const {
    const auto known = errors.find(sentence);
    return known == errors.end() ? sentence : known->second;
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
