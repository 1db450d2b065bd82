// Presets of a person's own, their favourites, and those used last, in the store of sessions. They belong to
// no study.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "live/store/preset_shelf.h"
#include "session/store.h"

namespace macula::app {

// Less than the store takes: a preset has two curves of at most 4096 points.
inline constexpr std::size_t kLargestPresetBytes = 4'000'000;

// Each favourite has a document, so that two windows do not undo each other's; those used last share one:
//   { "version": 1, "preset": "ct-bone" }
//   { "version": 1, "lastUsed": [{ "preset": "ct-bone", "modality": "CT" }] }
inline constexpr std::string_view kLastUsedDocument = "presets used last";
std::string favouriteDocumentName(const PresetRef& ref);
std::string favouriteJson(const PresetRef& ref);
std::string lastUsedJson(std::span<const UsedPreset> used);

// What is damaged is counted, set aside by the store, and left out; and so is what cannot be understood,
// which stays in the store for the version that wrote it. Fails only where the store itself does.
Result<StoredPresets> readStoredPresets(session::Store& store);

Result<void> writePresetDocument(session::Store& store, const PresetDocument& document);

}  // namespace macula::app
