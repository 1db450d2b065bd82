// One face of the clip's box: a slider, a number, and a button that opens it.
#pragma once

#include <QLabel>
#include <QSlider>
#include <QString>
#include <QToolButton>
#include <QWidget>

#include "scene/clip/kept_box.h"
#include "viewer/clip/patient_mm_box.h"

namespace macula::viewer {

// Setters emit nothing. A person's input is emitted, and the row's owner sets the result with showMm.
class FaceRow : public QWidget {
    Q_OBJECT

  public:
    explicit FaceRow(scene::Face face, QWidget* parent = nullptr);

    scene::Face face() const { return face_; }
    // The volume's two faces on this axis; the slider moves by `stepMm`. All are finite, and low < high.
    void setRangeMm(double lowMm, double highMm, double stepMm);
    void showMm(double mm);
    void setUsable(bool usable, const QString& whyNot);

  Q_SIGNALS:
    void moveBegan();
    void moved(double mm);  // patient LPS, while a person drags or types
    void moveEnded();
    void openAsked();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    double mmOfSlider() const;

    scene::Face face_;
    double lowMm_ = 0.0;
    double highMm_ = 1.0;
    QLabel* letter_;
    QSlider* slider_;
    PatientMmBox* number_;
    QToolButton* open_;
};

// "right", in the language of the window.
QString sideText(scene::Face face);

}  // namespace macula::viewer
