#include "viewer/settings/window_place.h"

#include <QEvent>
#include <QGuiApplication>
#include <QScreen>
#include <QWidget>
#include <algorithm>
#include <utility>

namespace macula::viewer {

WindowPlace::WindowPlace(QWidget& window, std::function<void(const QString&)> keep)
    : QObject(&window), window_(window), keep_(std::move(keep)) {
    window.installEventFilter(this);
}

bool WindowPlace::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &window_ && event->type() == QEvent::Close)
        keep_(QString::fromLatin1(window_.saveGeometry().toBase64()));
    return QObject::eventFilter(watched, event);
}

bool placeWindow(QWidget& window, const QString& place) {
    const auto bytes =
        QByteArray::fromBase64Encoding(place.toLatin1(), QByteArray::AbortOnBase64DecodingErrors);
    if (place.isEmpty() || !bytes || !window.restoreGeometry(*bytes)) return false;
    if (window.isMaximized() || window.isFullScreen()) return true;  // the desktop knows how large that is
    const QScreen* screen = QGuiApplication::screenAt(window.geometry().center());
    if (screen == nullptr) screen = QGuiApplication::primaryScreen();
    if (screen == nullptr) return true;
    const QRect room = screen->availableGeometry();
    window.resize(window.size().boundedTo(room.size()));
    const QRect now(window.pos(), window.size());
    window.move(std::clamp(now.x(), room.x(), room.x() + room.width() - now.width()),
                std::clamp(now.y(), room.y(), room.y() + room.height() - now.height()));
    return true;
}

}  // namespace macula::viewer
