// Finds the preset to edit: the copy of the chosen one.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "pipeline/volume/transfer_function.h"
#include "viewer/editor/study_editor.h"

namespace macula::viewer {

// A chosen preset never changes: the first edit makes a copy (scene::ownCopy), which later edits change.
// Needs no window.
class PresetCopies {
  public:
    using Preset = std::shared_ptr<const TransferFunction>;
    // The preset to which a reset returns.
    struct Chosen {
        Preset inState;   // null: not chosen; the volume decides
        Preset function;  // never null
    };
    struct Edited {
        Chosen chosen;
        TransferFunction function;  // the copy, perhaps not changed yet
        bool isInState = false;     // whether the state has the copy
    };

    explicit PresetCopies(const StudyEditor& session) : session_(session) {}  // outlives this

    void forget();  // call it for another study
    // The edited preset of the session's state. Needs a study.
    Edited edited();

  private:
    Preset presetShown();
    Chosen chosenFor(const Preset& preset) const;
    Preset inCatalogue(const std::string& name) const;
    std::set<std::string> takenNames(const Preset& original) const;

    const StudyEditor& session_;
    Preset byDefault_;                            // the volume's default preset; null: not asked yet
    std::map<std::string, Chosen> chosenByCopy_;  // by the copy's name, for this study
};

}  // namespace macula::viewer
