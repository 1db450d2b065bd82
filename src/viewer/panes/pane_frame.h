// The edge of a pane, which tells that it has the keyboard focus.
#pragma once

#include <QWidget>

namespace macula::viewer {

// A margin around `content`, which may be a native window: nothing is painted over it.
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
