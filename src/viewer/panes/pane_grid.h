// The panes of a study: four at once in two rows, or one of them alone.
#pragma once

#include <QPointF>
#include <QWidget>
#include <array>
#include <optional>

#include "scene/state/study_state.h"

class QSplitter;

namespace macula::viewer {

class PaneFrame;

// In the order of rows: axial beside the volume, coronal beside sagittal.
enum class Pane { axial, volume, coronal, sagittal };
inline constexpr std::array kPanes{Pane::axial, Pane::volume, Pane::coronal, Pane::sagittal};

scene::Layout layoutOf(Pane pane);  // the pane alone

// Panes are placed once and only hidden and shown afterwards: the volume's is a native window, which would
// lose its surface under another parent. The pane with the keyboard focus has a frame.
class PaneGrid : public QWidget {
    Q_OBJECT

  public:
    struct Widgets {  // none is null; the grid owns them
        QWidget* axial = nullptr;
        QWidget* volume = nullptr;
        QWidget* coronal = nullptr;
        QWidget* sagittal = nullptr;
    };
    explicit PaneGrid(const Widgets& widgets, QWidget* parent = nullptr);
    ~PaneGrid() override;

    // Shows these panes, and moves the focus from a pane that is now hidden to one of them. Not
    // QWidget::setLayout.
    void setLayout(scene::Layout layout);
    scene::Layout shownLayout() const { return shown_; }
    bool isShown(Pane pane) const;

    // Emits layoutAsked for the pane alone, or for all four if it is alone. Changes nothing itself.
    void maximize(Pane pane);

    void focusPane(Pane pane);  // does nothing unless it is shown
    // The pane with the keyboard focus, which the pane itself or a window inside it may have.
    std::optional<Pane> activePane() const { return active_; }

    // The point where the panes meet, as shares of width and height from the top left; each row and column
    // keeps the minimum size of its panes.
    QPointF cross() const { return cross_; }
    void setCross(QPointF shares);  // a NaN counts as 0.5, the middle

    // Enlarges this pane among the four; nothing: equal shares. Ignored once a person has dragged the lines.
    void favour(std::optional<Pane> pane);

  Q_SIGNALS:
    void layoutAsked(macula::scene::Layout layout);
    void activePaneChanged();

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    PaneFrame& frame(Pane pane) const { return *frames_.at(std::size_t(pane)); }
    void moveColumns(const QSplitter& moved);
    void moveRows();
    void alignColumns(const QList<int>& widthsPx);
    void applyCross();
    std::optional<Pane> focused() const;
    void updateActive();

    std::array<PaneFrame*, kPanes.size()> frames_{};
    QSplitter* rows_ = nullptr;
    QSplitter* top_ = nullptr;
    QSplitter* bottom_ = nullptr;
    scene::Layout shown_ = scene::Layout::fourPanes;
    QPointF cross_{0.5, 0.5};
    bool isDragged_ = false;  // a person has dragged the cross
    std::optional<Pane> active_;
};

// The edge of a pane, which shows the keyboard focus: a margin around `content`. Nothing is painted over
// `content`, which may be a native window.
class PaneFrame : public QWidget {
    Q_OBJECT

  public:
    explicit PaneFrame(QWidget* content, QWidget* parent = nullptr);

    QWidget& content() const { return *content_; }
    void setActive(bool active);
    bool isActive() const { return isActive_; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QWidget* content_;
    bool isActive_ = false;
};

}  // namespace macula::viewer
