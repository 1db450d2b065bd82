#include "viewer/slices/slice_popups.h"

#include <QMenu>
#include <QMouseEvent>
#include <QWidget>
#include <algorithm>
#include <functional>
#include <utility>

#include "viewer/overlay/measurement_handles.h"
#include "viewer/slices/label_editor.h"
#include "viewer/slices/slice_menu.h"

namespace macula::viewer {

void SlicePopups::openMenu(const QPointF& place) {
    const SliceRequest* shown = parts_.picture.shownRequest();
    if (shown == nullptr || parts_.measurements.isDrawing() || !shown->showsStudy()) return;
    const bool isMeant = parts_.hand.selectAt(place, *shown);
    parts_.hand.drop();
    std::function<void()> edit;
    if (isMeant) edit = [this, index = *parts_.measurements.selected()] { editLabel(index); };
    QMenu* menu = makeSliceMenu({.session = &parts_.session,
                                 .own = parts_.windowing.own(),
                                 .window = parts_.content.studyWindow(),
                                 .editLabel = std::move(edit),
                                 .fit = [this] { parts_.zoom.fit(); }},
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
    const glm::dvec2 px = shown->frame.pictureFromWorld(handlesOf(edited).front()) / shown->pixelRatio;
    const QString before = QString::fromStdString(edited.label);
    auto* editor = new LabelEditor(&pane_, QPointF(px.x, px.y).toPoint(), before);
    connect(editor, &LabelEditor::accepted, this, [this, edited](const QString& text) {
        parts_.session.change(tr("Label"), [&](scene::StudyState& next) {
            const auto found = std::ranges::find(next.measurements, edited);
            if (found != next.measurements.end()) found->label = text.toStdString();
        });
    });
}

void SlicePopups::closeLabel() {
    delete pane_.findChild<LabelEditor*>();
}

}  // namespace macula::viewer
