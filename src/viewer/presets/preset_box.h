// The list of presets in the tool bar.
#pragma once

#include <QComboBox>
#include <QString>
#include <optional>
#include <vector>

#include "viewer/presets/preset_library.h"

namespace macula::viewer {

// Lists the person's own presets and the built-in ones that fit the volume. Others are in the menu and the
// gallery; the box shows one only after it was chosen there. Tool tips are the names that --preset takes.
class PresetBox : public QComboBox {
    Q_OBJECT

  public:
    explicit PresetBox(const PresetLibrary& library, QWidget* parent = nullptr);

    void fillAnew();  // lists the library again; chooses nothing
    // Does not emit chosen. Shows the title of an edited preset, which no entry has.
    void choose(const TransferFunction* function);

  Q_SIGNALS:
    void chosen(const macula::viewer::LibraryPreset& preset);  // by a person

  private:
    void add(const LibraryPreset& preset, bool isOffered);
    void addLine();

    const PresetLibrary& library_;
    std::vector<std::optional<LibraryPreset>> rows_;  // nothing: a line between groups
};

}  // namespace macula::viewer
