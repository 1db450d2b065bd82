// A window of images beside the main one, for another screen.
#pragma once

#include <QWidget>

namespace macula::viewer {

// Has the undo and redo of the main window. Lives on the UI thread.
class ImagesWindow : public QWidget {
    Q_OBJECT

  public:
    // Placed on another screen than `main` where there is one. Takes `content`, until giveBack().
    ImagesWindow(QWidget& content, QWidget& main);

    void giveBack();  // the content has no parent then

  Q_SIGNALS:
    void closeAsked();
    void activeChanged();

  protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    QWidget& content_;
};

}  // namespace macula::viewer
