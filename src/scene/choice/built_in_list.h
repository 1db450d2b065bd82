// All presets that the program carries, and unique names for presets that become files.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/quality.h"
#include "pipeline/volume/clip_json.h"
#include "pipeline/volume/transfer_function.h"
#include "presets/imported_preset.h"

namespace macula::scene {

struct BuiltIns {
    std::vector<TransferFunction> presets;
    std::vector<trace::LightRig> lights;
    std::vector<ClipPreset> clips;
    std::vector<trace::Quality> qualities;  // the fastest first
};
Result<BuiltIns> builtIns();

// Names and titles; for presets also number, modality, unit, source, and whether they are fitted; for
// qualities also samples and bounces.
nlohmann::ordered_json toJson(const BuiltIns& all);

// The unit of a preset's values: "HU", or "raw".
std::string_view unitOf(const TransferFunction& preset);

// The presets of a file, in its order. Repeated names get "-2", "-3" and so on, so that each preset can be a
// file of its own.
std::vector<TransferFunction> withDifferentNames(std::span<const presets::ImportedPreset> imported);

}  // namespace macula::scene
