// A panel with the numbers of the lights.
#pragma once

#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QWidget>
#include <functional>

#include "viewer/editor/study_editor.h"
#include "viewer/lights/lights_editing.h"

namespace macula::viewer {

// Shows the current rig, its chosen light, and the settings of all its lights. The editing outlives it.
class LightsPanel : public QWidget {
    Q_OBJECT

  public:
    LightsPanel(StudyEditor& session, LightsEditing& editing, QWidget* parent = nullptr);
    ~LightsPanel() override;

    // A person can ask for the exposure only while `isMetering` is false.
    void setMetering(bool isMetering);
    void tell(const Error& error);  // shows it below the controls

  Q_SIGNALS:
    void saveAsked();
    void openAsked();
    void meteringAsked();  // asks for an exposure that suits the picture
    void lookedAt();       // emitted before an edit that needs the current camera

  private:
    QWidget* makeRig();
    QWidget* makeLight();
    QWidget* makeAll();
    QDoubleSpinBox* makeNumber(const char* name, const QString& title, const QString& suffix,
                               const QString& does);
    void tryTo(const Result<void>& done);  // shows the error
    void changeLight(const std::function<void(trace::SoftLight&)>& edit);
    void setParameter(const char* id, double value);
    void askColour();
    void dropDialog();
    void showState();
    void showRig(const trace::LightRig& rig);
    void showLight(const trace::SoftLight* light);

    StudyEditor& session_;
    LightsEditing& editing_;
    QComboBox* rigs_ = nullptr;
    QComboBox* lights_ = nullptr;
    QPushButton* add_ = nullptr;
    QPushButton* remove_ = nullptr;
    QDoubleSpinBox* azimuth_ = nullptr;
    QDoubleSpinBox* elevation_ = nullptr;
    QDoubleSpinBox* size_ = nullptr;
    QDoubleSpinBox* strength_ = nullptr;
    QPushButton* colour_ = nullptr;
    QPointer<QColorDialog> dialog_;
    QComboBox* frames_ = nullptr;
    QDoubleSpinBox* sky_ = nullptr;
    QDoubleSpinBox* turned_ = nullptr;
    QDoubleSpinBox* allStrength_ = nullptr;
    QDoubleSpinBox* exposure_ = nullptr;
    QPushButton* meter_ = nullptr;
    QLabel* trouble_ = nullptr;
    bool isMetering_ = false;
};

}  // namespace macula::viewer
