#include "source/variation.hpp"

#include <hb-ot.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>

#include "base/error.hpp"

namespace inkcell::gen {
namespace {

// Shortest decimal form, as a person would write it.
std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string name_in(hb_face_t* face, hb_ot_name_id_t id) {
  char name[128];
  unsigned size = sizeof name;
  hb_ot_name_get_utf8(face, id, hb_language_from_string("en", -1), &size, name);
  return name;
}

// The significant part of an instance's name.
std::string folded(const std::string& name) {
  std::string out;
  for (const char c : name) {
    if (c != ' ' && c != '-' && c != '_') {
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return out;
}

template <typename Items, typename Show>
std::string listed(const Items& items, const Show& show) {
  std::string text;
  for (const auto& item : items) {
    text += (text.empty() ? "" : ", ") + show(item);
  }
  return text;
}

void move_to_instance(const std::string& name, Variation& variation) {
  const auto& all = variation.instances;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const NamedInstance& instance) {
        return folded(instance.name) == folded(name);
      });
  if (found == all.end()) {
    throw Error((all.empty() ? "has no named instances"
                             : "has no instance '" + name + "', but " +
                                   variation.instance_names()) +
                "; choose one, or set axes: " + variation.ranges());
  }
  for (size_t i = 0; i < variation.axes.size(); ++i) {
    variation.axes[i].value = found->values[i];
  }
}

void move_axis(const AxisSetting& setting, Variation& variation) {
  bool is_known = false;
  for (FontAxis& axis : variation.axes) {
    if (axis.tag != setting.tag) {
      continue;
    }
    is_known = true;
    if (setting.value < axis.least || setting.value > axis.most) {
      throw Error(setting.tag + "=" + shown(setting.value) +
                  " is out of range; the axes are " + variation.ranges());
    }
    axis.value = setting.value;
  }
  if (!is_known) {
    throw Error("has no axis '" + setting.tag + "'; the axes are " +
                variation.ranges());
  }
}

}  // namespace

AxisSetting parse_axis(const std::string& text) {
  const size_t equals = text.find('=');
  const std::string value =
      equals == std::string::npos ? "" : text.substr(equals + 1);
  char* end = nullptr;
  const double parsed = std::strtod(value.c_str(), &end);
  if (equals == 0 || equals > 4 || value.empty() || *end != '\0' ||
      !(std::abs(parsed) <= 32767)) {
    throw Error("'" + text + "' is not TAG=VALUE, such as wght=600");
  }
  std::string axis = text.substr(0, equals);
  axis.resize(4, ' ');
  return {axis, parsed, {}};
}

AxisSetting parse_axis_range(const std::string& text) {
  const size_t dots = text.find("..");
  if (dots == std::string::npos) {
    return parse_axis(text);
  }
  AxisSetting setting;
  try {
    setting = parse_axis(text.substr(0, dots));
    setting.second =
        parse_axis(text.substr(0, text.find('=') + 1) + text.substr(dots + 2))
            .value;
  } catch (const Error&) {
    throw Error("'" + text + "' is not TAG=FROM..TO, such as wght=300..800");
  }
  if (*setting.second == setting.value) {
    throw Error("'" + text +
                "' moves nothing: both masters are at the same place; give two "
                "values, such as wght=300..800");
  }
  return setting;
}

bool has_second_master(const AxisSettings& axes) {
  return std::any_of(axes.begin(), axes.end(), [](const AxisSetting& axis) {
    return axis.second.has_value();
  });
}

AxisSettings second_master(AxisSettings axes) {
  for (AxisSetting& axis : axes) {
    axis.value = axis.second.value_or(axis.value);
    axis.second.reset();
  }
  return axes;
}

std::string second_values(const AxisSettings& axes) {
  AxisSettings moved;
  std::copy_if(axes.begin(), axes.end(), std::back_inserter(moved),
               [](const AxisSetting& axis) { return axis.second.has_value(); });
  return listed(moved, [](const AxisSetting& axis) {
    return axis.tag + " " + shown(*axis.second);
  });
}

std::string Variation::instance() const {
  for (const NamedInstance& named : instances) {
    if (std::equal(
            axes.begin(), axes.end(), named.values.begin(),
            [](const FontAxis& axis, double at) { return axis.value == at; })) {
      return named.name;
    }
  }
  return "";
}

bool Variation::is_default() const {
  return std::all_of(axes.begin(), axes.end(), [](const FontAxis& axis) {
    return axis.value == axis.usual;
  });
}

std::string Variation::ranges() const {
  return listed(axes, [](const FontAxis& axis) {
    return axis.tag + " " + shown(axis.least) + ".." + shown(axis.most) +
           " (default " + shown(axis.usual) + ")";
  });
}

std::string Variation::place() const {
  const std::string name = instance();
  return listed(axes,
                [](const FontAxis& axis) {
                  return axis.tag + " " + shown(axis.value) + " of " +
                         shown(axis.least) + ".." + shown(axis.most);
                }) +
         (name.empty() ? "" : " (" + name + ")");
}

std::string Variation::values() const {
  return listed(axes, [](const FontAxis& axis) {
    return axis.tag + " " + shown(axis.value);
  });
}

std::string Variation::instance_names() const {
  return listed(instances,
                [](const NamedInstance& instance) { return instance.name; });
}

Variation read_variation(hb_face_t* face) {
  Variation variation;
  unsigned count = hb_ot_var_get_axis_count(face);
  std::vector<hb_ot_var_axis_info_t> infos(count);
  hb_ot_var_get_axis_infos(face, 0, &count, infos.data());
  for (const hb_ot_var_axis_info_t& info : infos) {
    std::string tag(4, ' ');
    hb_tag_to_string(info.tag, tag.data());
    variation.axes.push_back({tag, info.min_value, info.default_value,
                              info.max_value, info.default_value});
  }
  const unsigned instances = hb_ot_var_get_named_instance_count(face);
  for (unsigned i = 0; i < instances && count != 0; ++i) {
    std::vector<float> values(count);
    unsigned size = count;
    hb_ot_var_named_instance_get_design_coords(face, i, &size, values.data());
    const std::string name =
        name_in(face, hb_ot_var_named_instance_get_subfamily_name_id(face, i));
    if (!name.empty()) {
      variation.instances.push_back({name, {values.begin(), values.end()}});
    }
  }
  return variation;
}

void set_variation(const std::string& instance,
                   const std::vector<AxisSetting>& settings,
                   Variation& variation) {
  if (variation.axes.empty() && !(instance.empty() && settings.empty())) {
    throw Error("is not a variable font: leave out its instance and axes");
  }
  if (!instance.empty()) {
    move_to_instance(instance, variation);
  }
  for (const AxisSetting& setting : settings) {
    move_axis(setting, variation);
  }
}

}  // namespace inkcell::gen
