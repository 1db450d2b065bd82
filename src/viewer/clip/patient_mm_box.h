// Patient coordinates as text to read and to type.
#pragma once

#include <QDoubleSpinBox>
#include <QLocale>
#include <QString>
#include <optional>

namespace macula::viewer {

// The decimals that resolve a tenth of `stepMm`, from 1 to 6. The step is positive.
int decimalsForMm(double stepMm);

// Along an axis of patient LPS: "R 45.0" for -45 mm on axis 0. The side is a letter and never a sign, which
// other programs read the other way round.
QString patientText(int axis, double mm, int decimals, const QLocale& locale);
// Reads patientText. The letter may follow the number or be lower case, and "mm" may follow; without a letter
// the sign is that of LPS. Nothing for any other text.
std::optional<double> patientMm(int axis, const QString& text, const QLocale& locale);

// Its value is in patient LPS, mm.
class PatientMmBox : public QDoubleSpinBox {
    Q_OBJECT

  public:
    explicit PatientMmBox(int axis, QWidget* parent = nullptr);

    QString textFromValue(double mm) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;

  private:
    int axis_;
};

}  // namespace macula::viewer
