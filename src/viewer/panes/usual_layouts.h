// The panes that a person used last for images of each kind: of one modality and body part.
#pragma once

#include <QObject>
#include <optional>

#include "scene/state/study_state.h"
#include "viewer/editor/study_editor.h"

namespace macula::viewer {

class SettingsController;

// Kept with the settings, by a digest of the kind: files may have any text there. Lives on the UI thread.
class UsualLayouts : public QObject {
    Q_OBJECT

  public:
    // Both outlive it.
    UsualLayouts(StudyEditor& session, SettingsController& settings, QObject* parent);

    std::optional<scene::Layout> of(const Volume& volume) const;  // nothing: none was chosen yet

  private:
    void note(scene::Layout layout);

    StudyEditor& session_;
    SettingsController& settings_;
};

}  // namespace macula::viewer
