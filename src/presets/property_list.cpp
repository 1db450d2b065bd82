#include "presets/property_list.h"

#include <nlohmann/json.hpp>

#include "base/parsing.h"
#include "presets/xml_document.h"

namespace macula::presets {

namespace {

using Json = nlohmann::json;

// XmlDocument bounds the depth of the recursion.
class Converter {
  public:
    explicit Converter(const std::string& where) : where_(where) {}

    Result<Json> value(pugi::xml_node node) const {
        const std::string_view type = node.name();
        const std::string_view text = node.child_value();
        if (type == "dict") return dict(node);
        if (type == "array") return array(node);
        if (type == "string" || type == "date" || type == "data") return Json(std::string(text));
        if (type == "true" || type == "false") return Json(type == "true");
        if (type == "real" || type == "integer") {
            const std::optional<double> number = finiteNumber(text);
            if (number) return Json(*number);
            return fail(Text("holds a number that cannot be read"));
        }
        return fail(Text("holds <{}>, which no property list does", type));
    }

  private:
    Result<Json> dict(pugi::xml_node node) const {
        Json object = Json::object();
        std::string key;
        bool haveKey = false;
        for (const pugi::xml_node child : node.children()) {
            if (child.type() != pugi::node_element) continue;
            const bool isKey = std::string_view(child.name()) == "key";
            if (isKey == haveKey) return fail(Text("has a key without a value, or a value without a key"));
            if (isKey) {
                key = child.child_value();
            } else {
                MACULA_TRY(object[key], value(child));
            }
            haveKey = isKey;
        }
        if (haveKey) return fail(Text("has a key without a value, or a value without a key"));
        return object;
    }

    Result<Json> array(pugi::xml_node node) const {
        Json list = Json::array();
        for (const pugi::xml_node child : node.children()) {
            if (child.type() != pugi::node_element) continue;
            MACULA_TRY(Json item, value(child));
            list.push_back(std::move(item));
        }
        return list;
    }

    Error fail(Text what) const {
        return Error{ErrorCode::inputNotUsable, Text("The property list {}.", std::move(what)), where_,
                     Text("Check that it is complete.")};
    }

    const std::string& where_;
};

}  // namespace

Result<Json> jsonFromPropertyList(std::string_view text, const std::string& where) {
    if (text.starts_with("bplist")) {
        return Error{ErrorCode::inputNotUsable, Text("The property list is in its binary form."), where,
                     Text("Convert it on a Mac: plutil -convert xml1 FILE.")};
    }
    MACULA_TRY(const XmlDocument document, XmlDocument::parse(text, where));
    for (const pugi::xml_node child : document.root().child("plist").children()) {
        if (child.type() == pugi::node_element) return Converter(where).value(child);
    }
    return Error{ErrorCode::inputNotUsable, Text("The file is no property list."), where,
                 Text("Check that it is complete.")};
}

}  // namespace macula::presets
