// A list of the volumes of a folder.
#pragma once

#include <QComboBox>
#include <vector>

#include "base/text.h"

namespace macula::viewer {

// Lists "1 of 3" and a name for each volume. Shows that of the open one: a choice changes it only once the
// other volume is open.
class VolumeChoice : public QComboBox {
    Q_OBJECT

  public:
    explicit VolumeChoice(QWidget* parent = nullptr);

    void setVolumes(const std::vector<Text>& titles, std::size_t shown);

  Q_SIGNALS:
    void chosen(std::size_t index);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    int shown_ = -1;
};

}  // namespace macula::viewer
