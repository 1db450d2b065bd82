#include "viewer/keys.h"

#include <QKeyEvent>
#include <algorithm>

#include "base/check.h"

namespace macula::viewer {

QKeySequence keyOf(KeyAction action) {
    const auto row = std::ranges::find(kKeys, action, &KeyRow::action);
    MACULA_CHECK(row != kKeys.end());
    return QKeySequence(QString::fromLatin1(row->sequence), QKeySequence::PortableText);
}

QKeySequence keyOf(trace::Look look) {
    static_assert(trace::kLooks.size() == 6, "the rows of KeyAction::look and KeyAction::window name them");
    return QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_1 + int(look)));
}

QKeySequence keyOf(const LayoutRow& row) {
    return QKeySequence(QString::fromLatin1(row.sequence), QKeySequence::PortableText);
}

QString pressedFor(const KeyRow& row) {
    const QString hand = QString::fromUtf8(row.hand);
    const QString key = QString::fromLatin1(row.sequence);
    return hand.isEmpty() || key.isEmpty() ? hand + key : hand + QStringLiteral(", ") + key;
}

std::optional<KeyAction> actionOf(const QKeyEvent& event) {
    const QKeySequence pressed(event.key());
    for (const KeyRow& row : kKeys) {
        if (row.sequence[0] != '\0' && keyOf(row.action) == pressed) return row.action;
    }
    return std::nullopt;
}

std::optional<ViewDirection> viewDirectionOf(KeyAction action) {
    switch (action) {
        case KeyAction::anterior:
            return ViewDirection::anterior;
        case KeyAction::posterior:
            return ViewDirection::posterior;
        case KeyAction::left:
            return ViewDirection::left;
        case KeyAction::right:
            return ViewDirection::right;
        case KeyAction::superior:
            return ViewDirection::superior;
        case KeyAction::inferior:
            return ViewDirection::inferior;
        default:
            return std::nullopt;
    }
}

}  // namespace macula::viewer
