#include "viewer/slices/label_editor.h"

#include <QKeyEvent>
#include <algorithm>
#include <utility>

#include "base/utf8.h"
#include "scene/state/slices_json.h"

namespace macula::viewer {

namespace {

constexpr int kWidthPx = 180;
constexpr int kMarginPx = 4;

}  // namespace

LabelEditor::LabelEditor(QWidget* pane, QPoint place, const QString& text)
    : QLineEdit(text, pane), before_(text) {
    setObjectName(QStringLiteral("label-editor"));
    setAccessibleName(tr("Label of the measurement"));
    setToolTip(tr("Label of the measurement. Enter keeps it, Esc leaves it as it was"));
    setPlaceholderText(tr("Label"));
    setMaxLength(int(scene::kLongestLabelBytes));
    resize(std::min(kWidthPx, pane->width() - 2 * kMarginPx), sizeHint().height());
    move(std::clamp(place.x(), kMarginPx, std::max(kMarginPx, pane->width() - width() - kMarginPx)),
         std::clamp(place.y(), kMarginPx, std::max(kMarginPx, pane->height() - height() - kMarginPx)));
    selectAll();
    show();
    setFocus();
}

// Takes all keys: letters of tools and digits of windows are text here.
void LabelEditor::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return finish(true);
    if (event->key() == Qt::Key_Escape) return finish(false);
    QLineEdit::keyPressEvent(event);
    event->accept();
}

void LabelEditor::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason) finish(true);  // its own context menu does not count
}

void LabelEditor::finish(bool isAccepted) {
    if (std::exchange(isDone_, true)) return;
    const std::string typed = text().trimmed().toStdString();
    const QString kept = QString::fromStdString(std::string(startOf(typed, scene::kLongestLabelBytes)));
    const bool hadFocus = hasFocus();
    hide();
    deleteLater();
    if (hadFocus) parentWidget()->setFocus();
    if (isAccepted && kept != before_) Q_EMIT accepted(kept);
}

}  // namespace macula::viewer
