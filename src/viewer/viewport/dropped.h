// What somebody drops on the window.
#pragma once

#include <QString>

class QDropEvent;
class QMimeData;

namespace macula::viewer {

struct Dropped {
    QString path;   // of the one folder or file; empty: see `count`
    int count = 0;  // of files and folders; only one can be opened
};

// Whether anything that could be opened is dropped, and that as a copy: who accepts a move makes the file
// manager delete what was dropped. Whether it is a folder is for the loader to find out: asking a slow disk
// from here would freeze the window.
bool acceptDrop(QDropEvent& event);

Dropped droppedBy(const QMimeData* data);

}  // namespace macula::viewer
