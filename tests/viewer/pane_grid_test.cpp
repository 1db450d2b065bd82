// Panes: which of them are seen, that none of them moves to another parent, and how they share the window.
#include "viewer/panes/pane_grid.h"

#include <QEvent>
#include <QLineEdit>
#include <QPlatformSurfaceEvent>
#include <QPointer>
#include <QSplitter>
#include <QVBoxLayout>
#include <QWindow>
#include <array>
#include <limits>
#include <stdexcept>
#include <vector>

#include "viewer/offscreen.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {
namespace {

constexpr std::array kLayouts{scene::Layout::axial,   scene::Layout::fourPanes, scene::Layout::volume,
                              scene::Layout::coronal, scene::Layout::sagittal,  scene::Layout::fourPanes};

class PaneGridTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        window_.emplace();
        for (QPointer<QWidget>& pane : panes_) {
            pane = new QWidget;
            pane->setFocusPolicy(Qt::StrongFocus);
        }
        makeGrid();
    }
    void TearDown() override {
        window_.reset();
        OffscreenTest::TearDown();
    }
    void makeGrid() {
        grid_ = new PaneGrid(
            {.axial = panes_[0], .volume = panes_[1], .coronal = panes_[2], .sagittal = panes_[3]});
        secondVolume_ = new QLineEdit;
        auto* column = new QVBoxLayout(&*window_);
        column->addWidget(grid_, 1);
        column->addWidget(secondVolume_);
        window_->resize(700, 500);
        window_->show();
        settle();
    }
    QWidget& pane(Pane pane) { return *panes_.at(std::size_t(pane)); }
    QSplitter& rows() {
        for (auto* splitter : grid_->findChildren<QSplitter*>())
            if (splitter->orientation() == Qt::Vertical) return *splitter;
        throw std::runtime_error("no rows");
    }
    QSplitter& row(int index) { return *qobject_cast<QSplitter*>(rows().widget(index)); }
    // As a hand moves its handle.
    static void move(QSplitter& splitter, int px) {
        struct Reachable : QSplitter {
            using QSplitter::moveSplitter;
        };
        (splitter.*&Reachable::moveSplitter)(px, 1);
        settle();
    }
    int activeFrames() {
        int count = 0;
        for (const auto* frame : grid_->findChildren<PaneFrame*>()) count += frame->isActive() ? 1 : 0;
        return count;
    }

    std::optional<QWidget> window_;
    std::array<QPointer<QWidget>, kPanes.size()> panes_;
    PaneGrid* grid_ = nullptr;
    QLineEdit* secondVolume_ = nullptr;
};

TEST_F(PaneGridTest, ShowsThePanesOfALayoutAndMovesNoneToAnotherParent) {
    std::array<QWidget*, kPanes.size()> parents{};
    for (const Pane p : kPanes) parents.at(std::size_t(p)) = pane(p).parentWidget();
    EXPECT_EQ(grid_->shownLayout(), scene::Layout::fourPanes);
    for (const scene::Layout layout : kLayouts) {
        grid_->setLayout(layout);
        settle();
        EXPECT_EQ(grid_->shownLayout(), layout);
        for (const Pane p : kPanes) {
            ASSERT_NE(panes_.at(std::size_t(p)), nullptr) << "it is gone";
            EXPECT_EQ(pane(p).parentWidget(), parents.at(std::size_t(p)));
            const bool shown = layout == scene::Layout::fourPanes || layout == layoutOf(p);
            EXPECT_EQ(grid_->isShown(p), shown);
            EXPECT_EQ(pane(p).isVisible(), shown) << int(layout) << ", pane " << int(p);
            if (shown && layout != scene::Layout::fourPanes) {
                EXPECT_EQ(pane(p).size(), grid_->size() - QSize(4, 4));
            }
        }
    }
}

TEST_F(PaneGridTest, FourPanesShareTheWindowAndLieWhereTheyAreLookedFor) {
    const auto at = [&](Pane p) { return pane(p).mapTo(grid_, QPoint(0, 0)); };
    EXPECT_EQ(at(Pane::axial), QPoint(2, 2));
    EXPECT_GT(at(Pane::volume).x(), at(Pane::axial).x() + pane(Pane::axial).width());
    EXPECT_EQ(at(Pane::volume).y(), 2);
    EXPECT_EQ(at(Pane::coronal).x(), 2);
    EXPECT_GT(at(Pane::coronal).y(), at(Pane::axial).y() + pane(Pane::axial).height());
    EXPECT_EQ(at(Pane::sagittal), QPoint(at(Pane::volume).x(), at(Pane::coronal).y()));
    for (const Pane p : kPanes) {
        EXPECT_NEAR(pane(p).width(), pane(Pane::axial).width(), 1);
        EXPECT_NEAR(pane(p).height(), pane(Pane::axial).height(), 1);
    }
}

