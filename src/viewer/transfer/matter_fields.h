// How the matter of a preset scatters light, in numbers, to be read and typed.
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

// A row for each of app::matterParameters(). Tells what somebody wants, and shows what it is given.
class MatterFields : public QWidget {
    Q_OBJECT

  public:
    explicit MatterFields(QWidget* parent = nullptr);

    // Of the volume's values, and how those of the preset lie on them: a gradient is of the volume's.
    void setUnit(const QString& unit, int decimals, const app::ValueMap& map);
    void showMatter(const TransferFunction& function);

  signals:
    void changed(const app::MatterParameter& parameter, double value);  // of the preset, within its range
    void ended();  // of changes one after the other, the last has been told

  private:
    struct Row {
        const app::MatterParameter* parameter = nullptr;
        QDoubleSpinBox* box = nullptr;
    };
    void addRow(const app::MatterParameter& parameter);
    double scaleOf(const app::MatterParameter& parameter) const;  // of what is shown

    std::vector<Row> rows_;
    app::ValueMap map_;
};

}  // namespace macula::viewer
