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

// Each controller of a feature keeps a copy. All of it lives until the window's destructor, which takes it
// down in an order of its own: a controller's destructor uses none of it.
struct WindowContext {
    QMainWindow& window;  // the parent of dialogs
    StudyEditor& session;
    ShownVolume& shown;
    Viewport& viewport;
    Notifications& notifications;
    StudyNotes& notes;
    FileDialogs& files;
    std::function<void()> focusPicture;  // the pane that last had the focus, or a shown one
    std::string device = {};             // as in gpu::chooseDevice
};

}  // namespace macula::viewer
