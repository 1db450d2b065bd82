// Shows what the session's state says, now and after each change.
#pragma once

#include <QObject>

#include "viewer/editor/study_editor.h"

namespace macula::viewer {

// Calls `show` at once, and again for each other state or study as long as `shown` lives.
template <class Show>
void followState(StudyEditor& session, QObject* shown, Show show) {
    QObject::connect(&session, &StudyEditor::changed, shown, show);
    QObject::connect(&session, &StudyEditor::studyShown, shown, show);
    show();
}

}  // namespace macula::viewer
