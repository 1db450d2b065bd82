// Opens a second volume beside the study, and shows it on slices and in 3D.
#pragma once

#include <QList>
#include <QObject>
#include <QStringList>
#include <array>

#include "viewer/context/window_context.h"

class QAction;
class QMenu;

namespace macula::viewer {

class BrowserController;
class SecondVolumeBar;
class SecondVolumeLoader;
class SlicePair;
class WorkBar;

// Deletes its loader and tool bar: destroy it before the session. Lives on the UI thread.
class SecondVolumeController : public QObject {
    Q_OBJECT

  public:
    // The browser outlives it. The index into `pairs` is slices::Orientation.
    SecondVolumeController(const WindowContext& context, BrowserController& browser,
                           const std::array<SlicePair*, 3>& pairs);
    ~SecondVolumeController() override;

    SecondVolumeLoader& loader() const { return *loader_; }
    void addFileActions(QMenu& file);
    void addViewActions(QMenu& view);
    // Call it after the other tool bars are there: these get a row of their own.
    void addBars();

  private:
    void connectLoader();
    void askAbout();
    void askFor(int mode);  // a QFileDialog::FileMode
    void show();            // the second volume, as the state describes it
    QStringList notes() const;

    WindowContext context_;
    BrowserController& browser_;
    std::array<SlicePair*, 3> pairs_;
    SecondVolumeLoader* loader_;
    SecondVolumeBar* toolBar_ = nullptr;
    WorkBar* work_;
    QList<QAction*> actions_;  // enabled only with a second volume
};

}  // namespace macula::viewer
