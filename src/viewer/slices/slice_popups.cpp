#include "viewer/slices/slice_popups.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPixmap>
#include <QWidget>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "base/utf8.h"
#include "scene/state/measurements_json.h"
#include "viewer/overlay/measurement_handles.h"
#include "viewer/slices/slice_menu.h"

namespace macula::viewer {

namespace {

// Of the label's editor.
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

void SlicePopups::openMenu(const QPointF& place) {
    const SliceRequest* shown = parts_.picture.shownRequest();
    if (shown == nullptr || parts_.measurements.isDrawing() || !shown->showsStudy()) return;
    const bool isMeant = parts_.hand.selectAt(place, *shown);
    parts_.hand.drop();
    std::function<void()> edit;
    std::optional<bool> isNode;
    std::function<void(bool)> setNode;
    if (isMeant) {
        const std::size_t index = *parts_.measurements.selected();
        edit = [this, index] { editLabel(index); };
        setNode = [this, index](bool on) { parts_.measurements.setNode(index, on); };
        const auto* lesion =
            std::get_if<slices::Bidirectional>(&parts_.session.state().measurements.at(index).shape);
        if (lesion != nullptr) isNode = lesion->isNode;
    }
    QMenu* menu = makeSliceMenu({.session = &parts_.session,
                                 .own = parts_.windowing.own(),
                                 .window = parts_.content.studyWindow(),
                                 .editLabel = std::move(edit),
                                 .isNode = isNode,
                                 .setNode = std::move(setNode),
                                 .fit = [this] { parts_.zoom.fit(); },
                                 .copyPicture = [this] { copyPicture(); },
                                 .savePicture = [this] { Q_EMIT savePictureAsked(pane_.grab().toImage()); },
                                 .savePlanes = [this] { Q_EMIT savePlanesAsked(); }},
                                &pane_);
    menu->installEventFilter(this);
    menu->popup(pane_.mapToGlobal(place.toPoint()));
    pane_.update();
}

// The second click of a right double-click reaches the menu that the first click opened.
bool SlicePopups::eventFilter(QObject* watched, QEvent* event) {
    auto* menu = qobject_cast<QMenu*>(watched);
    const bool isDouble = event->type() == QEvent::MouseButtonDblClick &&
                          static_cast<const QMouseEvent*>(event)->button() == Qt::RightButton;
    if (menu == nullptr || !isDouble) return QObject::eventFilter(watched, event);
    menu->close();
    parts_.zoom.fit();
    return true;
}

void SlicePopups::editLabel(std::size_t measurement) {
    const auto& measurements = parts_.session.state().measurements;
    const SliceRequest* shown = parts_.picture.shownRequest();
    if (shown == nullptr || measurement >= measurements.size()) return;
    const slices::Measurement edited = measurements[measurement];
    const std::vector<glm::dvec3> handles = handlesOf(edited);
    if (handles.empty()) return;
    const bool isArrow = std::holds_alternative<slices::Arrow>(edited.shape);
    const glm::dvec3 beside = isArrow ? handles.back() : handles.front();
    const glm::dvec2 px = shown->frame.pictureFromWorld(beside) / shown->pixelRatio;
    const QString before = QString::fromStdString(edited.label);
    auto* editor = new LabelEditor(&pane_, QPointF(px.x, px.y).toPoint(), before);
    connect(editor, &LabelEditor::accepted, this, [this, edited](const QString& text) {
        parts_.session.change(tr("Label"), [&](scene::StudyState& next) {
            const auto found = std::ranges::find(next.measurements, edited);
            if (found != next.measurements.end()) found->label = text.toStdString();
        });
    });
}

void SlicePopups::copyPicture() {
    if (parts_.picture.shownRequest() != nullptr) QGuiApplication::clipboard()->setPixmap(pane_.grab());
}

void SlicePopups::closeLabel() {
    delete pane_.findChild<LabelEditor*>();
}

}  // namespace macula::viewer
