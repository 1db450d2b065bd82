// Runs the built `macula` and `macula-bench` as a person would, and a folder to do it in.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace macula::cli {

enum class TestedProgram { macula, bench };

struct Ran {
    int exitCode = -1;
    std::string out;
    std::string err;

    // Lines on stderr that begin with "macula: " or "macula-bench: ", notes and warnings left out.
    std::size_t errorLines() const;
};

// `arguments` are passed as they are, without a shell; `environment` entries are NAME=VALUE. `prepare` runs
// in the new process, before the program begins: it may close streams or set limits.
Ran runMacula(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {},
              const std::function<void()>& prepare = {});
Ran runBench(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {});
Ran run(TestedProgram program, const std::vector<std::string>& arguments);

// The same, with a signal that long after the start. One that ends before ends by itself.
Ran runSignalled(TestedProgram program, const std::vector<std::string>& arguments, int signal,
                 std::chrono::microseconds after);

// `macula` in a terminal, so that it shows its progress, and presses Ctrl-C once, as soon as what it has
// written to stderr is what `when` waits for. One that never comes so far ends by itself.
Ran runMaculaInterrupted(const std::vector<std::string>& arguments,
                         const std::function<bool(const std::string& err)>& when);

// A fresh folder for each test, removed afterwards.
class CommandTest : public ::testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    std::string at(const std::string& name) const { return (folder_ / name).string(); }
    std::string write(const std::string& name, std::string_view text) const;  // returns its path
    // A volume of 24 voxels a side, a ball of bone in water in air: where any volume does, since this one is
    // read and drawn in no time. Returns its path.
    std::string writeBall(const std::string& name = "ball.nrrd") const;
    // The phantom in voxels of 6 to 10 mm, where its shape matters and its detail does not: opened in no
    // time, too.
    std::string writeSmallPhantom(const std::string& name = "small.nrrd") const;
    std::size_t fileCount(const std::string& name = ".") const;

    std::filesystem::path folder_;
};

std::string readAll(const std::filesystem::path& path);

}  // namespace macula::cli
