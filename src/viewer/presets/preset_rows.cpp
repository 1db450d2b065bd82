#include "viewer/presets/preset_rows.h"

#include <cstddef>
#include <optional>
#include <utility>

#include "scene/choice/preset_kinds.h"
#include "study/list/search_text.h"

namespace macula::viewer {

namespace {

constexpr std::size_t kMostLastUsedShown = 6;

}  // namespace

PresetRows::PresetRows(const StudyEditor& session, const PresetLibrary& library)
    : session_(session), library_(library) {}

void PresetRows::setFilter(const QString& text) {
    words_ = study::searchWords(text.toStdString());
}

bool PresetRows::toggle(PresetGroup group) {
    if (!words_.empty()) return false;
    if (folded_.erase(group) == 0) folded_.insert(group);
    return true;
}

std::set<PresetGroup> PresetRows::expanded() const {
    std::set<PresetGroup> expanded(kPresetGroups.begin(), kPresetGroups.end());
    if (words_.empty())
        for (const PresetGroup group : folded_) expanded.erase(group);
    return expanded;
}

std::set<live::PresetRef> PresetRows::favourites() const {
    std::set<live::PresetRef> favourites;
    for (const LibraryPreset& preset : presetsOf(PresetGroup::favourites)) favourites.insert(preset.ref);
    return favourites;
}

bool PresetRows::isFound(const LibraryPreset& preset) const {
    const TransferFunction& function = *preset.function;
    const std::string shown = shownTitle(preset).toStdString();  // in the language of the window
    return study::holdsAll(study::foldedForSearch(function.title + ' ' + shown + ' ' + function.name + ' ' +
                                                  scene::kindOf(function)),
                           words_);
}

std::vector<LibraryPreset> PresetRows::presetsOf(PresetGroup group) const {
    std::vector<LibraryPreset> presets;
    if (group == PresetGroup::own) return library_.own();
    if (group == PresetGroup::lastUsed) {
        const auto& volume = session_.study().volume;
        for (const live::PresetRef& ref : library_.shelf().lastUsed(volume ? volume->modality() : "")) {
            if (presets.size() == kMostLastUsedShown) break;
            if (auto preset = library_.find(ref)) presets.push_back(*std::move(preset));
        }
        return presets;
    }
    if (group == PresetGroup::favourites) {
        for (const auto& all : {library_.own(), library_.builtIn()})
            for (const LibraryPreset& preset : all)
                if (library_.shelf().isFavourite(preset.ref)) presets.push_back(preset);
        return presets;
    }
    for (const LibraryPreset& preset : library_.builtIn()) {
        if (library_.fits(*preset.function) == (group == PresetGroup::fitting)) presets.push_back(preset);
    }
    return presets;
}

std::vector<PresetRow> PresetRows::rows() const {
    const std::set<PresetGroup> shown = expanded();
    std::vector<PresetRow> rows;
    for (const PresetGroup group : kPresetGroups) {
        std::vector<LibraryPreset> presets = presetsOf(group);
        std::erase_if(presets, [this](const LibraryPreset& preset) { return !isFound(preset); });
        if (presets.empty()) continue;
        rows.push_back({.group = group, .preset = std::nullopt, .count = presets.size()});
        if (!shown.contains(group)) continue;
        for (LibraryPreset& preset : presets) rows.push_back({.group = group, .preset = std::move(preset)});
    }
    return rows;
}

}  // namespace macula::viewer
