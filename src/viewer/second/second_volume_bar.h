// A tool bar for how the second volume is shown.
#pragma once

#include <QToolBar>
#include <memory>
#include <vector>

#include "scene/second/second_volume_state.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSlider;

namespace macula::viewer {

class SecondVolumeLoader;
class ElidingLabel;
class StudyEditor;

// Shows the second volume's tag, view, link, colours and window as the session's state has them, and proposes
// changes to it. Hidden while there is no second volume.
class SecondVolumeBar : public QToolBar {
    Q_OBJECT

  public:
    // Both outlive it.
    SecondVolumeBar(StudyEditor& session, SecondVolumeLoader& beside, QWidget* parent = nullptr);

    void showState();

  Q_SIGNALS:
    // A person chose from a list; the window returns the keyboard focus to a picture.
    void listLeft();

  private:
    void addViews();
    void addLinks();
    void addColours();
    void addWindow();
    void addLinkedWindow();
    void addIn3d();
    void fillPresets(const scene::SecondVolumeState& state);
    void proposeWindow();
    DisplayWindow secondWindow() const;

    StudyEditor& session_;
    SecondVolumeLoader& secondVolume_;
    ElidingLabel* tag_;
    QComboBox* views_ = nullptr;
    QComboBox* links_ = nullptr;
    QComboBox* colours_ = nullptr;
    QSlider* opacity_ = nullptr;
    QCheckBox* oneWindow_ = nullptr;
    QCheckBox* in3d_ = nullptr;
    QComboBox* presets_ = nullptr;  // the presets for 3D; item 0: the colours of slices
    std::vector<std::shared_ptr<const TransferFunction>> listed_;  // the presets of items 1, 2, ...
    QDoubleSpinBox* black_ = nullptr;  // ends of the window, in the unit of the second volume
    QDoubleSpinBox* white_ = nullptr;
    bool isShowing_ = false;  // controls follow the state and propose nothing
};

}  // namespace macula::viewer
