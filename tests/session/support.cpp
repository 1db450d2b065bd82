#include "session/support.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "base/sha256.h"

namespace macula::session::test {

namespace fs = std::filesystem;

fs::path newFolder() {
    static int count = 0;
    const fs::path memory = "/dev/shm";
    const bool isThere = access(memory.c_str(), W_OK) == 0;
    const fs::path folder = (isThere ? memory : fs::temp_directory_path()) /
                            fmt::format("macula-session-{}-{}", getpid(), ++count);
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

std::string digestOf(std::string_view text) {
    return sha256Hex(text);
}

ModelKey keyOf(std::string_view volume, std::string_view transfer, std::string_view clip) {
    return {.volume = digestOf(volume),
            .trainer = 7,
            .parts = {{"transfer-function", digestOf(transfer)}, {"clip", digestOf(clip)}}};
}

std::vector<std::byte> blobOf(std::uint32_t number, std::size_t bytes) {
    std::vector<std::byte> blob(std::max<std::size_t>(bytes, 4));
    std::memcpy(blob.data(), &number, sizeof number);
    std::uint32_t state = number * 2654435761u + 1;
    for (std::size_t i = 4; i < blob.size(); ++i) {
        state = state * 1664525u + 1013904223u;
        blob[i] = static_cast<std::byte>(state >> 24);
    }
    return blob;
}

std::optional<std::uint32_t> numberOf(std::span<const std::byte> blob) {
    std::uint32_t number = 0;
    if (blob.size() < sizeof number) return {};
    std::memcpy(&number, blob.data(), sizeof number);
    if (!std::ranges::equal(blobOf(number, blob.size()), blob)) return {};
    return number;
}

std::string textOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void putText(const fs::path& file, std::string_view text) {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
}

std::vector<fs::path> filesBelow(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder));
    std::ranges::sort(files);
    return files;
}

int inChild(const std::function<int()>& work) {
    const pid_t child = fork();
    if (child == 0) _exit(work());
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int inChildOfNobody(const std::function<int()>& work) {
    return inChild([&] {
        if (geteuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) return 99;
        return work();
    });
}

int numberFromEnvironment(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::atoi(text);
}

StoreTest::StoreTest() : folder_(newFolder() / "store") {}
StoreTest::~StoreTest() {
    fs::remove_all(folder_.parent_path());
}

StoreOptions StoreTest::options() const {
    return {
        .folder = folder_, .patience = std::chrono::milliseconds(200), .nowMs = [this] { return nowMs_; }};
}

Store StoreTest::open(const StoreOptions& with) {
    return valueOf(Store::open(with));
}

OpenedVolume StoreTest::opened(std::string_view study, std::string_view series,
                               std::string_view volume) const {
    return {
        .study = studyIdentity(study), .series = seriesIdentity(study, series), .volume = digestOf(volume)};
}

}  // namespace macula::session::test
