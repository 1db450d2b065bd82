// A folder as a reader of the library sees it: what is in it, what can be a volume, and what is said about
// it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../support.h"
#include "../synthetic.h"
#include "dicom/best_volume.h"

namespace macula::dicom::test {

class Opened {
  public:
    explicit Opened(const std::filesystem::path& path);

    // Fails the test when the scan failed; then empty.
    const Scan& scan() const { return scan_; }
    std::vector<const Series*> series() const;
    std::vector<const Stack*> stacks() const;   // of all series
    std::vector<const Stack*> volumes() const;  // those of them that can be volumes
    std::vector<OtherObject> others() const;    // wherever they are listed
    std::size_t frames() const;                 // in all stacks: nothing may get lost

    std::shared_ptr<const Volume> load(const Stack& stack) const;
    // Fails the test unless exactly one stack can be a volume.
    std::shared_ptr<const Volume> onlyVolume() const;

    // Anywhere: about the folder, a file, a series, a stack.
    const Message* find(std::string_view key) const&;
    const Message* find(std::string_view key) && = delete;
    std::vector<const Message*> messages() const;
    bool says(std::string_view key) const { return find(key) != nullptr; }
    std::string keys() const;  // to print

  private:
    Scan scan_;
};

// An argument of a message, as a number; fails the test when it is not there.
double numberArgument(const Message& message, std::string_view name);

// One volume, equal to what the series says.
void expectOnlyVolume(const Opened& opened, const SyntheticSeries& series);
// One volume for each phase, each equal to what the series says, and no frame lost.
void expectPhases(const Opened& opened, const SyntheticSeries& series);

// The same where nothing says which comes first.
void expectPhasesInAnyOrder(const Opened& opened, const SyntheticSeries& series);

class Pitfall : public ::testing::Test {
  protected:
    Opened open() const { return Opened(folder.path()); }

    TemporaryFolder folder;
    SyntheticSeries series;
};

}  // namespace macula::dicom::test
