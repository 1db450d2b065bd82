// XML from untrusted files. The parser (pugixml) reads no external entities and expands none that a file
// declares; files that declare entities are refused nevertheless, because their content could not be read.
#pragma once

#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace macula::presets {

class XmlDocument {
  public:
    // Several root elements are allowed: MITK writes two. Fails with inputNotUsable if the text is not XML
    // (with the line), declares entities, has no element, or is nested more than 64 deep.
    static Result<XmlDocument> parse(std::string_view text, const std::string& where);

    // Its children are the root elements. Lives as long as this.
    pugi::xml_node root() const { return *document_; }

  private:
    std::unique_ptr<pugi::xml_document> document_ = std::make_unique<pugi::xml_document>();
};

}  // namespace macula::presets
