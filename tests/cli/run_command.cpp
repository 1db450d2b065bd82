#include "cli/run_command.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <thread>

namespace macula::cli {

namespace fs = std::filesystem;

std::string readAll(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t Ran::errorLines() const {
    std::istringstream lines(err);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line);) {
        count += line.starts_with("macula: ") && !line.starts_with("macula: note: ") ? 1 : 0;
    }
    return count;
}

namespace {

// `interrupt`: when to send SIGINT, if at all.
Ran runOnce(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
            std::optional<std::chrono::milliseconds> interrupt) {
    static int serial = 0;
    const fs::path stem = fs::temp_directory_path() / fmt::format("macula-run-{}-{}", getpid(), ++serial);
    const std::string out = stem.string() + ".out";
    const std::string err = stem.string() + ".err";

    std::vector<std::string> words{MACULA_BINARY};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    const pid_t child = fork();
    if (child == 0) {
        for (const std::string& entry : environment) {
            const std::size_t equals = entry.find('=');
            setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
        }
        dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
        dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
        execv(MACULA_BINARY, argv.data());
        _exit(127);
    }
    if (interrupt) {
        std::this_thread::sleep_for(*interrupt);
        kill(child, SIGINT);  // not waited for yet: the number is still its own
    }
    int status = 0;
    waitpid(child, &status, 0);
    Ran ran{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), readAll(out), readAll(err)};
    fs::remove(out);
    fs::remove(err);
    return ran;
}

}  // namespace

Ran runMacula(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
    return runOnce(arguments, environment, {});
}

Ran runMaculaInterrupted(const std::vector<std::string>& arguments, std::chrono::milliseconds after) {
    return runOnce(arguments, {}, after);
}

void CommandTest::SetUp() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / fmt::format("macula-cli-{}-{}", getpid(), test->name());
    fs::create_directories(folder_);
}

void CommandTest::TearDown() {
    fs::remove_all(folder_);
}

std::string CommandTest::write(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return at(name);
}

std::size_t CommandTest::fileCount(const std::string& name) const {
    return static_cast<std::size_t>(
        std::distance(fs::recursive_directory_iterator(folder_ / name), fs::recursive_directory_iterator()));
}

}  // namespace macula::cli
