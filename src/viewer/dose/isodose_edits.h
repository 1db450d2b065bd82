// A person's edits of the isodoses in the session's state.
#pragma once

#include <QCoreApplication>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "scene/second/isodoses.h"
#include "viewer/editor/study_editor.h"

namespace macula::viewer {

// Each is one undo step. They do nothing without a second volume in the state. Needs no window.
class IsodoseEdits {
    Q_DECLARE_TR_FUNCTIONS(IsodoseEdits)

  public:
    explicit IsodoseEdits(StudyEditor& session) : session_(session) {}  // outlives this

    void show(bool areShown);
    // Keeps the doses of the lines: their numbers are converted with the value of 100 percent.
    void setInPercent(bool areInPercent, double reference);
    void setReference(std::optional<double> reference);
    void setLevel(std::size_t row, double level);
    void setColour(std::size_t row, const std::array<std::uint8_t, 3>& rgb);
    void add();  // half of the lowest level
    void remove(std::size_t row);
    void setUsual();

  private:
    void change(const std::function<void(scene::Isodoses&)>& edit);

    StudyEditor& session_;
};

}  // namespace macula::viewer
