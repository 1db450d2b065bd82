// Files and folders dropped on the window.
#pragma once

#include <QString>

class QDropEvent;
class QMimeData;

namespace macula::viewer {

struct Dropped {
    QString path;   // the only folder or file; empty if there are more
    int count = 0;  // files and folders; only one can be opened
};

// Accepts a drop of local files or folders as a copy only, because after an accepted move the file manager
// deletes them. Leaves it to the loader whether it is a folder: a slow disk would freeze the window here.
bool acceptDrop(QDropEvent& event);

Dropped droppedBy(const QMimeData* data);

}  // namespace macula::viewer
