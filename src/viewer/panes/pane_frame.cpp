#include "viewer/panes/pane_frame.h"

#include <QPainter>
#include <QVBoxLayout>

#include "base/check.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

constexpr int kEdgePx = 2;

}  // namespace

PaneFrame::PaneFrame(QWidget* content, QWidget* parent) : QWidget(parent), content_(content) {
    MACULA_CHECK(content != nullptr);
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(kEdgePx, kEdgePx, kEdgePx, kEdgePx);
    box->addWidget(content);
}

void PaneFrame::setActive(bool active) {
    if (active == isActive_) return;
    isActive_ = active;
    update();
}

void PaneFrame::paintEvent(QPaintEvent*) {
    if (!isActive_) return;
    QPainter painter(this);
    QRegion edge(rect());
    edge -= rect().adjusted(kEdgePx, kEdgePx, -kEdgePx, -kEdgePx);
    for (const QRect& side : edge) painter.fillRect(side, QColor(themeColours().accent));
}

}  // namespace macula::viewer
