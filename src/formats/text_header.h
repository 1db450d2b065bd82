// The text headers of NRRD and MetaImage files.
//
// Does not use the readers of ITK (5.2.1), which silently mirror NRRD images of the space
// left-anterior-superior, accept a damaged compressed MetaImage as complete, and open any file that a header
// names, anywhere. Nor can they be fuzzed here: Debian's ITK does not compile with clang, which libFuzzer
// needs.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/parsing.h"
#include "base/text.h"
#include "formats/raw_values.h"

namespace macula::formats {

struct TextHeader {
    RawImageLayout layout;
    ValuesInFile values;
    std::map<std::string, std::string> notes;  // NRRD: what programs add, "key:=value"
};

// inputNotUsable for images that are not a volume of scalars, for encodings other than raw and deflate, for
// values in several files or outside the folder of the header, and for a header that contradicts itself or
// the size of the file.
Result<TextHeader> readNrrdHeader(const std::filesystem::path& path);
Result<TextHeader> readMetaImageHeader(const std::filesystem::path& path);

// What both readers share.
Error headerNotUsable(Text message, Text hint = Text("Convert it with the program it comes from."));
Error headerDamaged();
// The assumption for a file without an orientation.
Text lpsAssumed();

std::vector<std::string> words(const std::string& text);

// Nothing unless the text is exactly `count` numbers.
std::optional<std::vector<double>> parseNumbers(const std::string& text, std::size_t count);

using Fields = std::map<std::string, std::string>;
std::string valueOf(const Fields& fields, const std::string& key);  // empty when absent

// The lines of a header, and the position of the next one in the file.
class HeaderLines {
  public:
    explicit HeaderLines(const std::filesystem::path& path);

    // The next line, without its line break. Nothing at the end, and for a line that is too long or has
    // control characters.
    std::optional<std::string> next();
    bool atEnd() const { return at_ >= text_.size(); }
    std::uint64_t position() const { return at_; }

  private:
    std::string text_;
    std::size_t at_ = 0;
};

Result<glm::ivec3> parseSize(const std::string& text);
// inputNotUsable unless `count` is 3.
Result<void> checkThreeAxes(const std::string& count);
// The file with the values: `name` must be a plain name in the folder of the header, and not a symbolic link.
Result<std::filesystem::path> besideHeader(const std::filesystem::path& header, const std::string& name);

}  // namespace macula::formats
