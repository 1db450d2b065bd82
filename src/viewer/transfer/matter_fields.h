// How the matter of a preset scatters light, in numbers, and which of its two pairs of curves is edited.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QString>
#include <QWidget>
#include <string_view>
#include <vector>

#include "pipeline/volume/transfer_function.h"
#include "scene/state/parameters.h"
#include "scene/transfer/value_axis.h"

namespace macula::viewer {

// Chooses the curves for flat or for steep matter. Without curves for steep matter the choice is disabled.
// Emits edits, and shows only what it is given.
class SteepChoice : public QWidget {
    Q_OBJECT

  public:
    explicit SteepChoice(QWidget* parent = nullptr);

    // Without curves for steep matter it chooses the flat ones, and does not emit `chosen`.
    void showCurves(bool hasSteep);
    bool isSteep() const { return which_->currentIndex() == 1; }
    void chooseSteep() { which_->setCurrentIndex(1); }

  Q_SIGNALS:
    void chosen();                   // a person chose the other pair
    void steepWanted(bool isThere);  // add or remove curves for steep matter

  private:
    QComboBox* which_;
    QPushButton* steep_;
    bool hasSteep_ = false;
};

// One row for each of scene::matterParameters(). Emits edits, and shows only what it is given.
class MatterFields : public QWidget {
    Q_OBJECT

  public:
    explicit MatterFields(QWidget* parent = nullptr);

    // Unit of the volume's values, and their map from preset values: gradients are shown in volume values.
    void setUnit(const QString& unit, int decimals, const scene::ValueMap& map);
    void showMatter(const TransferFunction& function);

  Q_SIGNALS:
    void changed(const scene::MatterParameter& parameter,
                 double value);  // in preset values, within its range
    void ended();                // a series of changes has ended

  private:
    struct Row {
        const scene::MatterParameter* parameter = nullptr;
        QDoubleSpinBox* box = nullptr;
    };
    void addRow(const scene::MatterParameter& parameter);
    double scaleOf(const scene::MatterParameter& parameter) const;  // factor from preset to shown value

    std::vector<Row> rows_;
    scene::ValueMap map_;
};

}  // namespace macula::viewer
