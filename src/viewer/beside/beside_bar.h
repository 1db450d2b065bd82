// How the second volume is shown: a bar that is there while there is one.
#pragma once

#include <QToolBar>
#include <memory>
#include <vector>

#include "scene/second/beside_state.h"

class QAction;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSlider;

namespace macula::viewer {

class BesideStudy;
class ElidingLabel;
class ViewerSession;

// Whose it is, in columns or colours, how it is linked, and its window. All of it is the session's state; it
// is proposed, and shown as the state has it. Hidden without a second volume.
class BesideBar : public QToolBar {
    Q_OBJECT

  public:
    // Both outlive it.
    BesideBar(ViewerSession& session, BesideStudy& beside, QWidget* parent = nullptr);

    void showState();

  signals:
    // Something was chosen from a list: letters are keys of pictures again, and change no list.
    void listLeft();

  private:
    void addViews();
    void addLinks();
    void addColours();
    void addWindow();
    void addLinkedWindow();
    void addIn3d();
    void fillPresets(const app::BesideState& state);
    void proposeWindow();
    DisplayWindow secondWindow() const;

    ViewerSession& session_;
    BesideStudy& beside_;
    ElidingLabel* tag_;
    QComboBox* views_ = nullptr;
    QComboBox* links_ = nullptr;
    QComboBox* colours_ = nullptr;
    QSlider* opacity_ = nullptr;
    QCheckBox* oneWindow_ = nullptr;
    QCheckBox* in3d_ = nullptr;
    QComboBox* presets_ = nullptr;  // of the second volume in 3D; the first item: its colours over slices
    std::vector<std::shared_ptr<const TransferFunction>> listed_;  // from the second item on
    QDoubleSpinBox* black_ = nullptr;  // ends of the window, in the unit of the second volume
    QDoubleSpinBox* white_ = nullptr;
    bool isShowing_ = false;  // the state, and proposes nothing
};

}  // namespace macula::viewer
