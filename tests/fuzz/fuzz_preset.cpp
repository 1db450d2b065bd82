// Any bytes as a file of presets, in whatever format they look like: what is read is a preset that can be
// drawn, written and read again.
#include <string_view>

#include "fuzz/file_of_bytes.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/preset_file.h"

namespace macula::presets {
namespace {

// What stands behind these words is the colour table that a preset of Horos names; before them, the preset.
constexpr std::string_view kTableFollows = "<!-- the colour table -->";

bool isShare(double value) {
    return value >= 0.0 && value <= 1.0;
}

void check(const TransferFunction& function) {
    MACULA_CHECK(validate(function).ok());
    for (const double value : {-1e300, -1e9, 0.0, 0.3, 40.0, 1e9, 1e300}) {
        MACULA_CHECK(isShare(opacityAt(function, value)));
        MACULA_CHECK(isShare(gradientOpacityAt(function, std::max(value, 0.0))));
        const glm::dvec3 colour = colourAt(function, value);
        for (int c = 0; c < 3; ++c) MACULA_CHECK(isShare(colour[c]));
        MACULA_CHECK(extinctionPerMm(function, value) >= 0.0);
    }
    const std::string text = toJson(function);
    const auto again = transferFunctionFromJson(text, "written");
    MACULA_CHECK(again.ok());
    MACULA_CHECK(toJson(*again) == text);
}

void read(std::string_view text, std::string_view table, const char* where) {
    const auto presets =
        readPresets({text, where, "preset"}, [&](const std::string& name) -> Result<std::string> {
            if (name.empty())
                return Error{ErrorCode::inputNotUsable,
                             Text("There is no table without a name."),
                             {},
                             Text("Name it.")};
            return std::string(table);
        });
    if (!presets) {
        MACULA_CHECK(!presets.error().message.empty() && !presets.error().hint.empty());
        return;
    }
    MACULA_CHECK(!presets->empty());
    constexpr std::size_t kMostChecked = 20;  // more are alike
    for (std::size_t i = 0; i < std::min(presets->size(), kMostChecked); ++i) check((*presets)[i].function);
}

}  // namespace
}  // namespace macula::presets

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace macula::presets;
    static const bool isQuiet = (macula::log::setLevel(macula::log::Level::off), true);
    MACULA_CHECK(isQuiet);
    const std::string_view all(reinterpret_cast<const char*>(data), size);
    const std::size_t end = std::min(all.find(kTableFollows), size);
    const std::string_view table = end < size ? all.substr(end + kTableFollows.size()) : std::string_view();
    read(all.substr(0, end), table, "preset");
    return 0;
}
