// The presets, light rigs and clips that the window offers.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/look.h"
#include "pipeline/volume/clip_json.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::scene {

struct Catalogue {
    std::vector<std::shared_ptr<const TransferFunction>> presets;  // never empty
    std::vector<std::shared_ptr<const trace::LightRig>> lights;    // never empty
    std::vector<std::shared_ptr<const ClipPreset>> clips;
};

// The built-in ones, Macula's own first.
Result<Catalogue> builtInCatalogue();

// Finds a preset by name or number, and lights by name. Fails with usage when there is none; the hint lists
// the names.
Result<std::shared_ptr<const TransferFunction>> findPreset(const Catalogue& catalogue, std::string_view name);
Result<std::shared_ptr<const trace::LightRig>> findLights(const Catalogue& catalogue, std::string_view name);

// The default preset of a volume: presets::defaultTransfer, as in the `macula` command.
std::shared_ptr<const TransferFunction> presetFor(const Catalogue& catalogue, const Volume& volume);
// The default lights of a look.
std::shared_ptr<const trace::LightRig> defaultLights(const Catalogue& catalogue, trace::Look look);

}  // namespace macula::scene