TEST_F(PaneGridTest, TheCrossOfThePanesMovesAsOneAndStaysWhereItIs) {
    move(row(0), 150);
    EXPECT_EQ(row(0).sizes().value(0), 150);
    EXPECT_EQ(row(1).sizes(), row(0).sizes());
    move(row(1), 400);
    EXPECT_EQ(row(1).sizes().value(0), 400);
    EXPECT_EQ(row(0).sizes(), row(1).sizes());
    move(rows(), 120);
    EXPECT_EQ(rows().sizes().value(0), 120);
    const QPointF cross = grid_->cross();
    const auto expectCross = [&] {
        EXPECT_EQ(grid_->cross(), cross);
        EXPECT_EQ(row(0).sizes(), row(1).sizes());
        const QList<int> widths = row(0).sizes();
        const QList<int> heights = rows().sizes();
        EXPECT_NEAR(double(widths[0]) / (widths[0] + widths[1]), cross.x(), 0.01);
        EXPECT_NEAR(double(heights[0]) / (heights[0] + heights[1]), cross.y(), 0.01);
    };
    expectCross();
    window_->resize(1000, 800);
    settle();
    expectCross();
    grid_->setLayout(scene::Layout::sagittal);
    settle();
    window_->resize(600, 500);
    settle();
    grid_->setLayout(scene::Layout::fourPanes);
    settle();
    expectCross();
}

TEST_F(PaneGridTest, BothRowsAreAsWideAsTheWidestOfTheirPanesNeeds) {
    pane(Pane::sagittal).setMinimumWidth(300);
    pane(Pane::axial).setMinimumWidth(200);
    settle();
    grid_->setCross({1.0, 0.5});
    settle();
    EXPECT_EQ(row(0).sizes(), row(1).sizes());
    EXPECT_GE(pane(Pane::sagittal).width(), 300);
    move(row(0), 0);
    EXPECT_EQ(row(0).sizes(), row(1).sizes());
    EXPECT_GE(pane(Pane::axial).width(), 200);
    EXPECT_TRUE(pane(Pane::coronal).isVisible());
}

TEST_F(PaneGridTest, ACrossThatIsNoneIsInTheMiddle) {
    grid_->setCross({std::numeric_limits<double>::quiet_NaN(), 7.0});
    EXPECT_EQ(grid_->cross(), QPointF(0.5, 1.0));
    grid_->setCross({-std::numeric_limits<double>::infinity(), 0.25});
    EXPECT_EQ(grid_->cross(), QPointF(0.0, 0.25));
    settle();
    for (const Pane p : kPanes) EXPECT_TRUE(pane(p).isVisible());
}

TEST_F(PaneGridTest, MaximizingOnlyAsks) {
    std::vector<scene::Layout> asked;
    QObject::connect(grid_, &PaneGrid::layoutAsked, [&](scene::Layout layout) { asked.push_back(layout); });
    grid_->maximize(Pane::coronal);
    EXPECT_EQ(grid_->shownLayout(), scene::Layout::fourPanes);
    grid_->setLayout(scene::Layout::coronal);
    grid_->maximize(Pane::coronal);
    grid_->maximize(Pane::volume);
    EXPECT_EQ(asked, (std::vector{scene::Layout::coronal, scene::Layout::fourPanes, scene::Layout::volume}));
}

TEST_F(PaneGridTest, ThePaneWithTheFocusHasAFrame) {
    applyTheme(*application_, {});
    window_->activateWindow();
    for (const Pane p : kPanes) {
        grid_->focusPane(p);
        ASSERT_TRUE(waitUntil([&] { return grid_->activePane() == p; })) << int(p);
        EXPECT_EQ(activeFrames(), 1);
        EXPECT_EQ(pane(p).parentWidget()->grab().toImage().pixelColor(0, 9), QColor(themeColours().accent));
    }
    secondVolume_->setFocus();
    ASSERT_TRUE(waitUntil([&] { return !grid_->activePane(); }));
    EXPECT_EQ(activeFrames(), 0);
    EXPECT_NE(pane(Pane::axial).parentWidget()->grab().toImage().pixelColor(0, 9),
              QColor(themeColours().accent));
}

