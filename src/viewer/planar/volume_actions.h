// Actions of the window that act on the open volume. While images are shown in its place they are disabled,
// and say why: they would act on what nobody sees.
#pragma once

#include <QPointer>
#include <QString>
#include <vector>

class QAction;
class QWidget;

namespace macula::viewer {

class VolumeActions {
  public:
    explicit VolumeActions(QWidget& window) : window_(window) {}

    void setImagesShown(bool shown);

  private:
    struct Disabled {
        QPointer<QAction> action;
        bool wasEnabled = true;
        QString tip;
    };
    QWidget& window_;
    std::vector<Disabled> disabled_;
};

}  // namespace macula::viewer
