#include "presets/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/parsing.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/embedded_files.h"

namespace macula::presets {

Result<std::vector<TransferFunction>> builtInPresets() {
    std::vector<TransferFunction> presets;
    for (const EmbeddedFile& file : transferFiles()) {
        MACULA_TRY(TransferFunction preset, transferFunctionFromJson(file.text, std::string(file.name)));
        presets.push_back(std::move(preset));
    }
    const auto place = [](const TransferFunction& preset) {
        return std::tuple(preset.source != "Macula", preset.number.value_or(0));
    };
    std::sort(presets.begin(), presets.end(),
              [&](const TransferFunction& a, const TransferFunction& b) { return place(a) < place(b); });
    return presets;
}

bool isMeant(const TransferFunction& preset, std::string_view typed) {
    return preset.name == lowerCase(std::string(typed)) ||
           (preset.number && fmt::to_string(*preset.number) == typed);
}

}  // namespace macula::presets
