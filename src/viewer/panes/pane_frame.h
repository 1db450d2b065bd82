// The edge of a pane, which shows the keyboard focus.
#pragma once

#include <QWidget>

namespace macula::viewer {

// A margin around `content`. Nothing is painted over `content`, which may be a native window.
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
