// Number fields for how the matter of a preset scatters light.
#pragma once

#include <QDoubleSpinBox>
#include <QString>
#include <QWidget>
#include <string_view>
#include <vector>

#include "pipeline/volume/transfer_function.h"
#include "scene/state/parameters.h"
#include "scene/transfer/value_axis.h"

namespace macula::viewer {

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
