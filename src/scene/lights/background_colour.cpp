#include "scene/lights/background_colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/srgb.h"

namespace macula::scene {

namespace {

constexpr std::array<std::pair<std::string_view, BackgroundColour>, 3> kNamed{
    {{"black", kBlackBackground}, {"white", {255, 255, 255}}, {"grey", {128, 128, 128}}}};

}  // namespace

std::string hexOf(BackgroundColour colour) {
    return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

std::optional<BackgroundColour> colourOfHex(std::string_view text) {
    constexpr std::size_t kDigits = 2;
    if (text.size() != 1 + 3 * kDigits || text.front() != '#') return std::nullopt;
    BackgroundColour colour{};
    for (int channel = 0; channel < 3; ++channel) {
        const char* const from = text.data() + 1 + kDigits * std::size_t(channel);
        std::uint8_t value = 0;
        const auto read = std::from_chars(from, from + kDigits, value, 16);
        if (read.ec != std::errc() || read.ptr != from + kDigits) return std::nullopt;
        colour[channel] = value;
    }
    return colour;
}

Result<BackgroundColour> backgroundOf(std::string_view text) {
    const auto* const named = std::ranges::find(kNamed, text, &decltype(kNamed)::value_type::first);
    if (named != kNamed.end()) return named->second;
    if (const auto colour = colourOfHex(text)) return *colour;
    return Error{ErrorCode::usage, Text("The background is no colour."), std::string(text),
                 Text("Give black, white, grey, or red, green and blue as #rrggbb: #202830 is a dark blue.")};
}

glm::vec3 lightOf(BackgroundColour colour) {
    glm::vec3 light;
    for (int channel = 0; channel < 3; ++channel)
        light[channel] = float(decodedSrgb(double(colour[channel]) / 255.0));
    return light;
}

}  // namespace macula::scene
