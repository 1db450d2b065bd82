#include "viewer/settings/window_place.h"

#include <QEvent>
#include <QGuiApplication>
#include <QScreen>
#include <QWidget>
#include <algorithm>
#include <utility>

namespace macula::viewer {

namespace {

constexpr qsizetype kShortestPlace = 40;  // bytes, as QWidget::saveGeometry writes them

}  // namespace

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
    // Qt would read missing bytes as zeros.
    if (!bytes || bytes.decoded.size() < kShortestPlace || !window.restoreGeometry(bytes.decoded))
        return false;
    if (window.isMaximized() || window.isFullScreen()) return true;  // the desktop knows how large that is
    const QScreen* screen = QGuiApplication::screenAt(window.geometry().center());
    if (screen == nullptr) screen = QGuiApplication::primaryScreen();
    if (screen == nullptr) return true;
    const QRect room = screen->availableGeometry();
    const QRect left = window.geometry();
    const QSize size = left.size().boundedTo(room.size());
    const QRect fitting(std::clamp(left.x(), room.x(), room.x() + room.width() - size.width()),
                        std::clamp(left.y(), room.y(), room.y() + room.height() - size.height()),
                        size.width(), size.height());
    if (fitting != left) window.setGeometry(fitting);
    return true;
}

}  // namespace macula::viewer
