// The presets that a person owns, those they marked, and those they used last: in memory, with what has to be
// written of each change. The built-in ones are read-only and not in here.
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

namespace macula::app {

// A preset of any kind: the name of a built-in one, or the id of one's own. No name is such an id.
using PresetRef = std::string;

struct UsedPreset {
    PresetRef preset;
    std::string modality;  // of the volume; may be empty

    bool operator==(const UsedPreset&) const = default;
};

// What was stored of all that.
struct StoredPresets {
    std::vector<OwnPreset> own;
    std::vector<PresetRef> favourites;
    std::vector<UsedPreset> lastUsed;  // the last one first
    std::size_t damaged = 0;           // that were set aside
    std::size_t unreadable = 0;        // that this version does not understand; they stay as they are
};

// A document of the store as it is to be; without JSON it is removed.
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

    // By title.
    const std::vector<std::shared_ptr<const OwnPreset>>& own() const { return own_; }
    std::shared_ptr<const OwnPreset> find(const PresetRef& ref) const;  // null: it is none of them
    bool isFavourite(const PresetRef& ref) const { return favourites_.contains(ref); }
    // Of this kind of image, the last one first. An empty modality: of any.
    std::vector<PresetRef> lastUsed(std::string_view modality) const;

    // What is stored joins what is here; of two of one name the stored one gets a number.
    void join(const StoredPresets& stored);

    // A copy under that name (checkedPresetName), which no other preset has; its id. The curve has to be one
    // that files can hold. usage or inputNotUsable.
    Result<PresetRef> add(std::string_view title, const TransferFunction& function,
                          std::optional<SeenLook> seen = std::nullopt);
    Result<void> rename(const PresetRef& own, std::string_view title);
    // The preset, for putBack; null: there was none.
    std::shared_ptr<const OwnPreset> remove(const PresetRef& own);
    // Under its id; where its name was taken meanwhile, with a number.
    void putBack(const OwnPreset& preset);
    void setFavourite(const PresetRef& ref, bool isFavourite);
    void noteUsed(const PresetRef& ref, std::string_view modality);

    // The name as it is kept, where it can be given; `own` is the preset that may have it now, or is empty.
    Result<std::string> freeName(std::string_view title, const PresetRef& own = {}) const;
    // `title`, or the first of "title (2)", "title (3)" that is free.
    std::string nearestFreeName(std::string_view title) const;

    // What has changed since this was asked last, in order.
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

}  // namespace macula::app
