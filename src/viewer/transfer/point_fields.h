// Number fields for the selected point of a transfer function.
#pragma once

#include <QDoubleSpinBox>
#include <QPointer>
#include <QPushButton>
#include <QString>
#include <QWidget>
#include <glm/glm.hpp>
#include <optional>

class QColorDialog;

namespace macula::viewer {

// Emits edits, and shows only what it is given.
class PointFields : public QWidget {
    Q_OBJECT

  public:
    explicit PointFields(QWidget* parent = nullptr);

    // The unit of the volume's values, shown behind the number; may be empty.
    void setUnit(const QString& unit, int decimals);
    void setUnitDistance(double mm);  // thickness for which the opacity holds
    void setStep(double units);       // the step of the arrows beside the value

    struct Point {
        double value = 0.0;                     // a value of the volume
        std::optional<double> opacity = {};     // for an opacity point
        std::optional<glm::dvec3> colour = {};  // for a colour point, sRGB-encoded
    };
    void showPoint(const std::optional<Point>& point);  // nothing: no point is selected

    // Opens a non-blocking dialog for the shown colour; the point takes each colour tried.
    void askColour();
    void dropDialog();  // closes the dialog; its last colour stays

  Q_SIGNALS:
    void valueChanged(double value);
    void opacityChanged(double opacity);
    void colourChanged(const glm::dvec3& colour);
    void ended();  // a series of changes has ended

  private:
    void showColour(const std::optional<glm::dvec3>& colour);

    QDoubleSpinBox* value_ = nullptr;
    QDoubleSpinBox* opacity_ = nullptr;
    QPushButton* colour_ = nullptr;
    std::optional<Point> shown_;
    QPointer<QColorDialog> dialog_;
};

}  // namespace macula::viewer
