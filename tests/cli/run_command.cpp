#include "cli/run_command.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>
#include <sstream>
#include <string_view>
#include <thread>

#include "base/phantom.h"

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
        for (const std::string program : {"macula: ", "macula-bench: "}) {
            const bool isError = line.starts_with(program) && !line.starts_with(program + "note: ") &&
                                 !line.starts_with(program + "warning: ");
            count += isError ? 1 : 0;
        }
    }
    return count;
}

namespace {

struct Files {
    fs::path out;
    fs::path err;
};

Files filesOfRun() {
    static int serial = 0;
    const std::string stem =
        (fs::temp_directory_path() / fmt::format("macula-run-{}-{}", getpid(), ++serial)).string();
    return {stem + ".out", stem + ".err"};
}

int opened(const fs::path& path) {
    return open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
}

const char* fileOf(TestedProgram program) {
    return program == TestedProgram::macula ? MACULA_BINARY : MACULA_BENCH_BINARY;
}

pid_t begin(TestedProgram program, const std::vector<std::string>& arguments,
            const std::vector<std::string>& environment, int out, int err,
            const std::function<void()>& prepare = {}) {
    std::vector<std::string> words{fileOf(program)};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    const pid_t child = fork();
    if (child != 0) return child;
    for (const std::string& entry : environment) {
        const std::size_t equals = entry.find('=');
        setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
    }
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    if (prepare) prepare();
    execv(fileOf(program), argv.data());
    _exit(127);
}

int exitCodeOf(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

namespace {

Ran runToTheEnd(TestedProgram program, const std::vector<std::string>& arguments,
                const std::vector<std::string>& environment, const std::function<void()>& prepare,
                const std::function<void(pid_t)>& meanwhile) {
    const Files files = filesOfRun();
    const int out = opened(files.out);
    const int err = opened(files.err);
    const pid_t child = begin(program, arguments, environment, out, err, prepare);
    close(out);
    close(err);
    if (meanwhile) meanwhile(child);
    Ran ran{.exitCode = exitCodeOf(child), .out = readAll(files.out), .err = readAll(files.err)};
    fs::remove(files.out);
    fs::remove(files.err);
    return ran;
}

}  // namespace

Ran runMacula(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
              const std::function<void()>& prepare) {
    return runToTheEnd(TestedProgram::macula, arguments, environment, prepare, {});
}

Ran runBench(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
    return runToTheEnd(TestedProgram::bench, arguments, environment, {}, {});
}

Ran run(TestedProgram program, const std::vector<std::string>& arguments) {
    return runToTheEnd(program, arguments, {}, {}, {});
}

Ran runSignalled(TestedProgram program, const std::vector<std::string>& arguments, int signal,
                 std::chrono::microseconds after) {
    return runToTheEnd(program, arguments, {}, {}, [&](pid_t child) {
        std::this_thread::sleep_for(after);
        kill(child, signal);  // not waited for yet: the number is still its own
    });
}

Ran runMaculaInterrupted(const std::vector<std::string>& arguments,
                         const std::function<bool(const std::string& err)>& when) {
    const Files files = filesOfRun();
    const int screen = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (screen < 0 || grantpt(screen) != 0 || unlockpt(screen) != 0) {
        ADD_FAILURE() << "there is no terminal";
        return {};
    }
    const int out = opened(files.out);
    const int err = open(ptsname(screen), O_RDWR | O_NOCTTY | O_CLOEXEC);
    const pid_t child = begin(TestedProgram::macula, arguments, {}, out, err);
    close(out);
    close(err);
    Ran ran;
    std::vector<char> read(4096);
    bool isPressed = false;
    // The end is an error: nobody has the terminal any more.
    for (ssize_t count = 0; (count = ::read(screen, read.data(), read.size())) > 0;) {
        ran.err.append(read.data(), std::size_t(count));
        if (isPressed || !when(ran.err)) continue;
        kill(child, SIGINT);  // not waited for yet: the number is still its own
        isPressed = true;
    }
    close(screen);
    ran.exitCode = exitCodeOf(child);
    ran.out = readAll(files.out);
    fs::remove(files.out);
    return ran;
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

namespace {

// `header` names sizes and space; the values are in HU.
std::string nrrdOf(std::string_view header, std::span<const std::int16_t> hu) {
    std::string text = fmt::format(
        "NRRD0004\ntype: int16\ndimension: 3\nspace: left-posterior-superior\n{}encoding: raw\n"
        "endian: little\nMaculaValues:=Macula|int16|HU|CT\n\n",
        header);
    for (const std::int16_t value : hu)
        text += {static_cast<char>(value & 0xff), static_cast<char>(value >> 8)};
    return text;
}

}  // namespace

std::string CommandTest::writeBall(const std::string& name) const {
    constexpr int kSide = 24;
    std::vector<std::int16_t> hu;
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
        const auto from = [&](int index) { return 2 * index + 1 - kSide; };
        const int x = from(i % kSide);
        const int y = from(i / kSide % kSide);
        const int z = from(i / kSide / kSide);
        const int squared = x * x + y * y + z * z;
        hu.push_back(static_cast<std::int16_t>(squared < 100 ? 1000 : squared < 400 ? 0 : -1000));
    }
    return write(name, nrrdOf("sizes: 24 24 24\nspace directions: (4,0,0) (0,4,0) (0,0,4)\n"
                              "space origin: (-46,-46,-46)\n",
                              hu));
}

std::string CommandTest::writeSmallPhantom(const std::string& name) const {
    const Volume small = phantom::make({.size = {48, 42, 30}, .spacingMm = {6.4, 6.4, 10.0}});
    const glm::ivec3 size = small.size();
    std::vector<std::int16_t> hu;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) hu.push_back(static_cast<std::int16_t>(small.value(x, y, z)));
        }
    }
    const auto column = [&](int axis) {
        const glm::dvec4& of = small.worldFromVoxel()[axis];
        return fmt::format("({},{},{})", of.x, of.y, of.z);
    };
    return write(name, nrrdOf(fmt::format("sizes: {} {} {}\nspace directions: {} {} {}\nspace origin: {}\n",
                                          size.x, size.y, size.z, column(0), column(1), column(2), column(3)),
                              hu));
}

std::size_t CommandTest::fileCount(const std::string& name) const {
    return static_cast<std::size_t>(
        std::distance(fs::recursive_directory_iterator(folder_ / name), fs::recursive_directory_iterator()));
}

}  // namespace macula::cli
