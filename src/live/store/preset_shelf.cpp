#include "live/store/preset_shelf.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <utility>

#include "live/store/stored_presets.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/preset_name.h"
#include "scene/transfer/own_copy.h"

namespace macula::live {

namespace {

using session::DocumentKind;

std::string newId() {
    std::random_device random;
    return fmt::format("own-{:08x}{:08x}", std::uint32_t(random()), std::uint32_t(random()));
}

// The function as it comes back from a file: if a file cannot hold it, the user must know now.
Result<TransferFunction> asFilesHoldIt(const TransferFunction& function) {
    const std::string text = toJson(function);
    auto read =
        text.size() > kLargestPresetBytes
            ? Result<TransferFunction>(Error{ErrorCode::inputNotUsable, Text("It is too large."), {}, {}})
            : transferFunctionFromJson(text, {});
    if (read) return read;
    return Error{ErrorCode::inputNotUsable,
                 Text("The preset cannot be kept: {}", read.error().message),
                 {},
                 read.error().hint.empty() ? Text("Choose another preset.") : read.error().hint};
}

}  // namespace

PresetShelf::PresetShelf(const std::vector<std::shared_ptr<const TransferFunction>>& builtIn) {
    for (const auto& preset : builtIn) {
        builtInNames_.insert(preset->name);
        builtInTitles_.push_back(preset->title);
    }
}

std::shared_ptr<const OwnPreset> PresetShelf::find(const PresetRef& ref) const {
    const auto found = std::ranges::find_if(own_, [&](const auto& preset) { return preset->id == ref; });
    return found == own_.end() ? nullptr : *found;
}

std::vector<PresetRef> PresetShelf::lastUsed(std::string_view modality) const {
    std::vector<PresetRef> refs;
    for (const UsedPreset& used : lastUsed_) {
        const bool isOfKind = modality.empty() || used.modality == modality;
        if (isOfKind && std::ranges::find(refs, used.preset) == refs.end()) refs.push_back(used.preset);
    }
    return refs;
}

bool PresetShelf::isTaken(std::string_view title, const PresetRef& own) const {
    const auto isSame = [&](std::string_view other) { return isSamePresetName(title, other); };
    return std::ranges::any_of(builtInTitles_, isSame) || std::ranges::any_of(builtInNames_, isSame) ||
           std::ranges::any_of(
               own_, [&](const auto& preset) { return preset->id != own && isSame(preset->title()); });
}

// A key as in files. Names in other scripts, such as Cyrillic, give no key of their own: a number tells them
// apart.
std::string PresetShelf::freeKey(std::string_view title, const PresetRef& own) const {
    const auto isUsed = [&](const std::string& key) {
        return builtInNames_.contains(key) || std::ranges::any_of(own_, [&](const auto& preset) {
                   return preset->id != own && preset->function->name == key;
               });
    };
    const std::string stem = presets::keyFrom(title);
    std::string key = stem;
    for (int number = 2; isUsed(key); ++number) key = fmt::format("{}-{}", stem, number);
    return key;
}

Result<std::string> PresetShelf::freeName(std::string_view title, const PresetRef& own) const {
    MACULA_TRY(std::string name, checkedPresetName(title));
    if (!isTaken(name, own)) return name;
    return Error{
        ErrorCode::usage, Text("There is a preset of that name already."), {}, Text("Choose another name.")};
}

std::string PresetShelf::nearestFreeName(std::string_view title) const {
    const std::string name = nearestPresetName(title);
    std::string free = name;
    for (int number = 2; isTaken(free, {}); ++number) {
        const std::string ending = fmt::format(" ({})", number);
        // Shortens the name until the ending fits.
        std::string begin = name;
        while (!checkedPresetName(begin + ending))
            begin = nearestPresetName(begin.substr(0, begin.size() - 1));
        free = begin + ending;
    }
    return free;
}

void PresetShelf::put(OwnPreset preset) {
    std::erase_if(own_, [&](const auto& other) { return other->id == preset.id; });
    const auto place =
        std::ranges::find_if(own_, [&](const auto& other) { return preset.title() < other->title(); });
    own_.insert(place, std::make_shared<const OwnPreset>(std::move(preset)));
}

void PresetShelf::join(const StoredPresets& stored) {
    for (OwnPreset preset : stored.own) {
        if (find(preset.id)) continue;
        TransferFunction function = *preset.function;
        function.title = nearestFreeName(function.title);
        function.name = freeKey(function.name, preset.id);
        preset.function = std::make_shared<const TransferFunction>(std::move(function));
        put(std::move(preset));
    }
    favourites_.insert(stored.favourites.begin(), stored.favourites.end());
    // What was used in this run comes before what was used in others.
    for (const UsedPreset& used : stored.lastUsed) {
        if (lastUsed_.size() < kMostLastUsed && std::ranges::find(lastUsed_, used) == lastUsed_.end())
            lastUsed_.push_back(used);
    }
}

Result<PresetRef> PresetShelf::add(std::string_view title, const TransferFunction& function,
                                   std::optional<SeenLook> seen) {
    MACULA_TRY(const std::string name, freeName(title));
    if (own_.size() >= kMostOwnPresets)
        return Error{ErrorCode::usage,
                     Text("There are too many presets of your own."),
                     {},
                     Text("Delete some first.")};
    MACULA_TRY_VOID(validate(function));
    // A copy already names its original; otherwise ownCopy notes it.
    TransferFunction copy =
        scene::copiedFrom(function).empty() ? scene::ownCopy(function, builtInNames_) : function;
    copy.title = name;
    copy.name = freeKey(name, {});
    copy.number.reset();
    MACULA_TRY(copy, asFilesHoldIt(copy));
    OwnPreset preset{.id = newId(),
                     .function = std::make_shared<const TransferFunction>(std::move(copy)),
                     .seen = std::move(seen)};
    // The settings that were seen have numbers too, such as the camera's, which may not survive a file.
    const auto read = ownPresetFromJson(preset.id, toJson(preset));
    if (!read)
        return Error{ErrorCode::inputNotUsable,
                     Text("What is seen cannot be kept: {}", read.error().message),
                     {},
                     read.error().hint};
    // The camera must survive unchanged, or the preset would show another picture the next day.
    if (read->seen && read->seen->camera != preset.seen->camera)
        return Error{ErrorCode::inputNotUsable,
                     Text("The camera cannot be kept: a part of it would be lost."),
                     {},
                     Text("Keep the curve alone.")};
    const PresetRef id = preset.id;
    changes_.push_back({DocumentKind::preset, id, toJson(preset)});
    put(std::move(preset));
    return id;
}

Result<void> PresetShelf::rename(const PresetRef& own, std::string_view title) {
    const auto preset = find(own);
    if (!preset)
        return Error{
            ErrorCode::usage, Text("A built-in preset cannot be renamed."), {}, Text("Save a copy of it.")};
    MACULA_TRY(const std::string name, freeName(title, own));
    OwnPreset renamed = *preset;
    TransferFunction function = *renamed.function;
    function.title = name;
    function.name = freeKey(name, own);
    renamed.function = std::make_shared<const TransferFunction>(std::move(function));
    changes_.push_back({DocumentKind::preset, own, toJson(renamed)});
    put(std::move(renamed));
    return {};
}

std::shared_ptr<const OwnPreset> PresetShelf::remove(const PresetRef& own) {
    auto preset = find(own);
    if (!preset) return nullptr;
    std::erase(own_, preset);
    changes_.push_back({DocumentKind::preset, own, std::nullopt});
    return preset;
}

void PresetShelf::putBack(const OwnPreset& preset) {
    OwnPreset back = preset;
    TransferFunction function = *back.function;
    if (isTaken(function.title, back.id)) function.title = nearestFreeName(function.title);
    function.name = freeKey(function.name, back.id);
    back.function = std::make_shared<const TransferFunction>(std::move(function));
    changes_.push_back({DocumentKind::preset, back.id, toJson(back)});
    put(std::move(back));
}

void PresetShelf::setFavourite(const PresetRef& ref, bool isFavourite) {
    const bool isChanged = isFavourite ? favourites_.insert(ref).second : favourites_.erase(ref) > 0;
    if (!isChanged) return;
    changes_.push_back({DocumentKind::favourite, favouriteDocumentName(ref),
                        isFavourite ? std::optional(favouriteJson(ref)) : std::nullopt});
}

void PresetShelf::noteUsed(const PresetRef& ref, std::string_view modality) {
    const UsedPreset used{ref, std::string(modality)};
    if (!lastUsed_.empty() && lastUsed_.front() == used) return;
    std::erase(lastUsed_, used);
    lastUsed_.insert(lastUsed_.begin(), used);
    if (lastUsed_.size() > kMostLastUsed) lastUsed_.resize(kMostLastUsed);
    changes_.push_back({DocumentKind::favourite, std::string(kLastUsedDocument), lastUsedJson(lastUsed_)});
}

std::vector<PresetDocument> PresetShelf::takeChanges() {
    return std::exchange(changes_, {});
}

}  // namespace macula::live
