// Property lists in XML.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "model/value.hpp"

namespace inkcell::design {

/// The value of a property list file. `name` is for messages. Throws Error.
Value parse_plist(const std::string& text, const std::string& name);

/// The text of a property list file: dictionaries sorted by key, indented by
/// two spaces.
std::string write_plist(const Value& value);

/// The same for a value in another document. Throws Error.
Value read_plist_node(const pugi::xml_node& node, const std::string& name);
void write_plist_node(const Value& value, pugi::xml_node& parent);

/// An XML document. Throws Error that names the file and the line.
void parse_xml(const std::string& text,
               const std::string& name,
               pugi::xml_document& document);

/// Begins a document with its declaration.
void declare_xml(pugi::xml_document& document);

/// The text of a document, indented by two spaces.
std::string xml_text(const pugi::xml_document& document);

}  // namespace inkcell::design
