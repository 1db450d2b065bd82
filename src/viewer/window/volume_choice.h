// Which volume of a folder is shown, and which others there are.
#pragma once

#include <QComboBox>
#include <string>
#include <vector>

namespace macula::viewer {

// A list that says "1 of 3" and names each. Empty, and not to be seen, where there is nothing to choose from.
// It names what is open: a choice changes it only once the other volume is.
class VolumeChoice : public QComboBox {
    Q_OBJECT

  public:
    explicit VolumeChoice(QWidget* parent = nullptr);

    void setVolumes(const std::vector<std::string>& titles, std::size_t shown);

  signals:
    void chosen(std::size_t index);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    int shown_ = -1;
};

}  // namespace macula::viewer
