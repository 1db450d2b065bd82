#include "formats/text_header.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace macula::formats {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostHeaderBytes = std::size_t{1} << 20;
constexpr std::size_t kLongestLine = std::size_t{1} << 16;

}  // namespace

Error headerNotUsable(Text message, Text hint) {
    return {ErrorCode::inputNotUsable, std::move(message), {}, std::move(hint)};
}

Error headerDamaged() {
    return headerNotUsable(Text("The header of the file is damaged."),
                           Text("Get the file again from where it came."));
}

Text lpsAssumed() {
    return Text(
        "The file does not say how the image lies in the patient: its axes were taken to lead to the "
        "patient's left, back and head. Left and right may be exchanged.");
}

std::vector<std::string> words(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> found;
    for (std::string word; stream >> word;) found.push_back(word);
    return found;
}

std::optional<std::vector<double>> parseNumbers(const std::string& text, std::size_t count) {
    std::vector<double> numbers;
    for (const std::string& word : words(text)) {
        const auto value = parseNumber<double>(word);
        if (!value) return {};
        numbers.push_back(*value);
    }
    if (numbers.size() != count) return {};
    return numbers;
}

std::string valueOf(const Fields& fields, const std::string& key) {
    const auto found = fields.find(key);
    return found == fields.end() ? std::string() : found->second;
}

HeaderLines::HeaderLines(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    text_.resize(kMostHeaderBytes);
    stream.read(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.resize(static_cast<std::size_t>(stream.gcount()));
}

std::optional<std::string> HeaderLines::next() {
    if (atEnd()) return {};
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    if (end - at_ > kLongestLine) return {};
    std::string line = text_.substr(at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; };
    if (std::any_of(line.begin(), line.end(), control)) return {};
    at_ = std::min(end + 1, text_.size());
    return line;
}

Result<glm::ivec3> parseSize(const std::string& text) {
    const auto each = words(text);
    if (each.size() != 3) return headerDamaged();
    glm::ivec3 size(0);
    for (int axis = 0; axis < 3; ++axis) {
        const auto length = parseNumber<int>(each[std::size_t(axis)]);
        if (!length || *length < 1) return headerDamaged();
        size[axis] = *length;
    }
    return size;
}

Result<void> checkThreeAxes(const std::string& count) {
    const auto axes = parseNumber<int>(count);
    if (!axes) return headerDamaged();
    if (*axes == 3) return {};
    if (*axes == 2)
        return headerNotUsable(Text("The image has two axes; it is no volume."),
                               Text("Choose a file with a volume."));
    return headerNotUsable(Text("The image has {} axes; Macula reads volumes with three.", *axes),
                           Text("Write one volume to a file of its own."));
}

Result<fs::path> besideHeader(const fs::path& header, const std::string& name) {
    // A percent sign makes the name a pattern of several files, unless a file has exactly this name.
    std::error_code notThere;
    const bool isPattern =
        name.find('%') != std::string::npos && !fs::exists(header.parent_path() / name, notThere);
    const bool plain = !name.empty() && name.find_first_of("/\\") == std::string::npos && name != "." &&
                       name != ".." && !isPattern;
    if (!plain) {
        return headerNotUsable(
            Text("The values lie in another folder or in several files."),
            Text("Write the volume to one file, or put the file with the values beside the header."));
    }
    const fs::path data = header.parent_path() / name;
    std::error_code error;
    if (!fs::is_regular_file(fs::symlink_status(data, error))) {
        return headerNotUsable(Text("The file with the values is missing."),
                               Text("Put it beside the header."));
    }
    return data;
}

}  // namespace macula::formats
