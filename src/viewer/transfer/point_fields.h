// The selected point of a transfer function in numbers, to be read and typed.
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

// Tells what somebody wants, and shows what it is given.
class PointFields : public QWidget {
    Q_OBJECT

  public:
    explicit PointFields(QWidget* parent = nullptr);

    // Of the volume's values, their unit behind the number; may be empty.
    void setUnit(const QString& unit, int decimals);
    void setUnitDistance(double mm);  // what the opacity is of
    void setStep(double units);       // of the arrows beside the value

    struct Point {
        double value = 0.0;                     // of the volume
        std::optional<double> opacity = {};     // of a point of the opacity
        std::optional<glm::dvec3> colour = {};  // of a colour point, sRGB-encoded
    };
    void showPoint(const std::optional<Point>& point);  // nothing: none is selected

    // A dialog beside the window's work, for the colour that is shown; the point has it while it is chosen.
    void askColour();
    void dropDialog();  // what it was for is gone; its last colour stays

  signals:
    void valueChanged(double value);
    void opacityChanged(double opacity);
    void colourChanged(const glm::dvec3& colour);
    void ended();  // of changes one after the other, the last has been told

  private:
    void showColour(const std::optional<glm::dvec3>& colour);

    QDoubleSpinBox* value_ = nullptr;
    QDoubleSpinBox* opacity_ = nullptr;
    QPushButton* colour_ = nullptr;
    std::optional<Point> shown_;
    QPointer<QColorDialog> dialog_;
};

}  // namespace macula::viewer
