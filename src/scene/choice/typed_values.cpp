#include "scene/choice/typed_values.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string_view>

#include "base/parsing.h"
#include "pipeline/trace/settings.h"

namespace macula::scene {

namespace {

// Numbers between commas, with a point in every locale; nothing for other text.
template <std::size_t count>
std::optional<std::array<double, count>> numbersIn(std::string_view text) {
    std::array<double, count> numbers{};
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t end = i + 1 < count ? text.find(',') : text.size();
        if (end == std::string_view::npos) return {};
        const auto number = finiteNumber(text.substr(0, end));
        if (!number) return {};
        numbers.at(i) = *number;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return numbers;
}

}  // namespace

Result<glm::ivec2> parseSize(const std::string& text) {
    glm::ivec2 size(0);
    int used = 0;
    // %n gives the count of characters read, to refuse "640x480garbage".
    const bool read = std::sscanf(text.c_str(), "%6dx%6d%n", &size.x, &size.y, &used) == 2 &&
                      used == static_cast<int>(text.size());
    if (!read || std::min(size.x, size.y) < 1 || std::max(size.x, size.y) > trace::kMaxPictureSide) {
        return Error{
            ErrorCode::usage, Text("The size of the picture is not usable."), text,
            Text("Give --size as WIDTHxHEIGHT in pixels, each from 1 to {}.", trace::kMaxPictureSide)};
    }
    return size;
}

Result<DisplayWindow> parseWindow(const std::string& text) {
    const auto read = numbersIn<2>(text);
    if (!read || !((*read)[1] > 0.0)) {
        return Error{ErrorCode::usage, Text("The window is not usable."), text,
                     Text("Give --window as CENTRE,WIDTH in units of the series, the width above 0.")};
    }
    return DisplayWindow{
        .center = (*read)[0], .width = (*read)[1], .explanation = {}, .function = "LINEAR_EXACT"};
}

Result<glm::vec3> parseBackground(const std::string& text) {
    const auto read = numbersIn<3>(text);
    const auto isShare = [](double v) { return v >= 0.0 && v <= 1.0; };
    if (!read || !std::ranges::all_of(*read, isShare)) {
        return Error{ErrorCode::usage, Text("The background is not usable."), text,
                     Text("Give --background as R,G,B, each from 0 to 1: 1,1,1 is white.")};
    }
    return glm::vec3((*read)[0], (*read)[1], (*read)[2]);
}

}  // namespace macula::scene
