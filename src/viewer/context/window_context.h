// What the features of a window share.
#pragma once

#include <functional>
#include <string>

class QMainWindow;

namespace macula::viewer {

class FileDialogs;
class Notifications;
class ShownVolume;
class StudyEditor;
class StudyNotes;
class Viewport;

// Each controller of a feature keeps a copy. The objects live until the window's destructor, which destroys
// them in its own order, so a controller's destructor must use none of them.
struct WindowContext {
    QMainWindow& window;  // the parent of dialogs
    StudyEditor& session;
    ShownVolume& shown;
    Viewport& viewport;
    Notifications& notifications;
    StudyNotes& notes;
    FileDialogs& files;
    std::function<void()> focusPicture;  // focuses the last focused pane, or a shown one
    std::string device = {};             // its name, see gpu::chooseDevice
};

}  // namespace macula::viewer
