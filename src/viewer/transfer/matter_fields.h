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

// One row for each of app::matterParameters(). Emits edits, and shows only what it is given.
class MatterFields : public QWidget {
    Q_OBJECT

  public:
    explicit MatterFields(QWidget* parent = nullptr);

    // Unit of the volume's values, and their map from preset values: gradients are shown in volume values.
    void setUnit(const QString& unit, int decimals, const app::ValueMap& map);
    void showMatter(const TransferFunction& function);

  signals:
    void changed(const app::MatterParameter& parameter, double value);  // in preset values, within its range
    void ended();                                                       // a series of changes has ended

  private:
    struct Row {
        const app::MatterParameter* parameter = nullptr;
        QDoubleSpinBox* box = nullptr;
    };
    void addRow(const app::MatterParameter& parameter);
    double scaleOf(const app::MatterParameter& parameter) const;  // factor from preset to shown value

    std::vector<Row> rows_;
    app::ValueMap map_;
};

}  // namespace macula::viewer
