#include "viewer/viewport/dropped.h"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>

namespace macula::viewer {

bool acceptDrop(QDropEvent& event) {
    if (droppedBy(event.mimeData()).count == 0 || !event.possibleActions().testFlag(Qt::CopyAction)) {
        event.ignore();
        return false;
    }
    event.setDropAction(Qt::CopyAction);
    event.accept();
    return true;
}

Dropped droppedBy(const QMimeData* data) {
    Dropped dropped;
    if (data == nullptr) return dropped;
    for (const QUrl& url : data->urls()) {
        if (!url.isLocalFile()) continue;
        dropped.path = ++dropped.count == 1 ? url.toLocalFile() : QString();
    }
    return dropped;
}

}  // namespace macula::viewer
