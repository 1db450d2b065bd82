// The user's own presets, favourites and last used presets, in memory, with the documents to write after each
// change. Built-in presets are read-only and not in here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "live/store/own_preset.h"
#include "pipeline/volume/transfer_function.h"
#include "session/store_values.h"

namespace macula::live {

// Names a preset: the name of a built-in one, or the id of one's own. No built-in name looks like an id.
using PresetRef = std::string;

struct UsedPreset {
    PresetRef preset;
    std::string modality;  // modality of the volume; may be empty

    bool operator==(const UsedPreset&) const = default;
};

// The user's presets as the store holds them.
struct StoredPresets {
    std::vector<OwnPreset> own;
    std::vector<PresetRef> favourites;
    std::vector<UsedPreset> lastUsed;  // latest first
    std::size_t damaged = 0;           // documents that were set aside
    std::size_t unreadable = 0;        // documents of other versions; they stay in the store
};

// A document to write to the store; without JSON, to remove.
struct PresetDocument {
    session::DocumentKind kind = session::DocumentKind::preset;
    std::string name;
    std::optional<std::string> json;
};

inline constexpr std::size_t kMostLastUsed = 24;
inline constexpr std::size_t kMostOwnPresets = 500;

// Calls that fail change nothing.
class PresetShelf {
  public:
    explicit PresetShelf(const std::vector<std::shared_ptr<const TransferFunction>>& builtIn);

    // Own presets, by title.
    const std::vector<std::shared_ptr<const OwnPreset>>& own() const { return own_; }
    std::shared_ptr<const OwnPreset> find(const PresetRef& ref) const;  // null: not an own preset
    bool isFavourite(const PresetRef& ref) const { return favourites_.contains(ref); }
    // Presets last used for this modality, latest first. Empty: for any modality.
    std::vector<PresetRef> lastUsed(std::string_view modality) const;

    // Adds the stored presets. A stored one whose name is taken gets a number.
    void join(const StoredPresets& stored);

    // Adds a copy under that name (checkedPresetName), which no other preset may have, and returns its id.
    // Files must be able to hold the curve. Fails with usage or inputNotUsable.
    Result<PresetRef> add(std::string_view title, const TransferFunction& function,
                          std::optional<SeenLook> seen = std::nullopt);
    Result<void> rename(const PresetRef& own, std::string_view title);
    // Returns the preset, for putBack; null: there was none.
    std::shared_ptr<const OwnPreset> remove(const PresetRef& own);
    // Adds a removed preset under its old id; with a number if its name is taken by now.
    void putBack(const OwnPreset& preset);
    void setFavourite(const PresetRef& ref, bool isFavourite);
    void noteUsed(const PresetRef& ref, std::string_view modality);

    // The name as stored, if it is free; `own` is the preset that has it already, or empty. Fails with usage.
    Result<std::string> freeName(std::string_view title, const PresetRef& own = {}) const;
    // `title`, or the first of "title (2)", "title (3)" that is free.
    std::string nearestFreeName(std::string_view title) const;

    // The changes since the last call, in order.
    std::vector<PresetDocument> takeChanges();

  private:
    bool isTaken(std::string_view title, const PresetRef& own) const;
    std::string freeKey(std::string_view title, const PresetRef& own) const;
    void put(OwnPreset preset);

    std::set<std::string> builtInNames_;
    std::vector<std::string> builtInTitles_;
    std::vector<std::shared_ptr<const OwnPreset>> own_;
    std::set<PresetRef> favourites_;
    std::vector<UsedPreset> lastUsed_;
    std::vector<PresetDocument> changes_;
};

}  // namespace macula::live
