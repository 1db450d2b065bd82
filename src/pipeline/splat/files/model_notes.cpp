#include "pipeline/splat/files/model_notes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include "pipeline/splat/files/text_lines.h"

namespace macula::splat {

namespace {

constexpr std::string_view kPrefix = "macula ";
constexpr std::array<std::string_view, kLowPasses.size()> kLowPassNames{"adaptive", "compensated", "classic",
                                                                        "mip"};  // indexed by LowPass

std::optional<glm::dvec3> threeNumbers(std::string_view text) {
    glm::dvec3 values(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), values[axis]);
        if (error != std::errc() || !std::isfinite(values[axis])) return std::nullopt;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (axis < 2) {
            if (!text.starts_with(' ')) return std::nullopt;
            text.remove_prefix(1);
        }
    }
    if (!text.empty()) return std::nullopt;
    return values;
}

Error notUnderstood(Text what) {
    return {ErrorCode::inputNotUsable,
            Text("The model is one of Macula's, but what it says about its {} is not understood.", what),
            {},
            Text("It is damaged or of a later version: export it again, or use a newer Macula.")};
}

// One of two values, by the word that stands for it.
template <class T>
std::optional<T> eitherOf(std::string_view word, std::string_view first, T a, std::string_view second, T b) {
    if (word == first) return a;
    if (word == second) return b;
    return std::nullopt;
}

}  // namespace

std::vector<std::string> notesOf(const Splats& splats) {
    const glm::dvec3& o = splats.originMm;
    return {
        "macula model 1",
        fmt::format("macula axes {}", splats.axes == Axes::patientLps ? "patient-lps-mm" : "unknown"),
        fmt::format("macula origin-mm {} {} {}", exactText(o.x), exactText(o.y), exactText(o.z)),
        fmt::format("macula colours {}", splats.colourSpace == ColourSpace::linear ? "linear" : "display"),
        fmt::format("macula low-pass {}", kLowPassNames[static_cast<std::size_t>(splats.lowPass)])};
}

Result<void> applyNotes(const std::vector<std::string>& lines, Splats& splats) {
    std::map<std::string, std::string, std::less<>> notes;
    for (std::string_view line : lines) {
        if (!line.starts_with(kPrefix)) continue;
        line.remove_prefix(kPrefix.size());
        const std::size_t space = std::min(line.find(' '), line.size());
        const std::string key(line.substr(0, space));
        const std::string value(line.substr(std::min(space + 1, line.size())));
        if (!notes.emplace(key, value).second) return notUnderstood(Text::verbatim(key));
    }
    if (notes.empty()) {
        splats.axes = Axes::unknown;
        splats.originMm = glm::dvec3(0.0);
        splats.colourSpace = ColourSpace::display;
        splats.lowPass = LowPass::classic;
        return {};
    }
    if (notes["model"] != "1") return notUnderstood(Text("version"));
    const auto axes = eitherOf(notes["axes"], "patient-lps-mm", Axes::patientLps, "unknown", Axes::unknown);
    if (!axes) return notUnderstood(Text("axes"));
    const auto origin = threeNumbers(notes["origin-mm"]);
    if (!origin) return notUnderstood(Text("origin"));
    const auto colours =
        eitherOf(notes["colours"], "linear", ColourSpace::linear, "display", ColourSpace::display);
    if (!colours) return notUnderstood(Text("colours"));
    const auto lowPass = std::find(kLowPassNames.begin(), kLowPassNames.end(), notes["low-pass"]);
    if (lowPass == kLowPassNames.end()) return notUnderstood(Text("low-pass"));
    splats.axes = *axes;
    splats.originMm = *origin;
    splats.colourSpace = *colours;
    splats.lowPass = static_cast<LowPass>(lowPass - kLowPassNames.begin());
    return {};
}

}  // namespace macula::splat
