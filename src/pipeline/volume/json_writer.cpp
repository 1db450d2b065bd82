#include "pipeline/volume/json_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

namespace macula {

namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t kLine = 140;  // most characters of a list or object on one line

std::string scalarText(const Json& value) {
    if (!value.is_number_float()) return value.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value.get<double>()).ptr;
    std::string text(buffer.data(), end);
    // A floating-point number keeps its point: otherwise -0.0 would be read back as the integer 0.
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string keyText(const std::string& key) {
    return Json(key).dump(-1, ' ', false, Json::error_handler_t::replace) + ": ";
}

std::string oneLine(const Json& value) {
    if (!value.is_structured()) return scalarText(value);
    std::string inside;
    for (auto item = value.begin(); item != value.end(); ++item) {
        if (!inside.empty()) inside += ", ";
        if (value.is_object()) inside += keyText(item.key());
        inside += oneLine(*item);
    }
    if (value.is_array()) return "[" + inside + "]";
    return inside.empty() ? "{}" : "{ " + inside + " }";
}

bool staysOnOneLine(const Json& value) {
    const bool nested = std::any_of(value.begin(), value.end(), [&](const Json& item) {
        return item.is_object() ||
               (item.is_array() && std::any_of(item.begin(), item.end(),
                                               [](const Json& inner) { return inner.is_structured(); }));
    });
    return !nested && oneLine(value).size() <= kLine;
}

void write(std::string& out, const Json& value, std::size_t indent) {
    if (!value.is_structured() || staysOnOneLine(value)) {
        out += oneLine(value);
        return;
    }
    out += value.is_array() ? "[\n" : "{\n";
    for (auto item = value.begin(); item != value.end(); ++item) {
        if (item != value.begin()) out += ",\n";
        out.append(indent + 4, ' ');
        if (value.is_object()) out += keyText(item.key());
        write(out, *item, indent + 4);
    }
    out += '\n';
    out.append(indent, ' ');
    out += value.is_array() ? ']' : '}';
}

}  // namespace

std::string prettyJson(const Json& value) {
    std::string text;
    write(text, value, 0);
    return text + '\n';
}

}  // namespace macula
