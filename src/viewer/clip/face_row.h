// One face of what a clip keeps: a slider, a number, and a button that opens it.
#pragma once

#include <QLabel>
#include <QSlider>
#include <QString>
#include <QToolButton>
#include <QWidget>

#include "scene/clip/kept_box.h"
#include "viewer/clip/patient_mm_box.h"

namespace macula::viewer {

// What it shows is set from outside, and tells nobody; what a hand does is told, and shown once it is set.
class FaceRow : public QWidget {
    Q_OBJECT

  public:
    explicit FaceRow(app::Face face, QWidget* parent = nullptr);

    app::Face face() const { return face_; }
    // From face to face of the volume; the slider goes on by `stepMm`. All are finite, and low < high.
    void setRangeMm(double lowMm, double highMm, double stepMm);
    void showMm(double mm);
    void setUsable(bool usable, const QString& whyNot);

  signals:
    void moveBegan();
    void moved(double mm);  // patient LPS, while a hand moves
    void moveEnded();
    void openAsked();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    double mmOfSlider() const;

    app::Face face_;
    double lowMm_ = 0.0;
    double highMm_ = 1.0;
    QLabel* letter_;
    QSlider* slider_;
    PatientMmBox* number_;
    QToolButton* open_;
};

// "right", in the language of the window.
QString sideText(app::Face face);

}  // namespace macula::viewer
