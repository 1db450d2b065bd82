// Asks for the window of slices in numbers.
#pragma once

class QWidget;

namespace macula::viewer {

class StudyEditor;

// Applies width and level, in the unit of the volume, while a person types; Cancel puts the window back.
// Returns at once.
void askForWindow(StudyEditor& session, QWidget* parent);

}  // namespace macula::viewer
