#include "viewer/planar/planar_keys.h"

#include <QEvent>
#include <QKeyEvent>
#include <QWidget>
#include <algorithm>
#include <array>
#include <utility>

namespace macula::viewer {

namespace {

constexpr std::array<std::pair<Qt::Key, PlanarKey>, 27> kKeys{
    {{Qt::Key_Space, PlanarKey::play},    {Qt::Key_Up, PlanarKey::back},
     {Qt::Key_PageUp, PlanarKey::back},   {Qt::Key_Left, PlanarKey::back},
     {Qt::Key_Down, PlanarKey::forward},  {Qt::Key_PageDown, PlanarKey::forward},
     {Qt::Key_Right, PlanarKey::forward}, {Qt::Key_Home, PlanarKey::first},
     {Qt::Key_End, PlanarKey::last},      {Qt::Key_Delete, PlanarKey::remove},
     {Qt::Key_Return, PlanarKey::label},  {Qt::Key_Enter, PlanarKey::label},
     {Qt::Key_I, PlanarKey::invert},      {Qt::Key_R, PlanarKey::turn},
     {Qt::Key_M, PlanarKey::mirror},      {Qt::Key_F, PlanarKey::fit},
     {Qt::Key_Plus, PlanarKey::closer},   {Qt::Key_Minus, PlanarKey::farther},
     {Qt::Key_W, PlanarKey::window},      {Qt::Key_D, PlanarKey::distance},
     {Qt::Key_G, PlanarKey::angle},       {Qt::Key_E, PlanarKey::ellipse},
     {Qt::Key_C, PlanarKey::cobb},        {Qt::Key_O, PlanarKey::overlays},
     {Qt::Key_B, PlanarKey::alone},       {Qt::Key_L, PlanarKey::link},
     {Qt::Key_Escape, PlanarKey::escape}}};

}  // namespace

PlanarKeys::PlanarKeys(QWidget& view, QWidget& bar, QObject* parent) : QObject(parent), view_(view) {
    view.installEventFilter(this);
    // A menu keeps all of its keys.
    for (QWidget* control : bar.findChildren<QWidget*>())
        if (!control->isWindow()) control->installEventFilter(this);
}

bool PlanarKeys::eventFilter(QObject* watched, QEvent* event) {
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    if (!isOverride && event->type() != QEvent::KeyPress) return QObject::eventFilter(watched, event);
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const auto* found = std::ranges::find(kKeys, key.key(), [](const auto& each) { return int(each.first); });
    const Qt::KeyboardModifiers ignored =
        Qt::KeypadModifier | (key.key() == Qt::Key_Plus ? Qt::ShiftModifier : Qt::NoModifier);
    const bool isOwn = found != kKeys.end() && (key.modifiers() & ~ignored) == Qt::NoModifier &&
                       (watched == &view_ || found->second > PlanarKey::label);
    if (!isOwn) return QObject::eventFilter(watched, event);
    if (isOverride)
        event->accept();
    else
        Q_EMIT pressed(found->second);
    return true;
}

}  // namespace macula::viewer
