#include "viewer/panes/pane_grid.h"

#include <QApplication>
#include <QPainter>
#include <QSplitter>
#include <QVBoxLayout>
#include <QWindow>
#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

constexpr int kGapPx = 2;
constexpr double kFavoured = 0.62;  // the enlarged pane's share of width and height

std::optional<Pane> onlyPaneOf(scene::Layout layout) {
    for (const Pane pane : kPanes) {
        if (layoutOf(pane) == layout) return pane;
    }
    return std::nullopt;
}

QSplitter* makeSplitter(Qt::Orientation orientation, QWidget* first, QWidget* second) {
    auto* made = new QSplitter(orientation);
    made->setHandleWidth(kGapPx);
    made->setChildrenCollapsible(false);  // nobody would notice that a collapsed pane is missing
    for (QWidget* widget : {first, second}) made->addWidget(widget);
    for (const int index : {0, 1}) made->setStretchFactor(index, 1);
    return made;
}

double shareOrMiddle(double share) {
    return std::isnan(share) ? 0.5 : std::clamp(share, 0.0, 1.0);
}

// The sizes of both panes, without the handle between them.
QList<int> partsOf(int totalPx, double share) {
    const int free = std::max(0, totalPx - kGapPx);
    const int first = int(std::lround(share * free));
    return {first, free - first};
}

std::optional<double> shareOf(const QSplitter& splitter) {
    const QList<int> sizes = splitter.sizes();
    const int both = sizes.value(0) + sizes.value(1);
    if (both <= 0) return std::nullopt;
    return double(sizes.value(0)) / both;
}

// A native window inside a widget has the focus itself, and then no widget has it.
bool isInside(const QWindow* window, const QWindow* top) {
    if (window == nullptr || top == nullptr || window == top) return false;
    const QWindow* at = window;
    while (at != nullptr && at != top) at = at->parent();
    return at == top;
}

constexpr int kEdgePx = 2;

}  // namespace

scene::Layout layoutOf(Pane pane) {
    switch (pane) {
        case Pane::axial:
            return scene::Layout::axial;
        case Pane::volume:
            return scene::Layout::volume;
        case Pane::coronal:
            return scene::Layout::coronal;
        case Pane::sagittal:
            return scene::Layout::sagittal;
    }
    MACULA_CHECK(false);
    return scene::Layout::fourPanes;
}

PaneGrid::PaneGrid(const Widgets& widgets, QWidget* parent) : QWidget(parent) {
    frames_ = {new PaneFrame(widgets.axial), new PaneFrame(widgets.volume), new PaneFrame(widgets.coronal),
               new PaneFrame(widgets.sagittal)};
    top_ = makeSplitter(Qt::Horizontal, &frame(Pane::axial), &frame(Pane::volume));
    bottom_ = makeSplitter(Qt::Horizontal, &frame(Pane::coronal), &frame(Pane::sagittal));
    rows_ = makeSplitter(Qt::Vertical, top_, bottom_);
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(0, 0, 0, 0);
    box->addWidget(rows_);
    connect(top_, &QSplitter::splitterMoved, this, [this] { moveColumns(*top_); });
    connect(bottom_, &QSplitter::splitterMoved, this, [this] { moveColumns(*bottom_); });
    connect(rows_, &QSplitter::splitterMoved, this, &PaneGrid::moveRows);
    connect(qApp, &QApplication::focusChanged, this, &PaneGrid::updateActive);
    connect(qApp, &QGuiApplication::focusWindowChanged, this, &PaneGrid::updateActive);
}

// Panes lose the focus as they are destroyed; this grid must not react to that any more.
PaneGrid::~PaneGrid() {
    if (qApp != nullptr) disconnect(qApp, nullptr, this, nullptr);
}

void PaneGrid::setLayout(scene::Layout layout) {
    const std::optional<Pane> only = onlyPaneOf(layout);
    const std::optional<Pane> hadFocus = focused();
    shown_ = layout;
    // Shows panes before it hides others: if no pane were visible, the focus would move elsewhere.
    for (const bool shows : {true, false}) {
        for (const Pane pane : kPanes) {
            if (isShown(pane) == shows) frame(pane).setVisible(shows);
        }
        if ((isShown(Pane::axial) || isShown(Pane::volume)) == shows) top_->setVisible(shows);
        if ((isShown(Pane::coronal) || isShown(Pane::sagittal)) == shows) bottom_->setVisible(shows);
    }
    applyCross();
    if (hadFocus && !isShown(*hadFocus)) focusPane(only.value_or(Pane::axial));
    updateActive();
}

bool PaneGrid::isShown(Pane pane) const {
    return onlyPaneOf(shown_).value_or(pane) == pane;
}

void PaneGrid::maximize(Pane pane) {
    const scene::Layout alone = layoutOf(pane);
    Q_EMIT layoutAsked(shown_ == alone ? scene::Layout::fourPanes : alone);
}

void PaneGrid::focusPane(Pane pane) {
    if (!isShown(pane)) return;
    // A native window keeps getting the keys until its parent is the active window.
    if (pane != Pane::volume && isInside(QGuiApplication::focusWindow(), window()->windowHandle()))
        window()->activateWindow();
    frame(pane).content().setFocus(Qt::OtherFocusReason);
}

void PaneGrid::setCross(QPointF shares) {
    cross_ = {shareOrMiddle(shares.x()), shareOrMiddle(shares.y())};
    applyCross();
}

void PaneGrid::favour(std::optional<Pane> pane) {
    if (isDragged_) return;
    const auto share = [&](bool isFirst) { return !pane ? 0.5 : isFirst ? kFavoured : 1.0 - kFavoured; };
    setCross({share(pane == Pane::axial || pane == Pane::coronal),
              share(pane == Pane::axial || pane == Pane::volume)});
}

void PaneGrid::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    applyCross();
}

void PaneGrid::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    applyCross();
}

void PaneGrid::moveColumns(const QSplitter& moved) {
    if (shown_ != scene::Layout::fourPanes) return;
    isDragged_ = true;
    cross_.setX(shareOf(moved).value_or(cross_.x()));
    alignColumns(moved.sizes());
}

void PaneGrid::moveRows() {
    if (shown_ != scene::Layout::fourPanes) return;
    isDragged_ = true;
    cross_.setY(shareOf(*rows_).value_or(cross_.y()));
}

// A row whose panes cannot be that narrow gets its own sizes, and the other row follows it.
void PaneGrid::alignColumns(const QList<int>& widthsPx) {
    top_->setSizes(widthsPx);
    bottom_->setSizes(top_->sizes());
    if (bottom_->sizes() != top_->sizes()) top_->setSizes(bottom_->sizes());
}

void PaneGrid::applyCross() {
    if (shown_ != scene::Layout::fourPanes) return;
    const QSize size = rows_->contentsRect().size();
    rows_->setSizes(partsOf(size.height(), cross_.y()));
    alignColumns(partsOf(size.width(), cross_.x()));
}

std::optional<Pane> PaneGrid::focused() const {
    if (const QWidget* widget = QApplication::focusWidget()) {
        for (const Pane pane : kPanes) {
            if (frame(pane).isAncestorOf(widget)) return pane;
        }
        return std::nullopt;
    }
    if (isInside(QGuiApplication::focusWindow(), window()->windowHandle())) return Pane::volume;
    return std::nullopt;
}

void PaneGrid::updateActive() {
    const std::optional<Pane> now = focused();
    if (now == active_) return;
    active_ = now;
    for (const Pane pane : kPanes) frame(pane).setActive(pane == active_);
    Q_EMIT activePaneChanged();
}

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
