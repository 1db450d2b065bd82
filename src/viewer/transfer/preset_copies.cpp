#include "viewer/transfer/preset_copies.h"

#include <algorithm>

#include "scene/choice/catalogue.h"
#include "scene/transfer/own_copy.h"
#include "scene/transfer/same_transfer.h"

namespace macula::viewer {

void PresetCopies::forget() {
    byDefault_.reset();
    chosenByCopy_.clear();
}

PresetCopies::Edited PresetCopies::edited() {
    const Preset preset = presetShown();
    Edited edited{.chosen = chosenFor(preset), .function = {}};
    edited.isInState = edited.chosen.function != preset;
    edited.function = edited.isInState ? *preset : scene::ownCopy(*preset, takenNames(preset));
    chosenByCopy_[edited.function.name] = edited.chosen;
    return edited;
}

PresetCopies::Preset PresetCopies::presetShown() {
    if (session_.state().preset) return session_.state().preset;
    if (!byDefault_) byDefault_ = scene::presetFor(session_.catalogue(), *session_.study().volume);
    return byDefault_;
}

PresetCopies::Chosen PresetCopies::chosenFor(const Preset& preset) const {
    const Chosen itself{.inState = session_.state().preset, .function = preset};
    if (const auto known = chosenByCopy_.find(preset->name); known != chosenByCopy_.end())
        return known->second;
    if (const Preset offered = inCatalogue(preset->name); offered && scene::isSame(*offered, *preset))
        return itself;
    // A copy from another run.
    if (const Preset original = inCatalogue(scene::copiedFrom(*preset)))
        return {.inState = original, .function = original};
    return itself;
}

PresetCopies::Preset PresetCopies::inCatalogue(const std::string& name) const {
    const auto& presets = session_.catalogue().presets;
    const auto found =
        std::ranges::find_if(presets, [&](const Preset& preset) { return preset->name == name; });
    return found == presets.end() ? nullptr : *found;
}

// Two presets of the same title get copies of different names; otherwise one could be reset to the other.
std::set<std::string> PresetCopies::takenNames(const Preset& original) const {
    std::set<std::string> taken;
    for (const Preset& preset : session_.catalogue().presets) taken.insert(preset->name);
    for (const auto& [name, chosen] : chosenByCopy_) {
        if (chosen.function != original) taken.insert(name);
    }
    return taken;
}

}  // namespace macula::viewer
