// The rows of the gallery: presets in groups, without folded groups and presets that the filter rejects.
#pragma once

#include <QString>
#include <set>
#include <string>
#include <vector>

#include "viewer/editor/study_editor.h"
#include "viewer/presets/preset_library.h"
#include "viewer/presets/preset_list_model.h"

namespace macula::viewer {

// Needs no window. Looks for the words of the filter in title, name and kind of image.
class PresetRows {
  public:
    PresetRows(const StudyEditor& session, const PresetLibrary& library);  // both outlive this

    void setFilter(const QString& text);
    // Folds or expands a group. Does nothing and returns false during a filter, which expands all groups.
    bool toggle(PresetGroup group);

    std::set<PresetGroup> expanded() const;
    std::vector<PresetRow> rows() const;  // without empty groups
    std::set<live::PresetRef> favourites() const;

  private:
    std::vector<LibraryPreset> presetsOf(PresetGroup group) const;
    bool isFound(const LibraryPreset& preset) const;

    const StudyEditor& session_;
    const PresetLibrary& library_;
    std::vector<std::string> words_;  // the words of the filter
    std::set<PresetGroup> folded_{PresetGroup::others};
};

}  // namespace macula::viewer
