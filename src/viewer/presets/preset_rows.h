// The rows of the gallery: presets in groups, as far as a filter finds them and groups are expanded.
#pragma once

#include <QString>
#include <set>
#include <string>
#include <vector>

#include "viewer/editor/study_editor.h"
#include "viewer/presets/preset_library.h"
#include "viewer/presets/preset_list_model.h"

namespace macula::viewer {

// Needs no window. The words of the filter are searched in title, name and kind of image.
class PresetRows {
  public:
    PresetRows(const StudyEditor& session, const PresetLibrary& library);  // both outlive this

    void setFilter(const QString& text);
    // Folds or expands a group; false: a filter shows all that it finds.
    bool toggle(PresetGroup group);

    std::set<PresetGroup> expanded() const;
    std::vector<PresetRow> rows() const;  // as they are now; an empty group has none
    std::set<live::PresetRef> favourites() const;

  private:
    std::vector<LibraryPreset> presetsOf(PresetGroup group) const;
    bool isFound(const LibraryPreset& preset) const;

    const StudyEditor& session_;
    const PresetLibrary& library_;
    std::vector<std::string> words_;  // of the filter
    std::set<PresetGroup> folded_{PresetGroup::others};
};

}  // namespace macula::viewer
