// The list of presets in the tool bar.
#pragma once

#include <QComboBox>
#include <QString>
#include <optional>
#include <vector>

#include "viewer/presets/preset_library.h"

namespace macula::viewer {

// Those of one's own and those that are made for the volume. The others are in the menu and the gallery; here
// one of them is seen only when it was chosen there. Tool tips of entries are the names that --preset takes.
class PresetBox : public QComboBox {
    Q_OBJECT

  public:
    explicit PresetBox(const PresetLibrary& library, QWidget* parent = nullptr);

    void fillAnew();  // as the library is now; nothing is chosen
    // Tells nobody. What is in no list, as it was edited, is named.
    void choose(const TransferFunction* function);

  signals:
    void chosen(const macula::viewer::LibraryPreset& preset);  // by a person

  private:
    void add(const LibraryPreset& preset, bool isOffered);
    void addLine();

    const PresetLibrary& library_;
    std::vector<std::optional<LibraryPreset>> rows_;  // nothing: a line between groups
};

}  // namespace macula::viewer
