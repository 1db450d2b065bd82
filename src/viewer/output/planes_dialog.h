// Asks which planes are to be saved as a DICOM series.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <memory>
#include <optional>

#include "base/volume.h"
#include "scene/slices/plane_batch.h"

namespace macula::viewer {

class PlanesDialog : public QDialog {
    Q_OBJECT

  public:
    struct Offer {
        scene::PlaneBatch batch;  // parallel ones, to begin with
        std::shared_ptr<const Volume> volume;
        glm::dvec3 crosshairMm{0.0};
        // The curve at its place nearest to the cross-hair; nothing: there is none.
        std::optional<scene::PlaneBatch::Radial> alongCurve;
        bool namesPatient = true;  // false: the volume is of no DICOM images, and only fits without a patient
        bool isDeidentified = false;
    };
    explicit PlanesDialog(const Offer& offer, QWidget* parent = nullptr);

    scene::PlaneBatch batch() const;  // usable once the dialog is accepted
    bool isDeidentified() const { return deidentified_->isChecked(); }

  private:
    enum Kind { parallel, aboutNormal, aboutCurve };

    QDoubleSpinBox* makeMm(const char* name, const QString& what, double value);
    void addRows(QWidget* buttons);
    void showSum();

    Offer offer_;
    QComboBox* kind_;
    QDoubleSpinBox* from_;
    QDoubleSpinBox* to_;
    QDoubleSpinBox* step_;
    QSpinBox* count_;
    QLabel* sum_;
    QCheckBox* deidentified_;
    QPushButton* ok_ = nullptr;
};

}  // namespace macula::viewer
