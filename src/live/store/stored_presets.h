// The user's own presets, favourites and last used presets in the study store. They belong to no study.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "live/store/preset_shelf.h"
#include "session/store.h"

namespace macula::live {

// Below the store's limit: a preset has two curves of at most 4096 points.
inline constexpr std::size_t kLargestPresetBytes = 4'000'000;

// Each favourite has its own document, so that two windows do not conflict; last used ones share one:
//   { "version": 1, "preset": "ct-bone" }
//   { "version": 1, "lastUsed": [{ "preset": "ct-bone", "modality": "CT" }] }
inline constexpr std::string_view kLastUsedDocument = "presets used last";
std::string favouriteDocumentName(const PresetRef& ref);
std::string favouriteJson(const PresetRef& ref);
std::string lastUsedJson(std::span<const UsedPreset> used);

// Damaged documents are counted, set aside by the store, and left out. Documents that this version cannot
// read are counted and left out, and stay in the store. Fails only if the store itself does.
Result<StoredPresets> readStoredPresets(session::Store& store);

Result<void> writePresetDocument(session::Store& store, const PresetDocument& document);

}  // namespace macula::live
