// Cine on a pane of slices: steps through them back and forth.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>

#include "viewer/editor/study_editor.h"
#include "viewer/slices/pane_content.h"

namespace macula::viewer {

// A run is one undo step.
class SliceCine : public QObject {
    Q_OBJECT

  public:
    // `isSeen`: whether the current slice is on screen. Cine waits for it, so a slow machine shows all
    // slices, more slowly.
    SliceCine(StudyEditor& session, const PaneContent& content, std::function<bool()> isSeen);

    bool isOn() const { return timer_.isActive(); }
    void start();  // needs a study
    void stop();

  Q_SIGNALS:
    void changed(bool on);

  private:
    void step();

    StudyEditor& session_;
    const PaneContent& content_;
    std::function<bool()> isSeen_;
    QTimer timer_;
    bool goesBack_ = false;
};

}  // namespace macula::viewer
