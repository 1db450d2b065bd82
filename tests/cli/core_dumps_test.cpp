// The program that a person runs leaves no copy of its memory, unless somebody asks for it.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "cli/run_command.h"

namespace macula::cli {
namespace {

// A `macula` that draws for as long as it is let.
class Drawing {
  public:
    Drawing(const std::string& output, const char* wantsDumps) : process_(fork()) {
        if (process_ != 0) return;
        rlimit limit{};
        getrlimit(RLIMIT_CORE, &limit);
        limit.rlim_cur = limit.rlim_max;
        setrlimit(RLIMIT_CORE, &limit);
        setenv("MACULA_CORE_DUMPS", wantsDumps, 1);
        execl(MACULA_BINARY, MACULA_BINARY, "render", "phantom:", "-o", output.c_str(), "--size", "64x64",
              "--spp", "1000000", nullptr);
        _exit(127);
    }
    ~Drawing() {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    // "Max core file size": the soft limit.
    std::string limit() const {
        std::ifstream limits(proc("limits"));
        for (std::string line; std::getline(limits, line);) {
            std::istringstream words(line);
            std::string max, core, file, size, soft;
            if (words >> max >> core >> file >> size >> soft && core == "core") return soft;
        }
        return {};
    }
    std::string filter() const {
        std::string filter;
        std::ifstream(proc("coredump_filter")) >> filter;
        return filter;
    }
    bool isMacula() const {
        std::string name;
        std::ifstream(proc("comm")) >> name;
        return name == "macula";
    }
    bool draws() const {  // has more than the thread that it began with
        std::ifstream status(proc("status"));
        for (std::string word; status >> word;) {
            int threads = 0;
            if (word == "Threads:" && status >> threads) return threads > 1;
        }
        return false;
    }

  private:
    std::string proc(const char* what) const { return "/proc/" + std::to_string(process_) + "/" + what; }

    pid_t process_;
};

class CoreDumpsOfTheCommand : public CommandTest {
  protected:
    static void awaitDrawing(const Drawing& drawing) {
        for (int i = 0; i < 6000 && !(drawing.isMacula() && drawing.draws()); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
};

TEST_F(CoreDumpsOfTheCommand, AreSwitchedOff) {
    const Drawing drawing(at("a.png"), "");
    awaitDrawing(drawing);
    EXPECT_EQ(drawing.limit(), "0");
    EXPECT_EQ(drawing.filter(), "00000000");
}

TEST_F(CoreDumpsOfTheCommand, StayForWhoAsksForThem) {
    const Drawing drawing(at("a.png"), "1");
    awaitDrawing(drawing);
    EXPECT_NE(drawing.filter(), "00000000");
    EXPECT_FALSE(drawing.filter().empty());
}

}  // namespace
}  // namespace macula::cli
