#include "ufo/plist.hpp"

#include <algorithm>
#include <cstring>
#include <sstream>

#include "model/base64.hpp"
#include "model/error.hpp"
#include "ufo/numbers.hpp"

namespace inkcell::design {
namespace {

Value read_number(const pugi::xml_node& node, const std::string& name) {
  const std::string text = node.child_value();
  try {
    size_t used = 0;
    if (std::strcmp(node.name(), "integer") == 0) {
      const int64_t whole = std::stoll(text, &used);
      if (used == text.size()) {
        // The same type as in commands, so that both compare equal.
        return whole < 0 ? Value(whole) : Value(static_cast<uint64_t>(whole));
      }
    } else {
      const double real = std::stod(text, &used);
      if (used == text.size()) {
        return real;
      }
    }
  } catch (const std::exception&) {
    // the message below
  }
  throw Error(name + ": '" + text + "' is not a number");
}

Value read_dictionary(const pugi::xml_node& node, const std::string& name) {
  Value dictionary = Value::object();
  for (pugi::xml_node key = node.first_child(); key;) {
    const pugi::xml_node value = key.next_sibling();
    if (std::strcmp(key.name(), "key") != 0 || !value) {
      throw Error(name +
                  ": a dictionary of a property list has a <key> before "
                  "each value; found <" +
                  key.name() + ">");
    }
    dictionary[key.child_value()] = read_plist_node(value, name);
    key = value.next_sibling();
  }
  return dictionary;
}

void append_text(pugi::xml_node& parent,
                 const char* tag,
                 const std::string& text) {
  parent.append_child(tag)
      .append_child(pugi::node_pcdata)
      .set_value(text.c_str());
}

void write_dictionary(const Value& value, pugi::xml_node& parent) {
  pugi::xml_node dictionary = parent.append_child("dict");
  for (const auto& [key, member] : value.items()) {
    append_text(dictionary, "key", key);
    write_plist_node(member, dictionary);
  }
}

}  // namespace

Value read_plist_node(const pugi::xml_node& node, const std::string& name) {
  const std::string tag = node.name();
  if (tag == "dict") {
    return read_dictionary(node, name);
  }
  if (tag == "array") {
    Value array = Value::array();
    for (const pugi::xml_node& item : node.children()) {
      array.push_back(read_plist_node(item, name));
    }
    return array;
  }
  if (tag == "string") {
    return std::string(node.child_value());
  }
  if (tag == "integer" || tag == "real") {
    return read_number(node, name);
  }
  if (tag == "true" || tag == "false") {
    return tag == "true";
  }
  if (tag == "data") {
    return Value::binary(decode_base64(node.child_value()));
  }
  if (tag == "date") {
    const std::string text = node.child_value();
    return Value::binary({text.begin(), text.end()}, kDateSubtype);
  }
  throw Error(name + ": <" + tag + "> is no part of a property list");
}

void write_plist_node(const Value& value, pugi::xml_node& parent) {
  switch (value.type()) {
    case Value::value_t::object:
      write_dictionary(value, parent);
      break;
    case Value::value_t::array: {
      pugi::xml_node array = parent.append_child("array");
      for (const Value& item : value) {
        write_plist_node(item, array);
      }
      break;
    }
    case Value::value_t::boolean:
      parent.append_child(value.get<bool>() ? "true" : "false");
      break;
    case Value::value_t::number_integer:
    case Value::value_t::number_unsigned:
      append_text(parent, "integer", value.dump());
      break;
    case Value::value_t::number_float:
      append_text(parent, "real", to_text(value.get<double>()));
      break;
    case Value::value_t::binary: {
      const auto& bytes = value.get_binary();
      if (bytes.has_subtype()) {
        append_text(parent, "date", std::string(bytes.begin(), bytes.end()));
      } else {
        append_text(parent, "data", encode_base64(bytes));
      }
      break;
    }
    default:
      append_text(parent, "string",
                  value.is_string() ? value.get<std::string>() : "");
      break;
  }
}

void parse_xml(const std::string& text,
               const std::string& name,
               pugi::xml_document& document) {
  const pugi::xml_parse_result result =
      document.load_buffer(text.data(), text.size(),
                           pugi::parse_default | pugi::parse_ws_pcdata_single);
  if (!result) {
    const auto line =
        1 +
        std::count(text.begin(),
                   text.begin() + std::min<std::ptrdiff_t>(
                                      result.offset,
                                      static_cast<std::ptrdiff_t>(text.size())),
                   '\n');
    throw Error(name + ":" + std::to_string(line) + ": " +
                result.description());
  }
}

Value parse_plist(const std::string& text, const std::string& name) {
  pugi::xml_document document;
  parse_xml(text, name, document);
  const pugi::xml_node list = document.child("plist");
  if (!list.first_child()) {
    throw Error(name + ": is no property list");
  }
  return read_plist_node(list.first_child(), name);
}

void declare_xml(pugi::xml_document& document) {
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
}

std::string xml_text(const pugi::xml_document& document) {
  std::ostringstream out;
  document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
  return out.str();
}

std::string write_plist(const Value& value) {
  pugi::xml_document document;
  declare_xml(document);
  document.append_child(pugi::node_doctype)
      .set_value(
          "plist PUBLIC \"-//Apple//DTD PLIST 1.0//EN\" "
          "\"http://www.apple.com/DTDs/PropertyList-1.0.dtd\"");
  pugi::xml_node list = document.append_child("plist");
  list.append_attribute("version") = "1.0";
  write_plist_node(value, list);
  return xml_text(document);
}

}  // namespace inkcell::design