TEST_F(PaneGridTest, TheFocusOfAPaneThatIsHiddenGoesToOneThatIsShown) {
    window_->activateWindow();
    grid_->focusPane(Pane::sagittal);
    ASSERT_TRUE(waitUntil([&] { return grid_->activePane() == Pane::sagittal; }));
    grid_->setLayout(scene::Layout::volume);
    EXPECT_TRUE(waitUntil([&] { return grid_->activePane() == Pane::volume; }));
    grid_->focusPane(Pane::sagittal);  // it is not shown
    settle();
    EXPECT_EQ(grid_->activePane(), Pane::volume);
    secondVolume_->setFocus();
    grid_->setLayout(scene::Layout::axial);
    settle();
    EXPECT_TRUE(secondVolume_->hasFocus()) << "nobody took it from a pane";
}

// Its events, as Viewport's window hears them.
class Surfaces : public QObject {
  public:
    int destroyed = 0;

  protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::PlatformSurface &&
            static_cast<QPlatformSurfaceEvent*>(event)->surfaceEventType() ==
                QPlatformSurfaceEvent::SurfaceAboutToBeDestroyed)
            ++destroyed;
        return false;
    }
};

class NativePaneTest : public PaneGridTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        window_.emplace();
        native_ = new QWindow;
        for (const Pane p : kPanes) {
            const bool isNative = p == Pane::volume;
            QWidget* made = isNative ? QWidget::createWindowContainer(native_) : new QWidget;
            made->setFocusPolicy(Qt::StrongFocus);
            panes_.at(std::size_t(p)) = made;
        }
        makeGrid();
    }

    QWindow* native_ = nullptr;  // its container owns it
};

TEST_F(NativePaneTest, KeepsItsSurfaceThroughAllLayouts) {
    ASSERT_TRUE(waitUntil([&] { return native_->isVisible(); }));
    Surfaces surfaces;
    native_->installEventFilter(&surfaces);
    const WId id = native_->winId();
    const QWindow* parent = native_->parent();
    ASSERT_NE(parent, nullptr);
    for (const scene::Layout layout : kLayouts) {
        grid_->setLayout(layout);
        settle();
        EXPECT_EQ(native_->isVisible(), grid_->isShown(Pane::volume)) << int(layout);
        EXPECT_EQ(native_->winId(), id);
        EXPECT_EQ(native_->parent(), parent);
    }
    EXPECT_EQ(surfaces.destroyed, 0);
    native_->removeEventFilter(&surfaces);
}

TEST_F(NativePaneTest, IsTheActivePaneWhileItsWindowHasTheFocus) {
    ASSERT_TRUE(waitUntil([&] { return native_->isVisible(); }));
    native_->requestActivate();
    ASSERT_TRUE(waitUntil([&] { return QGuiApplication::focusWindow() == native_; }));
    EXPECT_TRUE(waitUntil([&] { return grid_->activePane() == Pane::volume; }));
    grid_->focusPane(Pane::axial);
    EXPECT_TRUE(waitUntil(
        [&] { return grid_->activePane() == Pane::axial && QGuiApplication::focusWindow() != native_; }));
}

TEST_F(PaneGridTest, OneIsLargerUntilAPersonDragsTheLines) {
    grid_->favour(Pane::sagittal);
    settle();
    EXPECT_GT(pane(Pane::sagittal).width(), 1.4 * pane(Pane::coronal).width());
    EXPECT_GT(pane(Pane::sagittal).height(), 1.4 * pane(Pane::axial).height());
    grid_->favour(Pane::axial);
    settle();
    EXPECT_GT(pane(Pane::axial).width(), 1.4 * pane(Pane::volume).width());
    EXPECT_GT(pane(Pane::axial).height(), 1.4 * pane(Pane::coronal).height());
    grid_->favour(std::nullopt);
    EXPECT_EQ(grid_->cross(), QPointF(0.5, 0.5));
    move(rows(), 300);
    const QPointF dragged = grid_->cross();
    grid_->favour(Pane::coronal);
    EXPECT_EQ(grid_->cross(), dragged);
}

}  // namespace
}  // namespace macula::viewer
